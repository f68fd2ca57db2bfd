// Sparse factorisations (the door of SuiteSparse's CHOLMOD).
//
//   A = L L^T          supernodal, for symmetric positive definite A: solves
//   A = L D L^T        simplicial, for symmetric indefinite A: inertia by Sylvester's law
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

// Numbers of negative, zero and positive eigenvalues of a symmetric A (the signs of D), and the residual
// |A x - b|_inf / (|A|_inf |x|_inf) of one solve with the same factor: D is found without pivoting, so an inertia whose
// residual is large must not be believed. residual = infinity where a pivot vanished.
struct Inertia {
  Index negative, zero, positive;
  double residual;  // [-]
};
Inertia inertia(const SparseMatrix& A);

}  // namespace mb
