// Repeatable noise for start vectors and residual checks: the same numbers on every machine and in every run.
#pragma once

#include "mechanics/types.h"

namespace mb {

// n values, uniform in [-1, 1), from a 64-bit Mersenne twister of the seed given.
VectorXd uniform_noise(Index n, unsigned seed);

}  // namespace mb
