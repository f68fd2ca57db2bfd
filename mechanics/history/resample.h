// A function as a chain of lines, s(t) ~ s(t_i) + (t - t_i) (s(t_{i+1}) - s(t_i))/(t_{i+1} - t_i), its intervals
// bisected until the distance measured between nodes is small enough. A jump is enclosed to 4 ulp of the end time and
// kept as a jump.
#pragma once

#include <functional>
#include <vector>

#include "mechanics/history/history.h"

namespace mb {

inline constexpr std::size_t most_pieces = 100'000;

struct Lines {
  std::vector<Segment> pieces;  // tile [start, end]
  double error;                 // largest |f - lines| found at 16 points a piece, none of them a node
};
// tolerance >= 0, in units of f. Throws std::domain_error where it takes more than most_pieces.
Lines resample(const std::function<double(double)>& f, double start, double end, double tolerance);

// Largest |f| on [start, end] of some 4,000 irregular points, improved by search about its maxima.
// Throws std::domain_error where the search finds |f| to grow without bound.
double sampled_peak(const std::function<double(double)>& f, double start, double end);

}  // namespace mb
