// Mode shapes given by polynomials (Pentland & Williams 1989, section 4, eqs. 5-6), superposed into one deformation:
//
//   u_j(X) = sum_k a_kj m_k(X),     x = X + sum_j q_j u_j(X) = X + sum_k (sum_j a_kj q_j) m_k(X)
//
// The sum over j is taken once for a q; then evaluation costs the same for any number of modes.
#pragma once

#include "mechanics/geometry/polynomial_map.h"

namespace mb {

// r vector fields u_j = sum_k a_kj m_k on the same monomials. In the unit of the modes; with q in its inverse, u in
// [m].
class PolynomialBasis {
 public:
  // coefficients 3 monomials.size() x r, r >= 0: x, y, z of a_0, then of a_1, ... Throws std::invalid_argument for
  // another number of rows and for what is not finite.
  PolynomialBasis(const Monomials& monomials, const MatrixXd& coefficients);

  const Monomials& monomials() const { return monomials_; }
  const MatrixXd& coefficients() const { return coefficients_; }
  Index size() const { return coefficients_.cols(); }  // r

  // The modes at points X [m] 3 x n: 3n x r, x, y, z of point 0, then of point 1, ... (an observation matrix: times q
  // it is the displacement). Throws std::invalid_argument where X is not finite.
  MatrixXd at(const Matrix3Xd& X) const;

  // x = X + sum_j q_j u_j(X). Throws std::invalid_argument for another size of q than r and for what is not finite.
  PolynomialMap map(const VectorXd& q) const;

 private:
  Monomials monomials_;
  MatrixXd coefficients_;
};

}  // namespace mb
