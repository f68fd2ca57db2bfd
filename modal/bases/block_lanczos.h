// The largest eigenvalues of an operator T that is self-adjoint in the inner product of M, by block Lanczos with full
// reorthogonalisation and thick restarts:
//
//   T V = V H + W B E^T,   V^T M V = I,   H y = theta y:   |T x - theta x|_M = |B y_last|  for x = V y
//
// A block holds the copies of a multiplet from the start, which single vectors find late and through rounding alone,
// and lets the factor of a shift-invert operator be read once for all its columns. Golub & Underwood 1977, in
// Mathematical Software III; Wu & Simon 2000, SIAM J. Matrix Anal. Appl. 22(2) (restarts).
#pragma once

#include <functional>

#include "mechanics/types.h"

namespace mb {

using BlockOperator = std::function<MatrixXd(const MatrixXd& MX)>;  // T X, given M X
using BlockProduct = std::function<MatrixXd(const MatrixXd& X)>;    // M X, M SPD

struct LargestPairs {
  VectorXd theta;    // descending
  MatrixXd vectors;  // n x number of pairs, M-orthonormal to about the tolerance; T / theta was applied to them once
  long n_columns;    // that T was applied to
};

struct Krylov {
  Index n_vectors;   // kept at most, restarted beyond; > 2 blocks
  double tolerance;  // [-] > 0: on |T x - theta x|_M / theta, or 64 eps of the largest theta
};

// known: n x m, m >= 0, M-orthonormal eigenvectors to stay away from; start: n x block, of full rank beside them.
// missing: told the eigenvalues found so far, from the largest on without a gap, how many more are wanted at the least;
// 0 ends the search. All that are found come back, fewer than wanted only where T leaves the span of what start leads
// to; the same start gives the same answer. Throws std::invalid_argument on bad sizes, std::runtime_error after 100
// restarts or where T gives what is not finite.
LargestPairs largest_pairs(const BlockOperator& T, const BlockProduct& M, const MatrixXd& known, const MatrixXd& start,
                           const std::function<Index(const VectorXd& theta)>& missing, const Krylov& krylov);

}  // namespace mb
