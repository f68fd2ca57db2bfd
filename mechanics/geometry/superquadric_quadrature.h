// Quadrature in and on a superquadric: n x n Gauss points in each quarter of the faces of the box |y_i| <= a_i,
// projected radially to x = y / N(y). Quarters, because derivatives of N jump at coordinate planes where e > 1. Equal
// angles on a sphere: y_i / a_i = tan(xi pi/4). Volume: times 3 Gauss points in the cube of the radius.
//
// So few points leave errors of some per cent where the body has edges. The weights are therefore changed, by the least
// sum of squares relative to themselves, until known moments are exact:
//
//   volume    all polynomials up to degree 5 (moment())     surface   up to degree 3 (surface_moments())
//
// Of tapered bodies, whose points and elements go through the taper, on the surface up to degree 2; in the volume up to
// degree 3 where 5 asks for a negative weight, as the largest tapers of flat bodies do.
//
// Weights stay positive: no case was found among random exponents and semi-axes up to 400 : 1. Should second moments
// ask for a negative weight on the surface, it keeps the exact area alone.
#pragma once

#include "mechanics/geometry/shape.h"

namespace mb {

Quadrature superquadric_volume_quadrature(const Superquadric& body);  // 288 points
Quadrature superquadric_volume_quadrature(const TaperedSuperquadric& body);
Quadrature superquadric_surface_quadrature(const TaperedSuperquadric& body);
Quadrature superquadric_surface_quadrature(const Superquadric& body);  // 216 points

}  // namespace mb
