// For tests: maps whose inverses are known, and random ones.
#pragma once

#include <random>

#include "mechanics/geometry/polynomial_map.h"

namespace mb::testing {

class RandomMaps {
 public:
  double operator()() { return uniform_(generator_); }
  Vector3d vector() { return {(*this)(), (*this)(), (*this)()}; }
  Matrix3Xd points(const Monomials& m, Index n, double reach = 1) {
    Matrix3Xd X(3, n);
    for (Index i = 0; i < n; ++i) X.col(i) = m.centre() + reach * m.half_extents().cwiseProduct(vector());
    return X;
  }
  // Coefficients of which the displacement is about `size` times the half extents.
  Matrix3Xd coefficients(const Monomials& m, double size) {
    Matrix3Xd a(3, m.size());
    for (Index k = 0; k < m.size(); ++k) a.col(k) = size * m.half_extents().cwiseProduct(vector());
    return a;
  }

 private:
  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

// x = c + t + A (X - c).
inline PolynomialMap affine(const Vector3d& c, const Vector3d& half, const Eigen::Matrix3d& A, const Vector3d& t) {
  Matrix3Xd a(3, 4);
  a << t, (A - Eigen::Matrix3d::Identity()) * half.asDiagonal();
  return {Monomials(1, c, half), a};
}

// x = X + h a xi^2 by component, all half extents h: folded where one xi < -1 / 2a.
inline PolynomialMap parabolas(const Vector3d& a, double h) {
  const Monomials m(2, {0, 0, 0}, {h, h, h});
  Matrix3Xd coefficients = Matrix3Xd::Zero(3, m.size());
  coefficients(0, monomial_index(2, 0, 0)) = a[0] * h;
  coefficients(1, monomial_index(0, 2, 0)) = a[1] * h;
  coefficients(2, monomial_index(0, 0, 2)) = a[2] * h;
  return {m, coefficients};
}

}  // namespace mb::testing
