// Tables in files of their own: whatever the bytes, they are a table of the size that is allowed, which is written and
// read back the same, or refused in a sentence that shows nothing of them.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cases/scene/table_file.h"

namespace {

using namespace mb;

constexpr std::size_t most = 50;  // entries

void require(bool holds, const char* property) {
  if (!holds) throw std::logic_error(property);
}

// Of sentences of our own the digits alone, of lines and entries, depend on the file.
void require_sentence(std::string text) {
  std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
  require(text == "line  of 'FILE' is not 't, s', two numbers" || text == "'FILE' has more than  entries" ||
              text == "'FILE' has  entries: at least " ||
              text == "'FILE' does not end with a line break: it may be cut",
          "a message that is none of ours");
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

void require_table_or_sentence(std::string_view bytes) {
  const auto [table, lines, problem] = table_of_text(bytes, "FILE", most);
  if (!problem.empty()) return require_sentence(problem);
  require(table.t.size() == table.s.size() && table.t.size() >= 2 && table.t.size() <= most, "a table of another size");
  require(lines.size() == table.t.size() && std::ranges::adjacent_find(lines, std::greater_equal{}) == lines.end(),
          "entries on lines that do not ascend");
  std::string text;
  for (std::size_t i = 0; i < table.t.size(); ++i) {
    if (!std::isfinite(table.t[i]) || !std::isfinite(table.s[i])) return;  // whose range the history checks
    text += fmt::format("{},{}\n", table.t[i], table.s[i]);
  }
  const TableFile again = table_of_text(text, "FILE", most);
  require(again.problem.empty() && same(again.table.t, table.t) && same(again.table.s, table.s),
          "written and read, another table");
  text.pop_back();
  require(!table_of_text(text, "FILE", most).problem.empty(), "cut, still a table");
}

}  // namespace

// As they are and as lines that end, since few bytes end in a line break and the others are refused before they are
// read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  require_table_or_sentence(bytes);
  require_table_or_sentence(bytes + '\n');
  return 0;
}
