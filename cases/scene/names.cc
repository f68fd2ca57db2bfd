#include "cases/scene/names.h"

#include <fmt/format.h>

#include <algorithm>

namespace mb {

void Names::add(Section& section, const std::optional<std::string>& name) {
  if (!name || names_.insert(*name).second) return;
  section.error("name", fmt::format("there is another {} named '{}'", kind_, *name));
}

std::optional<std::string> read_reference(Section& section, const std::string& key,
                                          const std::vector<std::optional<std::string>>& names, const std::string& one,
                                          const std::string& many) {
  const bool all_named = std::all_of(names.begin(), names.end(), [](const auto& name) { return name.has_value(); });
  if (!all_named && section.has(key)) return std::nullopt;
  Words words{{}, one, many};
  for (const auto& name : names) {
    if (name) words.known.push_back(*name);
  }
  return section.choice(key, words);
}

}  // namespace mb
