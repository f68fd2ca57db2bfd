// Elastic sphere pressed against a rigid frictionless plane by its own inertia (a uniform body force), small strain and
// rotation: how far its centre of mass approaches the plane, which Hertz takes for that of a half-space.
//
//   p(r) = sum_j c_j w^(2j+1),   w = sqrt(1 - (r/a)^2),   j = 0 ... n_functions - 1     per area of the plane, r < a
//   int_cap w^(2i+1) (u_z(p) - delta + R (1 - cos theta)) dA = 0,   i = -1 ... n_functions - 1,   r = R sin(theta)
//
// u_z: displacement towards the centre, along the plane's normal like the pressure. Equations of w^-1 beside those of
// the c_j are stationarity with respect to a: pressure ends without a jump. With displacements by the Legendre series
// of sphere_series.h, each coefficient is a Galerkin product, sum_n 4 pi/(2n+1) (t_n^i U_n^j + n (n+1) s_n^i V_n^j),
// whose terms fall like n^-4 beside oscillations. These are cut off smoothly over an octave, by 1/(1 + e^(1/(1-x) -
// 1/x)); the tail of the former is taken by Richardson's extrapolation over octaves, exponents 3 and 5. With the
// defaults the series err by 1e-11. The functions lack the logarithms at a true pressure's edge: at nu = 0.3 by 1e-9 of
// delta/delta_H and 5e-7 of F for a given a at a/R = 0.02, by 5e-7 and 1e-5 at 0.3; most at negative nu, ten times that
// at -0.5.
#pragma once

#include "cases/exact/sphere_series.h"

namespace mb {

struct CapSeries {
  int n_functions = 5;  // [1, 8]
  double phase = 400;   // [-] n a/R at which the series ends, [50, 5000]; it has phase R/a terms
};

struct SphereOnPlane {
  double contact_radius;  // a [R]
  double force;           // F [E* R^2]; E* = E/(1 - nu^2)
  double approach;        // delta [R] of the centre of mass
  double energy;          // elastic energy [E* R^3]; its derivative by delta is F
  VectorXd pressure;      // c_j [E*]
};
// a [R] in [0.002, 0.5], nu in (-1, 1/2], else std::invalid_argument.
SphereOnPlane sphere_on_plane(double contact_radius, double poissons_ratio, const CapSeries& series = {});

// Gap [R] between the deformed sphere and the plane at the points that were r [R] in [0, 1) from the axis, on the side
// of the contact: zero inside r < a but for the error of the functions. series as given to sphere_on_plane.
VectorXd gap_to_plane(const SphereOnPlane& contact, double poissons_ratio, const VectorXd& r,
                      const CapSeries& series = {});

// delta/delta_H [-], delta_H = (9 F^2/(16 E*^2 R))^(1/3): Hertz's approach at the same force.
double approach_over_hertz(const SphereOnPlane& contact);

// The same ratio where pressure is not solved for but Hertz's, p_0 w, and the approach that of the pole: 0.8 % below 1
// at a/R = 0.02 and 2.2 % at 0.05 for nu = 0.3 along the sphere's normal; 1.0 and 2.8 % along the plane's.
double hertzian_approach(double contact_radius, double poissons_ratio, PressureAlong along,
                         const CapSeries& series = {});

}  // namespace mb
