// A face of a body, or a disc on it with the smooth compact weight
//
//   w(x) = (1 - (d/a)^2)^2 for d < a, else 0,     d = |x - c|, a the radius.
//
// Point and line supports have no mesh-converged answer in three dimensions; patches do.
#pragma once

#include <optional>
#include <string>

#include "mechanics/geometry/shape.h"
#include "mechanics/types.h"

namespace mb {

struct Disc {
  Vector3d centre; /* [m] body frame, on the face */
  double radius;   /* [m] > 0 */
};

struct Patch {
  std::string face;          // one of face_names(shape)
  std::optional<Disc> disc;  // absent: the whole face with weight 1
};

double weight(const Patch& patch, const Vector3d& x);  // [-] in [0, 1]; does not test whether x lies on the face

}  // namespace mb
