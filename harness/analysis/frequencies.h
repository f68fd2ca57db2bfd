// Where to look at a steady response: equal ratios between two frequencies, out of the way of undamped resonances.
#pragma once

#include "mechanics/types.h"

namespace mb {

// n >= 2 frequencies from `first` to `last`, both > 0. Where one lies within 1 % of a resonance it is moved to that
// distance, away from it, and on where another one is in the way.
VectorXd frequencies_between(double first, double last, Index n, const VectorXd& resonances);

}  // namespace mb
