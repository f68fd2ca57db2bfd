// The norm dual to a superquadric's of exponent 2/e, which its support function is made of (first_touch_support.h):
// |(a, b)| with exponent 2/(2 - e) and its gradient, of a, b >= 0 that are not both 0: with r = b/a <= 1, m = 2/(2 -
// e),
//
//   (1, r^(m-1)) / (1 + r^m)^(1/p),   p = 2/e the conjugate;   e = 2 is the maximum norm.   |(a, b)| = (a, b) .
//   gradient
#pragma once

#include <cmath>

#include "mechanics/types.h"

namespace mb {

inline Eigen::Vector2d dual_gradient(double a, double b, double e) {
  if (a < b) return dual_gradient(b, a, e).reverse();
  if (e == 2) return {1, 0};
  const double r = b / a, m = 2 / (2 - e);
  const double slope = r > 0 ? std::pow(r, m - 1) : 0;  // m > 1
  return Eigen::Vector2d(1, slope) / std::pow(1 + slope * r, e / 2);
}

}  // namespace mb
