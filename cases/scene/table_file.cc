#include "cases/scene/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>

#include "cases/scene/diagnostics.h"

namespace mb {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20;

// The file's canonical path, or nothing where it leaves the folder, by `..`, as an absolute path or by a link.
std::optional<fs::path> below(const fs::path& folder, const fs::path& path) {
  std::error_code failed;
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) return std::nullopt;
  const fs::path root = fs::canonical(folder.empty() ? "." : folder, failed);
  if (failed) return std::nullopt;
  const fs::path file = fs::weakly_canonical(root / path, failed);
  if (failed) return std::nullopt;
  const auto [end_of_root, rest] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  return end_of_root == root.end() && rest != file.end() ? std::optional(file) : std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  const auto start = text.find_first_not_of(" \t\r");
  if (start == std::string_view::npos) return {};
  return text.substr(start, text.find_last_not_of(" \t\r") - start + 1);
}

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double x = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), x);
  return failed == std::errc() && end == text.data() + text.size() ? std::optional(x) : std::nullopt;
}

// A line of words: no digit, and nothing that is a number without one, as nan and inf.
bool is_header(std::string_view line) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return std::ranges::none_of(line, is_digit) && !number(line.substr(0, line.find(',')));
}

}  // namespace

FileText read_text_file(const fs::path& file, std::size_t most) {
  std::error_code failed;
  const auto status = fs::status(file, failed);
  if (!fs::exists(status)) return {"", "there is no such file"};
  if (fs::is_directory(status)) return {"", "it is a directory"};
  if (!fs::is_regular_file(status)) return {"", "it is no regular file"};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {"", "it cannot be opened"};
  std::string text(most + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) return {"", "it cannot be read"};
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most) return {"", fmt::format("it is larger than {} bytes", most)};
  return {std::move(text), ""};
}

TableFile read_table_file(const fs::path& folder, const std::string& path, std::size_t most_entries) {
  const std::string shown = printable(path, 255);
  if (shown != path) return {{}, {}, fmt::format("'{}' holds characters that do not print", shown)};
  const auto file = below(folder, path);
  if (!file) return {{}, {}, fmt::format("'{}' does not lie below the case's folder", shown)};
  const FileText content = read_text_file(*file, most_bytes);
  if (!content.problem.empty()) return {{}, {}, fmt::format("'{}': {}", shown, content.problem)};
  return table_of_text(content.text, shown, most_entries);
}

TableFile table_of_text(std::string_view rest, const std::string& shown, std::size_t most_entries) {
  Table table;
  std::vector<int> lines;
  int n_lines = 0;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // as editors mark UTF-8
  if (!rest.empty() && !rest.ends_with('\n'))  // its last number may be the beginning of one
    return {{}, {}, fmt::format("'{}' does not end with a line break: it may be cut", shown)};
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++n_lines;
    if (line.empty() || line.starts_with('#') || (table.t.empty() && is_header(line))) continue;
    const std::size_t comma = std::min(line.find(','), line.size());
    const auto t = number(line.substr(0, comma));
    const auto s = number(line.substr(std::min(comma + 1, line.size())));
    if (!t || !s) return {{}, {}, fmt::format("line {} of '{}' is not 't, s', two numbers", n_lines, shown)};
    table.t.push_back(*t);
    table.s.push_back(*s);
    lines.push_back(n_lines);
    if (table.t.size() > most_entries)
      return {{}, {}, fmt::format("'{}' has more than {} entries", shown, most_entries)};
  }
  if (table.t.size() < 2) return {{}, {}, fmt::format("'{}' has {} entries: at least 2", shown, table.t.size())};
  return {std::move(table), std::move(lines), ""};
}

}  // namespace mb
