#include "reports/energy_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/runs.h"

namespace mb {

namespace {

constexpr double trusted = 0.1;  // [-] steps well within their limit gain some per cents at most

}  // namespace

std::vector<std::string> energy_warnings(const std::vector<Record>& records, const Scene& scene) {
  std::vector<std::string> warnings;
  for (const Record& record : records) {
    if (record.case_name != scene.name || record.profile != scene.profile || record.status != "ok") continue;
    if (record.metric != "energy-gain" || !(record.value > trusted)) continue;
    warnings.push_back(fmt::format("{} gains {:.3g} % of the energy in play from nothing: shorten its step",
                                   describe(record.contender), 100 * record.value));
  }
  std::ranges::sort(warnings);
  warnings.erase(std::unique(warnings.begin(), warnings.end()), warnings.end());
  return warnings;
}

}  // namespace mb
