// Radial vibration of a free elastic sphere, with x = omega a / c_l and c_l = sqrt((lambda + 2 mu) / rho):
//
//   u_n(r) = j_1(x_n r/a) / j_1(x_n),   (x^2 - kappa) sin x + kappa x cos x = 0,   kappa = 4 mu / (lambda + 2 mu)
//   4 pi rho int_0^a u_n^2 r^2 dr = 2 pi rho a^3 N_n,   N_n = 1 - kappa (3 - kappa) / x_n^2
//
// One root in each ((n-1) pi, n pi), n >= 1, for any nu in (-1, 1/2). Lamb 1882, Proc. London Math. Soc. 13; Love 1944,
// A Treatise on the Mathematical Theory of Elasticity, sect. 194-196; N_n from Lommel's integral of j_1^2.
#pragma once

#include "mechanics/types.h"

namespace mb {

// kappa [-] = 2 (1 - 2 nu) / (1 - nu), in (0, 3)
double traction_ratio(double poissons_ratio);

// x_n, n = n_before + 1 ... n_before + count, ascending, to working precision. Throws std::invalid_argument for kappa
// out of range.
VectorXd radial_roots(double kappa, Index n_before, Index count);

// j_1(z) and its derivative, and j_1(z)/z; z >= 0, 0 included.
struct Bessel {
  double j1, derivative, over_z;
};
Bessel spherical_bessel(double z);

}  // namespace mb
