// Means of a history over intervals of time, in closed form on each of its segments:
//
//   1/(b-a) int_a^b s(t) dt,   int cos(omega tau) = 2/omega sin(omega h/2) cos(omega tau_m),  h long about tau_m
//
// The load acts from t = 0 on: s counts as zero before.
#pragma once

#include "mechanics/history/history.h"

namespace mb {

// a < b [s]. chain tiles [0, duration], b at most the duration but for rounding; else std::invalid_argument.
double mean(const Segments& chain, double a, double b);

}  // namespace mb
