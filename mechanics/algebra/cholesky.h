// Sparse Cholesky factorisation (the door of SuiteSparse's CHOLMOD), supernodal, for symmetric positive definite A:
//
//   A = L L^T
#pragma once

#include <memory>

#include "mechanics/types.h"

namespace mb {

// Solves may be called from several threads; on one object they take turns.
class Cholesky {
 public:
  // A: n x n symmetric positive definite, compressed; the lower triangle is read. Throws std::runtime_error with the
  // first column whose pivot is not positive, or where A is singular to working precision; std::invalid_argument for
  // a matrix that is empty, not square, not compressed or not finite.
  explicit Cholesky(const SparseMatrix& A);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  // Same sparsity pattern, new values: the symbolic factorisation is reused. Where it throws, the factor is lost.
  void refactor(const SparseMatrix& A);

  VectorXd solve(const VectorXd& b) const;
  MatrixXd solve(const MatrixXd& b) const;
  void solve(const double* b,
             double* x) const;  // one right-hand side of size n; b and x may be the same; no allocation

  Index size() const;
  double nonzeros() const;  // of L

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mb
