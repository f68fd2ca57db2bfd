// The largest eigenvalues of an operator T that is self-adjoint in the inner product of B, by implicitly restarted
// Lanczos (the door of ARPACK):
//
//   T x = theta x,   x^T B T y = (T x)^T B y
//
// Lehoucq, Sorensen & Yang 1998, ARPACK Users' Guide, SIAM.
#pragma once

#include <functional>

#include "mechanics/types.h"

namespace mb {

// T x, given x and B x (a shift-invert operator needs B x only, another one x only).
using Operator = std::function<VectorXd(const VectorXd& x, const VectorXd& Bx)>;
using InnerProduct = std::function<VectorXd(const VectorXd& x)>;  // B x, B SPD on the range of T

struct RitzPairs {
  VectorXd theta;       // descending
  MatrixXd vectors;     // n x n_wanted, B-orthonormal to about the tolerance
  long n_applications;  // of T
};

// start: n, not zero; the same start gives the same answer. 1 <= n_wanted < n_vectors <= n, n_vectors the Lanczos
// vectors kept. tolerance [-]: |error of theta| / theta; 0 stands for the rounding unit. Throws std::invalid_argument
// on bad sizes, std::runtime_error where ARPACK fails.
RitzPairs largest_ritz(const Operator& apply, const InnerProduct& inner_product, int n_wanted, int n_vectors,
                       double tolerance, const VectorXd& start);

}  // namespace mb
