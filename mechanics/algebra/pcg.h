// Conjugate gradients for a symmetric A that may be singular, preconditioned by B and, on request, projected:
//
//   A x = b,   z = P B r,   P = I - R R^T M  (R: the null space of A, R^T M R = I),   so that R^T M x = 0
//
// Hestenes & Stiefel 1952, J. Res. NBS 49(6). For singular A, b must lie in its range.
#pragma once

#include <functional>

#include "mechanics/types.h"

namespace mb {

using LinearMap = std::function<VectorXd(const VectorXd&)>;

struct PcgSolution {
  VectorXd x;
  int iterations;
  double residual;  // [-] |b - A x| / |b|, of x itself, not of the recurrence
};

// tolerance [-] > 0: on |b - A x| / |b|. Where the rounding of A x alone is larger than that, it counts instead.
// project: P applied to a vector, empty for none. Throws std::runtime_error where max_iterations (>= 1) do not suffice
// or A or B turns out not to be positive semi-definite.
PcgSolution pcg(const SparseMatrix& A, const VectorXd& b, const LinearMap& precondition, double tolerance,
                int max_iterations, const LinearMap& project = {});

}  // namespace mb
