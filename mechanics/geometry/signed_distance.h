// Signed distance of a point x from the surface of a convex shape, y the point of the surface nearest to x:
//
//   d = +-|x - y|, > 0 outside,   grad d = n(y),   x = y + d n,   grad grad d = sum_i k_i / (1 + k_i d) t_i t_i^T
//
// with the principal curvatures k_i of the surface at y along t_i (Gilbarg & Trudinger 2001, Elliptic Partial
// Differential Equations of Second Order, lemma 14.17); beside an edge k is infinite, the quotient 1 / d.
//
// Where several y are nearest, one is chosen, always the same: of a box's faces the first of face_names' axes, of a
// coordinate 0 the positive side, on a cylinder's axis +x, its side before its ends, in a sphere's centre +z.
// Curvatures above 1e9 / extent(shape) count as that: Hessians are finite on edges, too.
//
// Box, cylinder and sphere: closed form, to rounding. Superquadrics: superquadric_distance.h,
// tapered_distance.h.
// An x that is not finite makes all NaN; a size that is not positive throws std::invalid_argument.
#pragma once

#include "mechanics/geometry/shape.h"

namespace mb {

struct Distance {
  double value;             // [m]
  Vector3d gradient;        // [-] of unit length
  Eigen::Matrix3d hessian;  // [1/m] symmetric, hessian gradient = 0
};
Distance signed_distance(const Shape& shape, const Vector3d& x);      // x [m] in the shape's frame
double signed_distance_value(const Shape& shape, const Vector3d& x);  // its value alone [m]

}  // namespace mb
