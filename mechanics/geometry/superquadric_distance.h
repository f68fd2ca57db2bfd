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
// Measured on 10^6 random points outside, 3 10^5 inside, some next to or on coordinate planes, all exponents. Outside,
// semi-axes up to 400 : 1: |e| < 1e-12 (extent + |x|), by which d is exact to |e|^2 / 2d; more than 1e-14 only within
// 1e-11 of an edge. Inside, semi-axes up to 20 : 1: searches from 45 x 45 points found nothing nearer, and brute force
// (4500 points, up to 150 : 1, inside and outside) the same distance to 5e-16 of the extent.
//
// Takes about 1e-6 s outside, 6e-6 s inside; where edges need the monotone equations 5e-3 s (of bodies with e = 2 less
// than one point in 10^3).
#pragma once

#include "mechanics/geometry/signed_distance.h"

namespace mb {

// Throws std::invalid_argument as superquadric.h says. x [m] in the body's frame, finite.
Distance superquadric_distance(const Superquadric& body, const Vector3d& x);
double superquadric_distance_value(const Superquadric& body, const Vector3d& x);  // [m]

}  // namespace mb
