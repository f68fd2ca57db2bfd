#include "harness/metrics/signal.h"

#include <cmath>
#include <limits>

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double norm(const VectorXd& weights, const VectorXd& a) { return std::sqrt(weights.dot(a.cwiseAbs2())); }

}  // namespace

VectorXd trapezoid_weights(const VectorXd& t) {
  const Index n = t.size();
  if (n < 2) return VectorXd::Ones(n);
  VectorXd weights = VectorXd::Zero(n);
  const VectorXd half = (t.tail(n - 1) - t.head(n - 1)) / 2;
  weights.head(n - 1) += half;
  weights.tail(n - 1) += half;
  return weights;
}

SpragueGeers sprague_geers(const VectorXd& weights, const VectorXd& c, const VectorXd& m) {
  const double size_c = norm(weights, c), size_m = norm(weights, m);
  if (!(size_m > 0)) return {nan, nan, nan};
  const double magnitude = size_c / size_m - 1;
  if (!(size_c > 0)) return {magnitude, nan, nan};
  // The angle between c and m by Kahan's formula: arccos of a number near 1 would lose half the digits.
  const VectorXd a = c / size_c, b = m / size_m;
  const double phase = 2 * std::atan2(norm(weights, a - b), norm(weights, a + b)) / pi;
  return {magnitude, phase, std::hypot(magnitude, phase)};
}

double relative_l2(const VectorXd& weights, const VectorXd& c, const VectorXd& m) {
  const double size_m = norm(weights, m);
  return size_m > 0 ? norm(weights, c - m) / size_m : nan;
}

}  // namespace mb
