#include "mechanics/history/mean.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

double integral(const Segment& segment, double from, double to) {
  const double length = to - from, middle = 0.5 * (from + to) - segment.start;
  const double line = segment.c0 + segment.c1 * middle, angle = 0.5 * segment.omega * length;
  const double wave = segment.a * std::cos(segment.omega * middle) + segment.b * std::sin(segment.omega * middle);
  return length * (line + (angle != 0 ? std::sin(angle) / angle : 1) * wave);
}

}  // namespace

double mean(const Segments& chain, double a, double b) {
  if (!(a < b) || !std::isfinite(b - a))
    throw std::invalid_argument("mean of a history: the interval must not be empty");
  // A window that ends with the duration may exceed it by the rounding of t + width/2.
  if (b > 0 && (chain.pieces.empty() || b > chain.pieces.back().end * (1 + 1e-12)))
    throw std::invalid_argument("mean of a history: the interval ends beyond its segments");
  const auto first = std::ranges::upper_bound(chain.pieces, a, {}, &Segment::end);
  double sum = 0;
  for (auto piece = first; piece != chain.pieces.end() && piece->start < b; ++piece)
    sum += integral(*piece, std::max(a, piece->start), std::min(b, piece->end));
  return sum / (b - a);
}

}  // namespace mb
