#include "harness/analysis/first_impact.h"

#include <cmath>
#include <limits>

#include "harness/analysis/modal_body.h"
#include "harness/metrics/contact_metrics.h"

namespace mb {

FirstImpact first_impact(const Trajectory& answer, const Trajectory& truth) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto contact = first_contact(answer.bodies.front().contact.touches, truth.bodies.front().contact.touches);
  if (answer.status != Status::ok || !contact) return {nan, nan, nan, nan};
  const Touch& touch = contact->whole;
  const double duration = touch.end - touch.start;
  return {touch.start, std::isfinite(duration) ? duration : nan, touch.peak_force, touch.impulse.norm()};
}

double mesh_bar(const AnalysisContext& context, double FirstImpact::*part) {
  const TruthSet& truth = context.truth;
  const double own = first_impact(truth.same_mesh, truth.finer).*part;
  const double off = std::abs(own / (first_impact(truth.finer, truth.finer).*part) - 1);
  const double bar = own_bars_per_distance(*context.scene, truth).mean * off;
  return std::isnan(bar) ? std::numeric_limits<double>::infinity() : bar;
}

}  // namespace mb
