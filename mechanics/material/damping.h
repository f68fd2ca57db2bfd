// Rayleigh damping of the deformation alone:
//
//   C = alpha (M - M R R^T M) + beta K
//
// R holds the rigid modes which the supports leave free (R^T M R = I, K R = 0): plain alpha M would brake free fall.
// In a mode of frequency omega the damping ratio is zeta = alpha/(2 omega) + beta omega/2.
//
// Ratios asked for mode by mode add   sum_i d_i (M phi_i)(M phi_i)^T,   d_i = 2 zeta_i omega_i - alpha - beta
// omega_i^2.
#pragma once

#include "mechanics/types.h"

namespace mb {

struct Rayleigh {
  double alpha = 0;  // [1/s] >= 0, mass-proportional
  double beta = 0;   // [s] >= 0, stiffness-proportional
};

// W diag(d) W^T on top of Rayleigh damping. Full order: W = M Phi, the modes whose ratios a scene states, and for every
// dashpot a column of mean values over its patch, with d its coefficient.
struct ModalDamping {
  MatrixXd W;  // [kg^1/2], of dashpots [-]; n x k; k may be 0
  VectorXd d;  // [1/s], of dashpots [kg/s]; k; may be negative where Rayleigh damping alone would exceed the ratio: C
               // stays semi-definite
};

}  // namespace mb
