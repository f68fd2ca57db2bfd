// The surface of a rigid obstacle as a signed distance, the gap of a point x:
//
//   gap(x) > 0 outside,   normal = grad gap (outward, of unit length),   hessian = grad grad gap
//
// A half-space fills z <= 0 of its frame. Rounding r: the shape shrunk by r on all sides and grown by r again (its
// distance less r), which leaves plane faces where they are and makes edges and rims tori and cylinders of radius r.
#pragma once

#include <variant>

#include "mechanics/geometry/pose.h"
#include "mechanics/geometry/shape.h"

namespace mb {

struct HalfSpace {};

struct RigidSurface {
  std::variant<HalfSpace, Shape> shape;
  double rounding = 0; /* [m] >= 0, of boxes and cylinders: below half their smallest extent */
  Pose pose;
};

struct Gap {
  double value;             // [m]
  Vector3d normal;          // [-]
  Eigen::Matrix3d hessian;  // [1/m] symmetric, hessian normal = 0
};
Gap gap(const RigidSurface& surface, const Vector3d& x);           // x [m] in the world
double gap_value(const RigidSurface& surface, const Vector3d& x);  // its value alone

}  // namespace mb
