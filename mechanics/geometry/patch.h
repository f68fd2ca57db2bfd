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

// Points of a disc on the exact face, with the weights w(x) dA: the same for every mesh, so that resultants are too.
//
//   x(rho, theta): the point of the face at chord length rho from the centre, in direction theta
//   plane, sphere: dA = rho drho dtheta        cylinder's side: dA = rho drho dtheta / sqrt(1 - (rho cos theta / 2R)^2)
//
// Gauss in rho^2, equally spaced in theta; superquadrics by graded_rule.h in cells of a/6, to 1e-4 of the disc's area.
// Where the disc hangs over the face's rim, what lies outside is left out.
struct DiscRule {
  Matrix3Xd points;   // [m] 3 x n
  VectorXd weights;   // [m^2] n, w(x) dA, all >= 0
  Matrix3Xd normals;  // [-] 3 x n, outward
};
// Throws std::invalid_argument where the patch is a whole face or nothing of the disc lies on it.
DiscRule disc_rule(const Shape& shape, const Patch& patch);

}  // namespace mb
