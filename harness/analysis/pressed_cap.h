// The cap of a rigid convex body that lies deeper than a plane, exactly, for what contenders make of it
// (modal/polygons/plane_contact.h). Around the axis through the deepest point y along the plane's normal, points at the
// height h over y in direction phi lie at the distance r(h, phi), and a surface element is
//
//   dA = r / (n . e_r) dh dphi,   n the outward normal, e_r the direction away from the axis
//   int f(delta - h) dA = int_0^2pi int_0^1 f(delta (1 - s^2)) r/(n . e_r) 2 delta s ds dphi
//
// On a sphere r/(n . e_r) = R. Heights by s, because r grows like sqrt(h); Gauss in s, equal steps in phi, which
// converge faster than any power of their number where the surface is smooth. On a sphere all is in closed form.
#pragma once

#include "mechanics/geometry/shape.h"
#include "modal/polygons/plane_contact.h"

namespace mb {

struct PressedCap {
  PlaneContact contact;  // A, F/k_n, U/k_n, delta; n_touching is 0
  double error;          // [-] of the three, the largest relative difference from half as many points each way
  double reach;          // [m] greatest distance of the cap's points from the deepest one
};
// down: direction of the plane from the body, in the body's frame, any length but 0; depth: delta [m] > 0, at most half
// the body's extent across. Spheres and superquadrics; throws std::invalid_argument for others and what is out of
// range.
PressedCap pressed_cap(const Shape& shape, const Vector3d& down, double depth);

}  // namespace mb
