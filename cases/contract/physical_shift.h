// The shift of factors of K - sigma M that eigensolvers and static solutions take.
#pragma once

#include "cases/scene/scene.h"

namespace mb {

// sigma = -0.01 E/(rho l^2) [1/s^2], l the largest extent: well below the first elastic eigenvalue, (pi c/l)^2 for a
// rod, and far enough from zero that K - sigma M of a free body is well conditioned.
double physical_shift(const Body& body);

}  // namespace mb
