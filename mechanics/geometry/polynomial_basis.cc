#include "mechanics/geometry/polynomial_basis.h"

#include <fmt/format.h>

#include <stdexcept>

namespace mb {

PolynomialBasis::PolynomialBasis(const Monomials& monomials, const MatrixXd& coefficients)
    : monomials_(monomials), coefficients_(coefficients) {
  if (coefficients.rows() != 3 * monomials.size())
    throw std::invalid_argument(fmt::format("polynomial basis: coefficients of {} rows for {} monomials",
                                            coefficients.rows(), monomials.size()));
  if (!coefficients.allFinite()) throw std::invalid_argument("polynomial basis: a coefficient is not finite");
}

MatrixXd PolynomialBasis::at(const Matrix3Xd& X) const {
  if (!X.allFinite()) throw std::invalid_argument("polynomial basis: a point is not finite");
  const MatrixXd m = monomials_.values(X).transpose();
  MatrixXd U(3 * X.cols(), size());
  for (Index j = 0; j < size(); ++j) {
    const MatrixXd a = coefficients_.col(j).reshaped(3, monomials_.size()), u = a * m;
    U.col(j) = u.reshaped();
  }
  return U;
}

PolynomialMap PolynomialBasis::map(const VectorXd& q) const {
  if (q.size() != size())
    throw std::invalid_argument(fmt::format("polynomial basis: {} coordinates for {} modes", q.size(), size()));
  if (!q.allFinite()) throw std::invalid_argument("polynomial basis: a modal coordinate is not finite");
  constexpr Index most = 3 * n_monomials(max_polynomial_degree);  // on the stack: no allocation a step
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1> a(coefficients_.rows());
  a.noalias() = coefficients_ * q;
  return {monomials_, Eigen::Map<const Matrix3Xd>(a.data(), 3, monomials_.size())};
}

}  // namespace mb
