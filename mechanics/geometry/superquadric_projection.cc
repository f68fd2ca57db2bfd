#include "mechanics/geometry/superquadric_projection.h"

#include <algorithm>
#include <cmath>

namespace mb {

namespace {

double log_sum(double a, double b) { return std::max(a, b) + std::log1p(std::exp(-std::abs(a - b))); }

// The zero of a falling function by regula falsi with halved ordinates (Illinois; Dowell & Jarratt 1971), bisection
// where that is slow. f is monotone, not smooth: ends where the bracket is as narrow as rounding.
template <class Function>
double zero_of_falling(const Function& f, double low, double high) {
  double f_low = f(low), f_high = f(high);
  if (f_low <= 0) return low;
  if (f_high >= 0) return high;
  for (int k = 0; k < 200; ++k) {
    const double width = high - low;
    if (width <= 4e-16 * std::max({1.0, std::abs(low), std::abs(high)})) break;
    double middle = (f_low * high - f_high * low) / (f_low - f_high);
    if (k % 3 == 2 || !(middle > low && middle < high)) middle = low + 0.5 * width;
    if (!(middle > low && middle < high)) break;
    const double value = f(middle);
    if (value == 0) return middle;
    (value > 0 ? low : high) = middle;
    (value > 0 ? f_low : f_high) = value;
    (value > 0 ? f_high : f_low) *= 0.5;
  }
  return 0.5 * (low + high);
}

}  // namespace

double log_root(double log_first, double log_second, double power, double log_total) {
  // Either term alone makes too large a root; the sum's logarithm is convex: Newton's method falls onto the root.
  double l = std::min(log_total - log_first, (log_total - log_second) / power);
  for (int k = 0; k < 100; ++k) {
    const double a = log_first + l, b = log_second + power * l, share = 1 / (1 + std::exp(b - a));
    const double step = (log_sum(a, b) - log_total) / (share + power * (1 - share));
    l -= step;
    if (std::abs(step) <= 1e-15 * std::max(1.0, std::abs(l))) break;
  }
  return l;
}

ChartPoint projection(const OctantChart& chart, const Vector3d& x) {
  const Vector3d log_a = chart.a.array().log(), log_x = x.array().log();
  const double p = 1 + chart.power_p, q = 1 + chart.power_q;
  const auto component = [&](int i, double power, double log_multiplier) {
    return log_root(log_a[i], log_multiplier - log_a[i], power, log_x[i]);
  };
  struct Across {
    double log_u, log_v, log_r;
  };
  const auto across = [&](double log_alpha) -> Across {
    const double u = component(0, chart.power_p, log_alpha), v = component(1, chart.power_p, log_alpha);
    return {u, v, log_sum(p * u, p * v) / p};
  };
  const auto across_of = [&](double log_lambda) {
    // alpha r^(p-1) = lambda r^(q-1)
    const auto excess = [&](double log_alpha) { return log_lambda - log_alpha + (q - p) * across(log_alpha).log_r; };
    return across(zero_of_falling(excess, -2000, 2000));
  };
  const auto log_gauge = [&](double log_lambda) {
    return log_sum(q * across_of(log_lambda).log_r, q * component(2, chart.power_q, log_lambda));
  };
  const double log_lambda = zero_of_falling(log_gauge, -200, 200);
  const Across found = across_of(log_lambda);
  return chart.at(found.log_u - found.log_v, found.log_r - component(2, chart.power_q, log_lambda));
}

}  // namespace mb
