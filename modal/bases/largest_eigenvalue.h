// The largest eigenvalue of K phi = lambda M phi: bounds the rounding of everything computed from K.
#pragma once

#include "mechanics/system/system.h"

namespace mb {

// [1/s^2] by Lanczos on M^-1 K: at least the true value, too large by at most 3 % of it: a bound needs no more.
double largest_eigenvalue(const System& system);

}  // namespace mb
