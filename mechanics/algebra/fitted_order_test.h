// For tests: the order p of errors e ~ h^p, by least squares in logarithms.
#pragma once

#include <cmath>
#include <vector>

namespace mb::testing {

// h > 0 in one unit, e > 0; two and more of each.
inline double fitted_order(const std::vector<double>& h, const std::vector<double>& e) {
  const auto n = static_cast<double>(h.size());
  double mean_h = 0, mean_e = 0, both = 0, square = 0;
  for (std::size_t i = 0; i < h.size(); ++i) mean_h += std::log(h[i]) / n, mean_e += std::log(e.at(i)) / n;
  for (std::size_t i = 0; i < h.size(); ++i) {
    both += (std::log(h[i]) - mean_h) * (std::log(e[i]) - mean_e);
    square += (std::log(h[i]) - mean_h) * (std::log(h[i]) - mean_h);
  }
  return both / square;
}

}  // namespace mb::testing
