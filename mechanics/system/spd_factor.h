// A x = b for symmetric positive definite A: division where A is diagonal (reduced systems, lumped mass), else a sparse
// Cholesky factor.
#pragma once

#include <optional>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/types.h"

namespace mb {

class SpdFactor {
 public:
  // A: as Cholesky wants it, but may have no rows. Throws std::runtime_error where A is not positive definite.
  explicit SpdFactor(const SparseMatrix& A);
  void refactor(const SparseMatrix& A);  // same sparsity pattern: the symbolic factorisation is reused

  void solve(const double* b, double* x) const;  // b and x may be the same; no allocation
  VectorXd solve(const VectorXd& b) const;
  MatrixXd solve(const MatrixXd& b) const;
  bool is_diagonal() const { return !factor_; }  // nothing was factorised

 private:
  void invert(const VectorXd& diagonal);

  VectorXd inverse_;  // of the diagonal
  std::optional<Cholesky> factor_;
};

}  // namespace mb
