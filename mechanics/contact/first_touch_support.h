// The point of a convex shape that lies farthest along a direction w, and how far:
//
//   h(w) = max over the shape of w . X = w . X*       (the support function; Rockafellar 1970, Convex Analysis, sect.
//   13)
//
// Of a tapered superquadric tapered.h has it. Of a superquadric h is the dual of the gauge (superquadric.h), norms of
// the conjugate exponents 2/(2 - e):
//   h(w) = | (|(a1 w1, a2 w2)|_p*, a3 w3) |_q*,   p* = 2/(2 - e2),   q* = 2/(2 - e1),   X* = grad h
#pragma once

#include <optional>

#include "mechanics/contact/rigid_surface.h"

namespace mb {

// X* [m] on the surface, in the shape's frame; w [any unit], finite. Where many points lie farthest (w across a plane
// face or an edge, w = 0) one of them; no finite w makes a NaN.
Vector3d support_point(const Shape& shape, const Vector3d& w);

// The same of an obstacle, rounding and pose included: x [m] in the world. Nothing of a half-space.
std::optional<Vector3d> support_point(const RigidSurface& obstacle, const Vector3d& w);

// The radius [m] of the least ball about the shape's centre that holds it, of superquadrics that of their bounding
// boxes.
double circumradius(const Shape& shape);

}  // namespace mb
