// Files that are read line by line, the list of a report's files and dumps of callgrind: whatever the bytes, the list
// names files of a report alone and is read back the same, and a dump has a whole number, or none and a sentence.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "harness/callgrind_dump.h"
#include "reports/listed_files.h"

namespace {

using namespace mb;

void require(bool holds, const char* property) {
  if (!holds) throw std::logic_error(property);
}

// As a path of the file system: what is removed for it is one file of a report, next to others of its folder.
void require_file_of_a_report(const std::string& text) {
  const std::filesystem::path path = text;
  const auto is_plain = [](char c) { return std::string_view("/._-").find(c) != std::string_view::npos; };
  require(std::ranges::all_of(text, [&](char c) { return (c > 0 && std::isalnum(c)) || is_plain(c); }),
          "a name with other characters than a report's");
  require(path.is_relative() && path.lexically_normal() == path && path.generic_string() == text,
          "a path that leads elsewhere");
  const std::string folder = path.parent_path().string(), ending = path.extension().string();
  require(!path.stem().empty() && !path.stem().string().starts_with('.'), "a hidden file");
  if (folder == "data") return require(ending == ".csv" || ending == ".jsonl" || ending == ".txt", "no data");
  if (folder == "tables") return require(ending == ".tex", "no table");
  if (folder == "figures") return require(ending == ".json" && path.stem().extension() == ".vl", "no figure");
  require(folder.empty() && (text == "report.md" || text == "report.html" || text == "verification.md"), "no page");
}

void try_list(std::string_view text) {
  const auto files = listed_files(text);
  std::string list;
  for (const std::string& file : files) {
    require_file_of_a_report(file);
    require(text.find(file) != text.npos, "a file that was not listed");
    list += file + "\n";
  }
  require(listed_files(list) == files, "written and read, other files");
}

// In the place of a number that overflows, or that is cut off with the rest, there is none.
void require_count(const DumpedCount& count, std::string_view dump) {
  require(count.instructions >= 0 && count.instructions <= std::ldexp(1., 64) &&
              count.instructions == std::floor(count.instructions),
          "a count of no whole number");
  require(count.name.find('\n') == std::string::npos && dump.find(count.name) != dump.npos, "a name of no line");
  if (count.problem.empty()) return;
  require(std::ranges::all_of(count.problem, [](char c) { return c >= ' ' && c <= '~'; }),
          "told with text of the dump");
  require(count.instructions == 0 && !count.name.empty(), "a count beside a problem, or a problem that is nobody's");
}

void try_dump(std::string_view text) {
  const DumpedCount whole = dumped_count(text);
  require_count(whole, text);
  const bool has_count = whole.problem.empty() && !whole.name.empty();
  constexpr std::size_t n_near = 30;  // cuts within the last line, where that is the total's; some before
  for (std::size_t cut = 1; cut <= text.size(); cut += cut < n_near ? 1 : n_near) {
    const std::string_view part = text.substr(0, text.size() - cut);
    const DumpedCount count = dumped_count(part);
    require_count(count, part);
    if (count.name.empty() || !count.problem.empty()) continue;
    require(has_count && count.name == whole.name && count.instructions == whole.instructions,
            "cut off, another count");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try_list(text);
  try_dump(text);
  return 0;
}
