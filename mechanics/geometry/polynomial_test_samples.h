// For tests: points with weights, and fields on them that stand for mode shapes.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "mechanics/types.h"

namespace mb::testing {

using Field = std::function<Vector3d(const Vector3d& X)>;

struct Samples {
  Matrix3Xd X;
  VectorXd w;
};

inline MatrixXd modes(const Matrix3Xd& X, const std::vector<Field>& fields) {
  MatrixXd U(3 * X.cols(), static_cast<Index>(fields.size()));
  for (Index j = 0; j < U.cols(); ++j)
    for (Index i = 0; i < X.cols(); ++i) U.block<3, 1>(3 * i, j) = fields[static_cast<size_t>(j)](X.col(i));
  return U;
}

// RandomMaps points in the box with random weights: nothing about them is symmetric.
inline Samples scattered(const Vector3d& centre, const Vector3d& half, Index n) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Samples s{Matrix3Xd(3, n), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    for (Index a = 0; a < 3; ++a) s.X(a, i) = centre[a] + half[a] * uniform(generator);
    s.w[i] = 1.5 + uniform(generator);
  }
  return s;
}

inline Field wave(const Vector3d& k, const Vector3d& amplitude) {
  return [=](const Vector3d& X) { return Vector3d(amplitude * std::sin(k.dot(X) + 0.3)); };
}

// No polynomials, of different amplitudes.
inline const std::vector<Field> waves = {wave({1, 0.4, 0.2}, {1, 2, 3}), wave({2, -1, 1}, {0, 1, 0}),
                                         wave({0.3, 2.5, -1}, {1e-6, 1e-6, 0})};

inline const Vector3d slender(1, 0.02, 0.05), ones(1, 1, 1);  // [m] half extents

// Evenly spread over the unit sphere (Fibonacci spiral).
inline Samples sphere_points(Index n) {
  Samples s{Matrix3Xd(3, n), VectorXd::Ones(n)};
  for (Index i = 0; i < n; ++i) {
    const double z = (2 * static_cast<double>(i) + 1) / static_cast<double>(n) - 1, r = std::sqrt(1 - z * z);
    const double angle = pi * (3 - std::sqrt(5)) * static_cast<double>(i);
    s.X.col(i) = Vector3d(r * std::cos(angle), r * std::sin(angle), z);
  }
  return s;
}

}  // namespace mb::testing
