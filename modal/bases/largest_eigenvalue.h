// The largest eigenvalue of K phi = lambda M phi: bounds explicit steps and the rounding of everything computed from K.
#pragma once

#include "mechanics/system/system.h"

namespace mb {

// [1/s^2] by Lanczos on M^-1 K: at least the true value, too large by at most 1e-3 of it.
double largest_eigenvalue(const System& system);

}  // namespace mb
