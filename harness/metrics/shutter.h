// What a frame shows of a motion, and what frames make of it:
//
//   point        x(t)                                              gain 1
//   box of N     1/N sum_j x(t + ((j + 1/2)/N - 1/2) w)            gain sin(pi f w) / (N sin(pi f w / N))
//   exact mean   1/w int_(t - w/2)^(t + w/2) x                     gain sin(pi f w) / (pi f w)
//
// Frames at the rate F cannot tell f from |f - F round(f/F)|. Oppenheim & Schafer 2010, Discrete-Time Signal
// Processing, sects. 2.6 and 4.2.
#pragma once

#include <string>

#include "mechanics/types.h"

namespace mb {

struct Shutter {
  double width;   // [s] > 0: the time between two frames
  int n_samples;  // of the box, >= 1 (1: a point); 0: the exact mean
};
std::string to_string(const Shutter& shutter);  // "point", "box of 4", "exact mean"

double gain(const Shutter& shutter, double f);  // [-] in [-1, 1]; f [1/s] >= 0

double apparent_frequency(double f, double frame_rate);  // [1/s] in [0, frame_rate/2]

// [s] j / frame_rate whose shutter of that length lies within [0, duration] but for rounding.
VectorXd whole_frames(double frame_rate, double duration);

}  // namespace mb
