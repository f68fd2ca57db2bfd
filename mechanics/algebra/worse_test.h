// The largest of some errors, of which one that is no number is the worst: std::max drops it.
#pragma once

#include <cmath>
#include <initializer_list>
#include <limits>

namespace mb {

inline double worse(std::initializer_list<double> errors) {
  double worst = -std::numeric_limits<double>::infinity();
  for (const double error : errors) {
    if (std::isnan(error)) return error;
    if (error > worst) worst = error;
  }
  return worst;
}
inline double worse(double a, double b) { return worse({a, b}); }

}  // namespace mb
