#include "harness/callgrind_dump.h"

#include <charconv>
#include <cstdint>

namespace mb {

namespace {

constexpr std::string_view name_key = "desc: Trigger: Client Request: ", total_key = "totals: ";

DumpedCount with_total(std::string name, std::string_view text) {
  std::uint64_t total = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, total);
  const bool is_whole = error == std::errc() && (rest == end || *rest == ' ');  // of further events after a blank
  if (!is_whole) return {std::move(name), 0, "the total of a dump of valgrind is no whole number below 2^64"};
  return {std::move(name), static_cast<double>(total), ""};
}

}  // namespace

DumpedCount dumped_count(std::string_view dump) {
  std::string name;
  for (std::size_t end = dump.find('\n'); end != dump.npos; end = dump.find('\n')) {  // a line without end is cut off
    const std::string_view line = dump.substr(0, end);
    if (name.empty() && line.starts_with(name_key)) name = line.substr(name_key.size());
    if (!name.empty() && line.starts_with(total_key)) return with_total(name, line.substr(total_key.size()));
    dump.remove_prefix(end + 1);
  }
  const bool is_cut_off = !name.empty();
  return {std::move(name), 0, is_cut_off ? "a dump of valgrind ends before its total" : ""};
}

}  // namespace mb
