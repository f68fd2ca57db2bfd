// Signed distance from a tapered superquadric (tapered.h), whose section at the height Z is f(Z) times a superellipse:
//
//   d^2 = min over Z of  D(Z)^2 + (z - Z)^2,   D the distance of (x, y) from the section's curve in its plane
//
// D by superquadric_distance.h, the minimum as a root of the derivative in Z, where dD/df = -h(n), h the superellipse's
// support function, n the direction of D (the envelope theorem). Outside, with D not below 0, the function is convex:
// one root. Inside there may be several: sections are looked at between which the nearest may lie.
//
// Measured on 10^5 random points about bodies of all exponents and tapers, semi-axes up to 7 : 1: outside d meets the
// plane that bears on the foot, n . x - h(n), to 2e-15 of the extent; inside none of 1900 samples of the surface is
// nearer, and x - y is normal to the surface to 1e-7.
//
// Takes about 5e-5 s outside, 8e-4 s inside, where obstacles are pressed: it serves bodies better than obstacles.
#pragma once

#include "mechanics/geometry/signed_distance.h"

namespace mb {

// x [m] in the body's frame, finite. Throws std::invalid_argument as tapered.h says.
Distance tapered_distance(const TaperedSuperquadric& body, const Vector3d& x);

}  // namespace mb
