// Marks of contacts: of the first touch between a body and its obstacles, and of what ought to be conserved. After a
// second impact motions are ill-conditioned: only the first is marked.
#pragma once

#include "harness/metrics/metric.h"

namespace mb {

std::vector<Metric> contact_metrics();  // part of metric_catalogue()

// Rebound by approach speed of the centroid along the impulse of a touch, free bodies alone:
//   e = -(v + J/m + g (end - start)) . j / (v . j),   j = J/|J|,   v the velocity at the start
// and of a ball that strikes the body, which feels -J:   e = |J|/(m v) - 1,   m and v of the ball
double restitution(const Scene& scene, const Body& body, const Touch& touch);

}  // namespace mb
