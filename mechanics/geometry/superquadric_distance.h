// The point y of a superquadric's surface nearest to a point x, and the signed distance d (signed_distance.h):
//
//   e = x - y - d n(y) = 0,   d = (x - y) . n(y),   y of the octant of x
//
// y lies in the octant of x: reflecting it there brings it no farther away. Newton's method for e in the logarithms of
// superquadric_chart.h:
//   outside  y is unique (the body is convex). |e| falls along every Newton direction, since 1 + k_i d > 0. Where
//            edges and spikes hold the iteration up, y comes from monotone equations (superquadric_projection.h) first.
//   inside   several y may be local minima of |x - y|: the least of all found from the surface points on the ray
//            through x and along each axis from x, and from the local minima of |x - y| on a grid of 18 x 18 points.
//            Directions of negative curvature are descended (Dauphin et al. 2014, arXiv:1406.2572).
//
// Measured (superquadric_distance_test.cc and 10^6 random points each): outside |e| < 2e-14 (extent + |x|) for
// semi-axes up to 400 : 1 and all exponents, so that the distance is exact to rounding; inside, semi-axes up to 20 : 1,
// no minimum was missed that searches from 60 x 60 points or by brute force found, 1e-15 of the extent.
#pragma once

#include "mechanics/geometry/signed_distance.h"

namespace mb {

// Throws std::invalid_argument as superquadric.h says. x [m] in the body's frame, finite.
Distance superquadric_distance(const Superquadric& body, const Vector3d& x);
double superquadric_distance_value(const Superquadric& body, const Vector3d& x);  // [m]

}  // namespace mb
