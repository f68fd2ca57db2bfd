#include "reports/orders.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Line {
  double slope, standard_error;
};

// y = intercept + slope x by least squares; standard error of the slope sqrt(sum of squares / (n - 2) / S_xx). Analyses
// have a fit of their own (harness/analysis/power_law.h), which the layers keep out of reach here.
Line least_squares(const std::vector<OrderPoint>& points) {
  const double n = static_cast<double>(points.size());
  double x_mean = 0, y_mean = 0, S_xx = 0, S_xy = 0, rest = 0;
  for (const OrderPoint& p : points) {
    x_mean += std::log(p.h) / n;
    y_mean += std::log(p.error) / n;
  }
  for (const OrderPoint& p : points) {
    S_xx += std::pow(std::log(p.h) - x_mean, 2);
    S_xy += (std::log(p.h) - x_mean) * (std::log(p.error) - y_mean);
  }
  const double slope = S_xy / S_xx, intercept = y_mean - slope * x_mean;
  for (const OrderPoint& p : points) rest += std::pow(std::log(p.error) - intercept - slope * std::log(p.h), 2);
  return {slope, points.size() > 2 ? std::sqrt(rest / (n - 2) / S_xx) : nan};
}

bool has_flattened(const std::vector<OrderPoint>& points) {
  if (points.size() < 3) return false;
  const double before = least_squares({points.begin(), points.end() - 1}).slope;
  const double last = least_squares({points.end() - 2, points.end()}).slope;
  return before > 0 && last < 0.5 * before;
}

std::vector<OrderPoint> telling(std::vector<OrderPoint> points) {
  std::erase_if(points, [](const OrderPoint& p) {
    const bool usable = p.h > 0 && std::isfinite(p.h) && p.error > 0 && p.error <= unresolved;
    return !usable || !(p.error > bars_clear * p.hidden);
  });
  std::sort(points.begin(), points.end(), [](const OrderPoint& a, const OrderPoint& b) { return a.h > b.h; });
  // Two runs of one h tell no slope: multiplets may round two mode counts up to one. The first stands for both.
  points.erase(std::unique(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.h == b.h; }),
               points.end());
  double floor = 0;
  while (has_flattened(points)) {
    const double last = points.back().error;
    floor = floor > 0 ? std::min(floor, last) : last;
    points.pop_back();
  }
  std::erase_if(points, [&](const OrderPoint& p) { return p.error < floors_clear * floor; });
  return points;
}

}  // namespace

ObservedOrder fit_order(std::vector<OrderPoint> points) {
  const std::size_t n_all = points.size();
  points = telling(std::move(points));
  ObservedOrder result{.order = nan,
                       .standard_error = nan,
                       .n_points = static_cast<int>(points.size()),
                       .n_left_out = static_cast<int>(n_all - points.size()),
                       .coarsest = points.empty() ? nan : points.front().h,
                       .finest = points.empty() ? nan : points.back().h,
                       .why_none = "fewer than three points"};
  if (points.size() < 3) return result;
  const Line line = least_squares(points);
  const bool falls = line.slope >= least_order && line.slope >= 2 * line.standard_error;
  result.why_none = falls ? "" : "error does not fall";
  if (!falls) return result;
  result.order = line.slope;
  result.standard_error = line.standard_error;
  return result;
}

}  // namespace mb
