// Modes found twice, compared where single vectors mean nothing: within a cluster of frequencies any basis will do.
//
//   sine of the largest angle between two spans = |A - B B^T M A|_M = |B - A A^T M B|_M,   A^T M A = B^T M B = I
//
// |.|_M the largest singular value in the M norm. Golub & Van Loan 2013, Matrix Computations, sect. 6.4.3.
#pragma once

#include <vector>

#include "mechanics/types.h"

namespace mb {

struct Cluster {
  Index first, n;
};
// Of lambda[n_rigid] on, ascending: neighbours that differ by at most `gap` [-] of the larger, or by least_gap
// [1/s^2], are of one cluster. Throws std::invalid_argument for lambda out of order or not finite.
std::vector<Cluster> clusters(const VectorXd& lambda, Index n_rigid, double gap, double least_gap = 0);

// [-] relative distance of a cluster from the nearest elastic eigenvalue outside it; infinity where there is none.
double gap_around(const VectorXd& lambda, Index n_rigid, const Cluster& cluster);

// A, B: n x k of the same size. The larger of both expressions above: a basis in which a vector stands twice, which is
// not orthonormal, lies in the span of the other and shows in the second alone. Throws std::invalid_argument for sizes
// that do not fit and vectors that are not finite.
double subspace_distance(const SparseMatrix& M, const MatrixXd& A, const MatrixXd& B);

}  // namespace mb
