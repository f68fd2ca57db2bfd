#include "harness/analysis/peak.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace mb {

Peak highest(const std::function<double(double)>& y, double first, double last, double tolerance) {
  if (!(first > 0 && last > first && std::isfinite(last) && tolerance > 0))
    throw std::invalid_argument("a peak needs a bracket 0 < first < last and a tolerance");
  const double ratio = 1 / std::numbers::phi;
  double a = first, b = last;
  Peak left{b - ratio * (b - a), 0}, right{a + ratio * (b - a), 0};
  left.height = y(left.at), right.height = y(right.at);
  while (b - a > tolerance * a) {
    if (left.height > right.height) {
      b = right.at, right = left;
      left.at = b - ratio * (b - a), left.height = y(left.at);
    } else {
      a = left.at, left = right;
      right.at = a + ratio * (b - a), right.height = y(right.at);
    }
  }
  return left.height > right.height ? left : right;
}

}  // namespace mb
