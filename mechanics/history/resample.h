// A function as a chain of lines, s(t) ~ s(t_i) + (t - t_i) (s(t_{i+1}) - s(t_i))/(t_{i+1} - t_i), its intervals
// bisected until the distance measured between nodes is small against the scale of the piece,
//
//   |f - line| <= tolerance max(least_scale, min(|s(t_i)|, |s(t_{i+1})|)),
//
// so that the integral of the distance is small against that of |s| where least_scale is the mean of |s|. A jump is
// enclosed to 4 ulp of the end time and kept as a jump. With bounds (enclosure.h) f does nowhere between the points
// measured at leave its line by more than 1 % of that scale, however shortly.
#pragma once

#include <functional>
#include <vector>

#include "mechanics/history/enclosure.h"
#include "mechanics/history/history.h"

namespace mb {

inline constexpr std::size_t most_pieces = 100'000;

struct Lines {
  std::vector<Segment> pieces;  // tile [start, end]
  double error;                 // [-] of the scale: the largest found at 16 points a piece, none of them a node
};

// tolerance [-] > 0, least_scale >= 0 in units of f; bounds may be empty. Throws std::domain_error where it takes more
// than most_pieces, or where bounds stay wide.
Lines resample(const std::function<double(double)>& f, double start, double end, double tolerance, double least_scale,
               const Enclosure& bounds = {});

// 1/T int |f| dt by 16 points a piece, the pieces a chain of f's.
double mean_size(const std::function<double(double)>& f, const std::vector<Segment>& pieces);

}  // namespace mb
