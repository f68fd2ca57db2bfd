#include "harness/analysis/first_impact.h"

#include <cmath>
#include <limits>

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

}  // namespace mb
