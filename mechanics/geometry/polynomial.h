// All monomials up to a total degree, in coordinates scaled by a body's half extents h about its centre c:
//
//   xi = (X - c) / h by component,     m_k(X) = xi_1^i xi_2^j xi_3^l,     i + j + l <= degree,     |m_k| <= 1 on the
//   body
//
// However slender the body and wherever it lies, xi fills [-1, 1]^3: X itself would make columns that differ by powers
// of the aspect ratio. In graded order (degree by degree, in each x before y before z: 1; x, y, z; x^2, xy, xz, y^2,
// yz, z^2; ...) those of a lower degree come first, so that k does not depend on the degree.
#pragma once

#include <array>

#include "mechanics/types.h"

namespace mb {

inline constexpr int max_polynomial_degree = 8;

constexpr Index n_monomials(int degree) { return Index{degree + 1} * (degree + 2) * (degree + 3) / 6; }

// k of xi_1^i xi_2^j xi_3^l in graded order.
constexpr Index monomial_index(int i, int j, int l) {
  return n_monomials(i + j + l - 1) + Index{j + l} * (j + l + 1) / 2 + l;
}

class Monomials {
 public:
  // degree in 0 ... 8; centre [m]; half_extents [m], each > 0. Throws std::invalid_argument otherwise.
  Monomials(int degree, const Vector3d& centre, const Vector3d& half_extents);

  int degree() const { return degree_; }
  Index size() const { return n_monomials(degree_); }             // 1 ... 165
  const Vector3d& centre() const { return centre_; }              // [m]
  const Vector3d& half_extents() const { return half_extents_; }  // [m]
  double extent() const { return 2 * half_extents_.maxCoeff(); }  // [m]
  static std::array<int, 3> exponents(Index k);                   // i, j, l; 0 <= k < 165, else std::invalid_argument

  Vector3d scaled(const Vector3d& X) const { return (X - centre_).cwiseQuotient(half_extents_); }  // xi [-]
  Matrix3Xd scaled(const Matrix3Xd& X) const;                                                      // 3 x n

  // [-] and d/dX_1, d/dX_2, d/dX_3 [1/m] of every monomial (columns) at the points X [m] 3 x n (rows): n x size().
  // One product a monomial, from the one below it; NaN propagates.
  MatrixXd values(const Matrix3Xd& X) const;
  std::array<MatrixXd, 3> gradients(const Matrix3Xd& X) const;

 private:
  int degree_;
  Vector3d centre_, half_extents_;
};

// Scaled to the bounding box of the points X [m] 3 x n. A direction without extent (less than 1e-12 of the largest:
// rounding) takes the largest one. Throws std::invalid_argument where no two points differ or one is not finite.
Monomials monomials_about(const Matrix3Xd& X, int degree);

}  // namespace mb
