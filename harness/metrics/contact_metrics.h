// Marks of contacts: of the first contact between a body and its obstacles, and of what ought to be conserved. After a
// second impact motions are ill-conditioned: only the first is marked.
//
// A reduced model that lacks the local compliance chatters: its force falls to zero and comes back, several touches in
// the place of one, and ever others as the step changes. Its first contact is therefore, t_0 and t_1 the start and end
// of the truth's own first touch,
//
//   the first touch, and all that begin before t_1 + (t_1 - t_0)/2; all of them where the truth's lasts (t_1 infinite)
//
// by one rule for the answer and for the truth, which may chatter, too.
#pragma once

#include <optional>

#include "harness/metrics/metric.h"

namespace mb {

std::vector<Metric> contact_metrics();  // part of metric_catalogue()

struct FirstContact {
  // From the first start to the last end (infinity while it lasts), its largest peak, the sum of the impulses.
  Touch whole;
  int n_touches;  // >= 1
};
// touches: ascending, of an answer or of the truth itself. None where one of the two never touches.
std::optional<FirstContact> first_contact(const std::vector<Touch>& touches, const std::vector<Touch>& truth);

// Rebound by approach speed of the centroid along the impulse of a touch, free bodies alone:
//   e = -(v + J/m + g (end - start)) . j / (v . j),   j = J/|J|,   v the velocity at the start
// of two free bodies v and J/m those of one against the other, and of a ball that strikes the body, which feels -J:
//   e = |J|/(m v) - 1,   m and v of the ball
// NaN while the touch lasts. m of a body is that of its shape: a mesh that lacks volume rebounds faster.
double restitution(const Scene& scene, const Body& body, const Touch& touch);

// Energy that nothing brought: max_t E(t) - E(0) of the answer, E kinetic, elastic, of the weight and stored in
// contacts of all bodies, by what the truth brought to the contact, max(m v^2/2 at the first touch, stored there, work
// of the weight). Dissipation only lowers E: above 0 is an error of the steps. NaN where loads or moving supports bring
// energy, or it was not recorded.
double energy_fed(const Trajectory& answer, const Trajectory& truth, const MetricContext& context);

}  // namespace mb
