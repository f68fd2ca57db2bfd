#include "harness/study/instability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/contract/status.h"

namespace mb {
namespace {

constexpr double blown_up = 1e3;  // [-] error of a finite answer that has left the truth behind
// [-] of free vibration over the run, by theory: what small answers of so unstable steps show is how little was there
// to grow. Below it steps past their limit may be accurate: undamped explicit Euler's all are past it.
constexpr double much = 10;
constexpr double most_fed = 1;  // [-] as much again as there was: steps within their limit gain some per cents

// An answer at rest would be nearer.
bool is_lost(const Record& r) {
  return (r.metric == "displacement-error" || r.metric == "strain-error") && r.value > 1;
}

bool blew_up(const Record& r) {
  return r.status == "not_finite" || (r.metric == "displacement-error" && r.value > blown_up);
}

}  // namespace

Limit kept_limit(const std::vector<Record>& marks, const Integrator& integrator, const Grown& grown, double fed) {
  if (fed > most_fed) return Limit::passed;
  if (!integrator.conditionally_stable) return Limit::kept;
  if (std::ranges::any_of(marks, &blew_up)) return Limit::passed;
  if (!(grown.by_theory > much)) return Limit::kept;
  if (std::ranges::any_of(marks, &is_lost)) return Limit::passed;
  return grown.about_rest ? Limit::kept : Limit::passed_by_theory;
}

void name_unstable(std::vector<Record>& marks, Limit limit) {
  for (Record& record : marks) {
    record.status = limit == Limit::passed ? unstable : unstable_by_theory;
    record.value = std::numeric_limits<double>::quiet_NaN();
    record.error_bar.reset();
  }
}

void name_unknown(std::vector<Record>& marks) {
  for (Record& record : marks) record.provenance["growth"] = "unknown";
}

}  // namespace mb
