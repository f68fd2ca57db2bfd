// The deformation that a polynomial carries (Pentland & Williams 1989, section 4, eqs. 5-6), and its inverse:
//
//   x = X + u(X),     u = sum_k a_k m_k(X),     F = dx/dX = I + sum_k a_k (grad m_k)^T
//
// It deforms any geometry: points, and surfaces given implicitly through the inverse, x on the deformed surface where
// X(x) is on the resting one. Polynomials fit a body in its scaled box |xi| <= 1 and mean nothing far outside it: the
// inverse looks for X where |xi| <= 2 (the region of validity), so that it serves points outside, but near the body.
#pragma once

#include <optional>

#include "mechanics/geometry/polynomial.h"

namespace mb {

class PolynomialMap {
 public:
  static constexpr double reach = 2;  // [-] the inverse's region |xi| <= reach

  // coefficients a [m] 3 x monomials.size(). Throws std::invalid_argument for another size or what is not finite.
  PolynomialMap(const Monomials& monomials, const Eigen::Ref<const Matrix3Xd>& coefficients);

  // Up to the highest degree whose coefficients are not all 0.
  const Monomials& monomials() const { return monomials_; }

  // At material points X [m], also outside the box. NaN propagates. Many points are evaluated 16 at a time.
  Vector3d position(const Vector3d& X) const { return X + displacement(X); }  // x [m]
  Vector3d displacement(const Vector3d& X) const;                             // u [m]
  Eigen::Matrix3d gradient(const Vector3d& X) const;                          // F [-]
  struct Point {
    Vector3d x;         // [m]
    Eigen::Matrix3d F;  // [-]
  };
  Point at(const Vector3d& X) const;
  Matrix3Xd positions(const Matrix3Xd& X) const;  // x [m] 3 x n
  Matrix3Xd gradients(const Matrix3Xd& X) const;  // F [-] 3 x 3n, of point i in columns 3i ... 3i + 2
  struct Points {
    Matrix3Xd x;  // [m] 3 x n
    Matrix3Xd F;  // [-] 3 x 3n, as gradients
  };
  Points points(const Matrix3Xd& X) const;  // both, for the price of the gradients

  // X [m] in the region of validity with |x - X - u(X)| <= 1e-13 max(extent, |x - c|) and det F > 0; nothing where
  // none is found: x is away from the body, or the body is folded there (det F <= 0 at the only roots). The residual
  // is that of X - c: where |c| is large, adding c rounds it to the spacing of numbers near c.
  //
  // Newton from the guess [m], by default from x, both moved into the region (x into the box). Steps are halved until
  // the residual falls (Armijo) and det F stays positive, so that no fold is crossed. Where this fails it starts again,
  // from those three of 27 points of the box that come to lie nearest to x. Each start takes at most max_steps >= 1
  // steps; a map of degree 1 takes one. The root is the only one in the box where certainly_invertible(); else another
  // start may lead to another. Throws std::invalid_argument where x or the guess is not finite.
  std::optional<Vector3d> inverse(const Vector3d& x, const std::optional<Vector3d>& guess = {},
                                  int max_steps = 50) const;

  // Upper bounds on the box |xi| <= 1 (where |m_k| <= 1), from sums of |a_k|; that of u is sharp for degree 1.
  double lipschitz_bound() const;       // [-] >= |grad u|_2
  Vector3d displacement_bound() const;  // [m] >= |u| by component
  // Whether x is certainly one to one on the box with det F > 0: sufficient, not necessary. With G >= |grad u| entry by
  // entry, x(X) = x(Y) entails |X - Y| <= G |X - Y|, hence X = Y where the spectral radius of G is less than 1 (which
  // no scaling of axes changes: slender bodies lose nothing). The same is tried for F0^-1 x, F0 = F(c), if det F0 > 0.
  bool certainly_invertible() const;

 private:
  Point about_centre(const Vector3d& xi) const;  // x - c and F at scaled coordinates
  std::optional<Vector3d> newton(const Vector3d& target, const Vector3d& start, int max_steps) const;
  std::optional<Vector3d> newton_from_nearest(const Vector3d& target, int max_steps) const;

  Monomials monomials_;
  // One column a monomial, the fourth row 0: a column is one register. Inside the object: no allocation per map.
  Eigen::Matrix<double, 4, Eigen::Dynamic, Eigen::ColMajor, 4, n_monomials(max_polynomial_degree)> a_;
  Vector3d range_;  // [m] |x - c| of whatever lies in the region of validity is at most this, by component
};

}  // namespace mb
