#include "reports/linear_warnings.h"

#include <algorithm>

#include "cases/contract/linear_limits.h"
#include "reports/number.h"

namespace mb {

std::vector<std::string> linear_warnings(const std::vector<Record>& records, const Scene& scene) {
  std::vector<std::string> warnings;
  for (const Record& record : records) {
    if (record.case_name != scene.name || record.profile != scene.profile || record.status != "ok") continue;
    const bool strain = record.metric == "truth-strain", rotation = record.metric == "truth-rotation";
    const double limit = strain ? strain_limit : rotation_limit;
    const double bar = record.error_bar.value_or(0);
    if ((!strain && !rotation) || !(record.value + bar > limit)) continue;
    const auto body = std::ranges::find(scene.bodies, record.subject, &Body::name);
    const bool finite = body != scene.bodies.end() && body->kinematics == Kinematics::finite;
    warnings.push_back(record.subject + ": " + (strain ? "strain " : "rotation ") + format_setting(record.value) +
                       (bar > 0 ? " +- " + format_number(bar, 2) : "") + (strain ? "" : " rad") +
                       (record.value > limit ? " is beyond " : " may be beyond ") + format_setting(limit) +
                       (strain ? ", " : " rad, ") + "where linear theory is off by a per cent and more: " +
                       (finite ? "the truth is finite, what is reduced is not"
                               : "no bar of a linear truth holds that error; kinematics = \"finite\" would"));
  }
  std::ranges::sort(warnings);
  return warnings;
}

}  // namespace mb
