#include "harness/analysis/power_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mb {

namespace {

constexpr Index fewest_of_least = 4;

std::vector<Index> usable(const VectorXd& x, const VectorXd& y) {
  std::vector<Index> all;
  for (Index i = 0; i < x.size(); ++i)
    if (x(i) > 0 && y(i) > 0 && std::isfinite(x(i)) && std::isfinite(y(i))) all.push_back(i);
  return all;
}

}  // namespace

PowerLaw power_law(const VectorXd& x, const VectorXd& y) {
  if (x.size() != y.size()) throw std::invalid_argument("a power law needs as many x as y");
  const std::vector<Index> of = usable(x, y);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto n = static_cast<Index>(of.size());
  if (n < 3) return {nan, nan, n};
  VectorXd u = x(of).array().log(), v = y(of).array().log();
  u.array() -= u.mean();
  v.array() -= v.mean();
  const double spread = u.squaredNorm();
  if (!(spread > 1e-24 * static_cast<double>(n))) return {nan, nan, n};  // one x up to rounding
  const double p = u.dot(v) / spread;
  return {p, std::sqrt((v - p * u).squaredNorm() / static_cast<double>(n - 2) / spread), n};
}

PowerLaw power_law_of_least(const VectorXd& x, const VectorXd& y) {
  if (x.size() != y.size()) throw std::invalid_argument("a power law needs as many x as y");
  std::vector<Index> ascending = usable(x, y);
  std::ranges::stable_sort(ascending, {}, [&](Index i) { return x(i); });
  const VectorXd u = x(ascending), v = y(ascending);
  const Index first = std::min(u.size(), fewest_of_least);
  PowerLaw best = power_law(u.head(first), v.head(first));
  for (Index n = first + 1; n <= u.size(); ++n) {
    const PowerLaw law = power_law(u.head(n), v.head(n));
    if (!(law.standard_error >= best.standard_error)) best = law;
  }
  return best;
}

bool agrees(const PowerLaw& law, double claimed) {
  if (law.standard_error > 0.25) return false;
  const double width = law.standard_error > 0.025 ? 2 * law.standard_error : 0.05;
  return std::abs(law.exponent - claimed) <= width;
}

}  // namespace mb
