// The largest |f| of a formula: sought at samples, then by bounds on all intervals where a larger one could still be.
#pragma once

#include <functional>

#include "mechanics/history/enclosure.h"

namespace mb {

// Multiples of the golden ratio modulo 1: evenly spread at any number, and no period of f can hide between them.
double golden_fraction(int i);

// Largest |f| found on [start, end]; by branch and bound no other is larger by more than 1 %, and f is finite
// throughout but for intervals shorter than 4 ulp of the end. Throws std::domain_error, that tells where, if f is not
// finite, seems unbounded, or bounds stay wide after 20,000 intervals.
double largest_size(const std::function<double(double)>& f, const Enclosure& bounds, double start, double end);

}  // namespace mb
