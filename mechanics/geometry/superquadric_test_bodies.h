// Superquadrics and points that tests share: round, flat, edged and spiked ones; points where formulas break.
#pragma once

#include <random>
#include <vector>

#include "mechanics/geometry/shape.h"

namespace mb::testing {

inline std::vector<Superquadric> bodies() {
  const std::vector<double> exponents = {0.1, 0.37, 1, 1.4, 1.97, 2};
  std::vector<Superquadric> all;
  for (const double e1 : exponents)
    for (const double e2 : exponents) all.push_back({{0.8, 0.5, 1.3}, e1, e2});
  all.push_back({{1, 1, 1}, 1, 1});
  all.push_back({{0.05, 1, 0.2}, 0.5, 1.2});
  all.push_back({{2, 0.1, 0.1}, 1.2, 0.3});
  return all;
}

// The same on every system: of std::mt19937 alone the sequence is fixed.
class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_()) + 0.5) / 4294967296.0;
  }
  Vector3d positive_vector() { return {number(0, 1), number(0, 1), number(0, 1)}; }
  Vector3d vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }

 private:
  std::mt19937 generator_;
};

inline std::vector<Vector3d> awkward_points() {
  std::vector<Vector3d> points;
  const std::vector<double> values = {0, 1e-300, 1e-14, 0.3, 0.8, 1e12, 1e150};
  for (const double x : values)
    for (const double y : values)
      for (const double z : values) points.emplace_back(x, -y, z);
  points.emplace_back(-0.0, 0.0, 0.0);
  return points;
}

}  // namespace mb::testing
