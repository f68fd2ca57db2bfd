// Where a body will touch first: for each of its contacts the point X of its undeformed surface that meets the obstacle
// or comes nearest to it on the way of a body that flies without turning,
//
//   x(X, t) = position + velocity t + gravity t^2/2 + orientation X,   0 <= t <= duration;
//
// a body with supports stands still. What meshes are graded to: an estimate, since the body may turn.
#pragma once

#include <vector>

#include "cases/scene/scene.h"

namespace mb {

// [m] body frame, one a contact of the body, in the scene's order. A box or cylinder that comes to a half-space with a
// face or edge touches it at the middle of that. Throws std::invalid_argument for a contact with an obstacle that the
// scene does not have, and for a motion that is not finite.
std::vector<Vector3d> touch_points(const Scene& scene, const Body& body);

}  // namespace mb
