// Inertia of a sparse symmetric matrix by Sylvester's law:
//
//   A = L D L^T        as many eigenvalues of either sign as D has entries
//
// D is the diagonal of U in A = L U with pivots on the diagonal alone (the door of SuiteSparse's UMFPACK for real
// matrices): multifrontal, which CHOLMOD is for definite matrices alone.
#pragma once

#include "mechanics/types.h"

namespace mb {

// Numbers of negative, zero and positive eigenvalues, and the residual |A x - b|_inf / (|A|_inf |x|_inf) of one solve
// with the same factor: pivots are not chosen by size, so an inertia whose residual is large must not be believed.
// residual = infinity where a pivot vanished or lay off the diagonal, whose signs say nothing then.
struct Inertia {
  Index negative, zero, positive;
  double residual;  // [-]
};

// A: n x n symmetric, compressed; the lower triangle is read. Throws std::invalid_argument for a matrix that is empty,
// not square, not compressed or not finite; std::runtime_error where memory does not suffice.
Inertia inertia(const SparseMatrix& A);

}  // namespace mb
