// Points of a disc on the exact face, with the weights w(x) dA: resultants are the same for every mesh.
//
//   x(rho, theta): the point of the face at chord length rho from the centre, in direction theta
//   plane, sphere: dA = rho drho dtheta        cylinder's side: dA = rho drho dtheta / sqrt(1 - (rho cos theta / 2R)^2)
//
// n rings by Gauss in rho^2, 3 n points equally spaced on each, about a/n apart half-way out; superquadrics by
// graded_rule.h, to 1e-4 of the disc's area. Where the face's rim cuts the disc, arcs on the face have Gauss points of
// their own, rings between the radii at which arcs begin and end, too: force and moment to 1e-6 of the whole disc's
// with the fewest points, but where a corner of the rim lies within. On a cylinder's side the radius is at most 2 R,
// where dA is singular.
//
// What is integrated beside w bends from cell to cell of a mesh: points must be closer than its nodes are, or they are
// loads at points, which have no mesh-converged answer.
#pragma once

#include "mechanics/geometry/patch.h"

namespace mb {

struct DiscRule {
  Matrix3Xd points;   // [m] 3 x n
  VectorXd weights;   // [m^2] n, w(x) dA, all >= 0
  Matrix3Xd normals;  // [-] 3 x n, outward
};
// spacing [m] > 0 of the points, with 8 rings at least and 128 at most. Throws std::invalid_argument where the patch is
// a whole face or nothing of the disc lies on it.
DiscRule disc_rule(const Shape& shape, const Patch& patch, double spacing);

}  // namespace mb
