// A matrix as the product of two thin ones:
//
//   A ~ L R,   L = Q U S, R = V^T,   Q^T A = U S V^T cut at small sigma,   |A - L R|_2 <= tolerance |A|_2
//
// Q is an orthonormal basis that grows with the columns of A, a block at a time, by what it does not hold of them yet.
// Values over time of a smooth motion have few singular values that matter, r: 8 m n r operations, where the
// singular value decomposition of A takes 20 m n min(m, n). The error is relative to the largest motion, not to each
// entry. Eckart & Young 1936, Psychometrika 1(3); Halko, Martinsson & Tropp 2011, SIAM Review 53(2), section 4.
#pragma once

#include <optional>

#include "mechanics/types.h"

namespace mb {

struct LowRank {
  MatrixXd left;   // m x rank
  MatrixXd right;  // rank x n
};

// tolerance [-] in [0, 1). Nothing where the factors would not be smaller than A, where A is not finite or empty, or
// where they fail to reproduce A.
std::optional<LowRank> low_rank(const MatrixXd& A, double tolerance);

}  // namespace mb
