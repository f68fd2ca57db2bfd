// Dense eigenproblems and singular values, by LAPACK.
//
//   A x = lambda x, A symmetric        K x = lambda M x, x^T M x = 1        A = U diag(sigma) V^T
//
// Eigenvalues of symmetric matrices ascend; of symmetric matrices the lower triangle counts.
#pragma once

#include <complex>
#include <optional>

#include "mechanics/types.h"

namespace mb {

struct EigenPairs {
  VectorXd values;   // n
  MatrixXd vectors;  // n x n, orthonormal in the problem's inner product
};

// Each throws std::runtime_error where the solver does not converge, as on what is not finite.
EigenPairs symmetric_eigen(const MatrixXd& A);
VectorXd symmetric_eigenvalues(const MatrixXd& A);
Eigen::VectorXcd general_eigenvalues(const MatrixXd& A);  // any square A; in no order

// Nothing where M is not positive definite to working precision or the solver does not converge.
std::optional<EigenPairs> generalized_eigen(const MatrixXd& K, const MatrixXd& M);
std::optional<VectorXd> generalized_eigenvalues(const MatrixXd& K, const MatrixXd& M);

struct Svd {
  MatrixXd U;      // m x k, k = min(m, n)
  VectorXd sigma;  // k, descending
  MatrixXd V;      // n x k
};
Svd thin_svd(const MatrixXd& A);
VectorXd singular_values(const MatrixXd& A);          // descending
VectorXd singular_values(const Eigen::MatrixXcd& A);  // descending
double spectral_norm(const MatrixXd& A);              // max |A x| / |x|, by A^T A: 0 of an empty matrix

}  // namespace mb
