// The shift of factors of K - sigma M that eigensolvers and static solutions take.
#pragma once

#include "cases/scene/scene.h"

namespace mb {

// sigma = -0.01 E/(rho l^2) h/l [1/s^2], l and h the largest and the smallest extent. Of a compact body well below the
// first elastic eigenvalue, (pi c/l)^2 of a rod. Bending is slower by (h/l)^2: a cantilever's lambda_1 is
// 1.03 E/(rho l^2) (h/l)^2, |sigma| = 0.01 lambda_1 l/h; at l/h = 200 twice lambda_1, so that conjugate gradients with
// the factor of K - sigma M still take few steps, and K - sigma M of a free body stays as well conditioned as may be.
double physical_shift(const Body& body);

}  // namespace mb
