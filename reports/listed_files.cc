#include "reports/listed_files.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::string_view pages[] = {"report.md", "report.html", "verification.md"};

struct Kind {
  std::string_view folder, ending;
};
constexpr Kind kinds[] = {
    {"data/", ".csv"}, {"data/", ".jsonl"}, {"data/", ".txt"}, {"tables/", ".tex"}, {"figures/", ".vl.json"}};

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

bool is_of(std::string_view path, const Kind& kind) {
  if (!path.starts_with(kind.folder)) return false;
  path.remove_prefix(kind.folder.size());
  if (!path.ends_with(kind.ending)) return false;
  path.remove_suffix(kind.ending.size());
  return !path.empty() && std::ranges::all_of(path, is_plain);
}

bool may_be_of_a_report(std::string_view path) {
  return std::ranges::find(pages, path) != std::end(pages) ||
         std::ranges::any_of(kinds, [path](const Kind& kind) { return is_of(path, kind); });
}

}  // namespace

std::set<std::string> listed_files(std::string_view list) {
  std::set<std::string> files;
  while (!list.empty()) {
    const std::string_view line = list.substr(0, list.find('\n'));
    if (may_be_of_a_report(line)) files.emplace(line);
    list.remove_prefix(std::min(line.size() + 1, list.size()));
  }
  return files;
}

}  // namespace mb
