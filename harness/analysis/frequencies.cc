#include "harness/analysis/frequencies.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace mb {

namespace {

constexpr double clear = 0.01;  // [-] of a resonance

// The nearest frequency that keeps clear of all: just above or just below a group of resonances.
double moved(double f, const std::vector<double>& resonances) {
  const auto blocked = [&](double x) {
    return std::any_of(resonances.begin(), resonances.end(),
                       [&](double r) { return std::abs(x / r - 1) < clear * (1 - 1e-9); });
  };
  if (!blocked(f)) return f;
  double best = 0;
  for (const double r : resonances)
    for (const double x : {r * (1 - clear), r * (1 + clear)})
      if (!blocked(x) && (best == 0 || std::abs(x - f) < std::abs(best - f))) best = x;
  return best == 0 ? f : best;
}

}  // namespace

VectorXd frequencies_between(double first, double last, Index n, const VectorXd& resonances) {
  if (!(first > 0 && last > first && std::isfinite(last)) || n < 2)
    throw std::invalid_argument("frequencies need a range and two points at least");
  const std::vector<double> all(resonances.begin(), resonances.end());
  VectorXd f(n);
  for (Index i = 0; i < n; ++i)
    f(i) = moved(first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(n - 1)), all);
  return f;
}

}  // namespace mb
