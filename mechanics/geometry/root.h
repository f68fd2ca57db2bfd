// A root of a continuous function between two points where its signs differ, by inverse quadratic interpolation where
// that is safe and by halves elsewhere (Chandrupatla 1997, Advances in Engineering Software 28(3), 145-149).
#pragma once

#include <algorithm>
#include <cmath>

namespace mb {

// To `tolerance` > 0, absolute, and two roundings in x. f(a) and f(b) of the same sign: the end where |f| is less.
template <class Function>
double root_between(const Function& f, double a, double b, double tolerance) {
  double x1 = b, x2 = a, f1 = f(x1), f2 = f(x2), t = 0.5;
  if ((f1 > 0) == (f2 > 0)) return std::abs(f1) < std::abs(f2) ? x1 : x2;
  for (int i = 0; i < 200; ++i) {
    const double x = x1 + t * (x2 - x1), fx = f(x);
    double x3 = x1, f3 = f1;
    if ((fx > 0) != (f1 > 0)) x3 = x2, f3 = f2, x2 = x1, f2 = f1;
    x1 = x, f1 = fx;
    const double least = (tolerance + 4.5e-16 * std::abs(x1)) / std::abs(x2 - x1);
    if (least > 0.5 || f1 == 0) break;
    const double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
    const bool safe = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
    t = safe ? f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2) : 0.5;
    t = std::clamp(t, least, 1 - least);
  }
  return std::abs(f1) < std::abs(f2) ? x1 : x2;
}

}  // namespace mb
