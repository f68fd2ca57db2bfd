#include "mechanics/geometry/gauss.h"

#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

// Legendre polynomial P_n and its derivative at x, |x| < 1, by Bonnet's recurrence.
struct Legendre {
  double p, dp;
};
Legendre legendre(int n, double x) {
  double previous = 1, current = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
    previous = current;
    current = next;
  }
  return {current, n * (x * current - previous) / (x * x - 1)};
}

}  // namespace

Rule gauss_legendre(int n) {
  if (n < 1) throw std::invalid_argument("gauss_legendre: needs at least one point");
  Rule rule{VectorXd(n), VectorXd(n)};
  if (n == 1) return {VectorXd::Constant(1, 0.5), VectorXd::Ones(1)};
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(pi * (i + 0.75) / (n + 0.5));  // Tricomi's estimate; Newton converges from it for every n
    for (int k = 0; k < 10; ++k) {
      const auto [p, dp] = legendre(n, x);
      x -= p / dp;
    }
    const double dp = legendre(n, x).dp;
    rule.x[i] = 0.5 * (1 + x);
    rule.w[i] = 1 / ((1 - x * x) * dp * dp);
  }
  return rule;
}

}  // namespace mb
