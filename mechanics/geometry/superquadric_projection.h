// The point of a convex superquadric nearest to a point x outside, by monotone equations in one unknown each. With the
// ratios of superquadric_chart.h, y = x - lambda grad N(y) reads
//
//   a1 u + (alpha/a1) u^(p-1) = x,   a2 v + (alpha/a2) v^(p-1) = y,   a3 w + (lambda/a3) w^(q-1) = z,
//   alpha = lambda r^(q-p),   r = |(u, v)|_p,   |(r, w)|_q = 1
//
// In turn: u, v, w rise with x, y, z; alpha r^(p-1) rises and r falls with alpha; |(r, w)|_q falls with lambda. All in
// logarithms, in which nothing over- or underflows. Slow (1e-4 s) and safe.
#pragma once

#include "mechanics/geometry/superquadric_chart.h"

namespace mb {

// log t of the one t > 0 with first t + second t^power = total, all > 0 and given by their logarithms; power > 0.
double log_root(double log_first, double log_second, double power, double log_total);

// x [-] > 0 in units of the chart, outside.
ChartPoint projection(const OctantChart& chart, const Vector3d& x);

}  // namespace mb
