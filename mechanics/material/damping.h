// Rayleigh damping of the deformation alone:
//
//   C = alpha (M - M R R^T M) + beta K
//
// R holds the rigid modes which the supports leave free (R^T M R = I, K R = 0): plain alpha M would brake free fall.
// In a mode of frequency omega the damping ratio is zeta = alpha/(2 omega) + beta omega/2.
#pragma once

namespace mb {

struct Rayleigh {
  double alpha = 0;  // [1/s] >= 0, mass-proportional
  double beta = 0;   // [s] >= 0, stiffness-proportional
};

}  // namespace mb
