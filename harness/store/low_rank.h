// A matrix as the product of two thin ones:
//
//   A = L R,   L = U S, R = V^T from the singular value decomposition A = U S V^T, cut where sigma <= tolerance *
//   sigma_1
//
// Values over time of a smooth motion have few singular values that matter. The error |A - L R|_2 is at most
// tolerance * |A|_2: relative to the largest motion, not to each entry. Eckart & Young 1936, Psychometrika 1(3).
#pragma once

#include <optional>

#include "mechanics/types.h"

namespace mb {

struct LowRank {
  MatrixXd left;   // m x rank
  MatrixXd right;  // rank x n
};

// tolerance [-] in [0, 1). Nothing where the factors would not be smaller than A, where A is not finite or empty, or
// where they fail to reproduce A. Householder QR first, so that the decomposition is one of min(m, n)^2 values.
std::optional<LowRank> low_rank(const MatrixXd& A, double tolerance);

}  // namespace mb
