#include "reports/warnings.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "reports/energy_warnings.h"
#include "reports/linear_warnings.h"
#include "reports/runs.h"

namespace mb {

namespace {

// Answers whose steps may be past their limit.
std::vector<std::string> growth_warnings(const std::vector<Record>& records, const Scene& scene) {
  std::set<std::string> warnings;
  for (const Record& record : records)
    if (record.case_name == scene.name && record.profile == scene.profile && record.status == "ok" &&
        is_growth_unknown(record))
      warnings.insert(describe(record.contender) +
                      ": whether its steps are past their limit was looked for in vain; compare it with shorter ones");
  return {warnings.begin(), warnings.end()};
}

}  // namespace

std::vector<std::string> warnings(const std::vector<Record>& records, const Scene& scene) {
  std::vector<std::string> all = linear_warnings(records, scene);
  std::ranges::move(energy_warnings(records, scene), std::back_inserter(all));
  std::ranges::move(growth_warnings(records, scene), std::back_inserter(all));
  return all;
}

}  // namespace mb
