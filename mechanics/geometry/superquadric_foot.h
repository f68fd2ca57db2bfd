// Newton's method for the foot y of the perpendicular from x onto a superquadric, in one octant
// (superquadric_distance.h).
#pragma once

#include "mechanics/geometry/superquadric_chart.h"

namespace mb {

struct Foot {
  ChartPoint at;
  double d;        // (x - y) . n
  Vector3d e;      // x - y - d n
  double miss;     // |e|
  double squared;  // |x - y|^2
};
Foot foot_at(const ChartPoint& at, const Vector3d& x);

// x [-] > 0 in units of the chart, inside or outside.
Foot nearest_foot(const OctantChart& chart, const Vector3d& x);

// Its parts, from the point on the ray through x: outside the only foot, inside of all minima of |x - y| the least.
Foot foot_outside(const OctantChart& chart, const Vector3d& x, const Foot& on_ray);
Foot foot_inside(const OctantChart& chart, const Vector3d& x, const Foot& on_ray);
Foot minimum_near(const OctantChart& chart, const Vector3d& x, const Foot& from);  // of |x - y|, for x inside

}  // namespace mb
