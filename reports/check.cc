// A check holds when the measured value satisfies its bound; it is not decidable where the bound lies below the error
// bar of the value and the two are closer than that bar.
#include <cmath>

#include "reports/content.h"
#include "reports/runs.h"

namespace mb {
namespace {

double bound(const Check& check) { return check.at_most ? *check.at_most : check.at_least.value_or(0); }

// [unit of the metric] how far inside its bound a value lies; negative: outside.
double margin(const Check& check, double value) { return check.at_most ? bound(check) - value : value - bound(check); }

CheckResult judge(const Scene& scene, const Check& check, const std::vector<const Record*>& answers) {
  CheckResult result{.case_name = scene.name, .check = check};
  if (answers.empty()) result.status = "no record";
  for (const Record* answer : answers) {
    if (!is_usable(*answer)) {  // one failed part fails the whole check
      CheckResult failed{.case_name = scene.name, .check = check};
      failed.status = reason(*answer);
      return failed;
    }
    const bool worst = !result.measured || margin(check, answer->value) < margin(check, result.value);
    if (!worst) continue;
    result.measured = true;
    result.value = answer->value;
    result.error_bar = answer->error_bar.value_or(0);
  }
  if (!result.measured) return result;
  const double inside = margin(check, result.value);
  result.decidable = bound(check) >= result.error_bar || std::abs(inside) > result.error_bar;
  result.holds = result.decidable && inside >= 0;
  return result;
}

}  // namespace

std::vector<CheckResult> check_results(const std::vector<Scene>& scenes, const std::vector<Record>& records) {
  const std::vector<Run> runs = group_runs(records);
  std::vector<CheckResult> results;
  for (const Scene& scene : scenes) {
    for (const Check& check : scene.checks) {
      std::vector<const Record*> answers;
      for (const Run& run : runs) {
        const bool asked = run.case_name == scene.name && run.profile == scene.profile &&
                           run.contender.method == check.method && run.contender.settings.modes == check.modes;
        if (!asked) continue;
        for (const auto& [measure, record] : run.measures) {
          if (measure.metric == check.metric && measure.truth == check.truth) answers.push_back(&record);
        }
      }
      results.push_back(judge(scene, check, answers));
    }
  }
  return results;
}

}  // namespace mb
