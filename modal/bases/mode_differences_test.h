// For tests: elastic modes of one body found twice, compared cluster by cluster.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/algebra/worse_test.h"
#include "modal/bases/subspaces.h"

namespace mb::testing {

struct ModeDifferences {
  double frequency = 0;  // [-] largest, relative
  double subspace = 0;   // [-] largest sine of an angle, times the relative gap around its cluster, 1 at most
  Index n = 0;           // modes compared
};

// Clusters are apart by a thousandth, so that pairs which are closer, degenerate or nearly so, count as a whole; as far
// as the next one of both shows that a cluster ends. Sines: a residual turns a subspace by itself over the gap.
inline ModeDifferences mode_differences(const SparseMatrix& M, Index n_rigid, const VectorXd& lambda,
                                        const MatrixXd& Phi, const VectorXd& other_lambda, const MatrixXd& other_Phi) {
  if (!other_lambda.allFinite()) throw std::invalid_argument("an eigenvalue is not finite");
  ModeDifferences worst;
  for (const Cluster& c : clusters(lambda, n_rigid, 1e-3)) {
    if (c.first + c.n >= std::min(lambda.size(), other_lambda.size())) break;
    const double distance = subspace_distance(M, Phi.middleCols(c.first, c.n), other_Phi.middleCols(c.first, c.n));
    const VectorXd ratio = other_lambda.segment(c.first, c.n).cwiseQuotient(lambda.segment(c.first, c.n));
    worst.frequency = worse((ratio.cwiseSqrt().array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), worst.frequency);
    worst.subspace = worse(worst.subspace, distance * std::min(1.0, gap_around(lambda, n_rigid, c)));
    worst.n += c.n;
  }
  return worst;
}

}  // namespace mb::testing
