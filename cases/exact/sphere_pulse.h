// Free sphere under a uniform pressure pulse: radial modes in closed form, with mode acceleration.
//
//   u(r, t) = -p r / (3 K) s(t) + sum_n u_n(r) (q_n - f_n s / omega_n^2),   q'' + omega_n^2 q = f_n s,   at rest before
//   s = sin^2(pi t / T) for 0 <= t < T, then 0;   f_n = -2 p / (rho a N_n);   u_n, N_n, omega_n: radial_modes.h
//
// K the bulk modulus. The static response takes what the modes left out follow the load with; the rest falls as
// x_n^-4, so that cutting after N modes leaves at most, in units of p/(rho c_l^2), with Theta = 2 pi a / (c_l T),
//
//   a Theta^2 2 / (3 pi^4 N^3)  of u at the surface,   (a/r) Theta^2 / (pi^3 N^2)  of the strains at r
//
// all terms in phase. At the centre itself the strain has kinks, which a series meets at 1/N.
#pragma once

#include "cases/exact/exact.h"

namespace mb {

struct SpherePulse {
  double radius;      // [m] > 0
  Material material;  // isotropic
  double pressure;    // [Pa] peak, positive inwards
  double duration;    // [s] > 0, T
};

// Radii x times.
struct RadialField {
  MatrixXd u, radial, hoop;  // [m] u_r; [-] du_r/dr and u_r/r
};
enum class Series { plain, mode_acceleration };
// r [m] in [0, radius], t [s] ascending, >= 0, n_modes >= 0.
RadialField radial_field(const SpherePulse& sphere, const VectorXd& r, const VectorXd& t, Index n_modes, Series series);

// Modes after which the bounds above are below `remainder` [-] times p / (3 rho c_l^2), a third of the pressure's
// scale, for strains at r >= r_min [m] > 0.
Index modes_needed(const SpherePulse& sphere, double r_min, double remainder);

ExactSolution sphere_radial_pulse();

}  // namespace mb
