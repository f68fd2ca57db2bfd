// x = A^-1 b, for who needs no more of A.
#pragma once

#include <vector>

#include "mechanics/types.h"

namespace mb {

class Inverse {
 public:
  virtual ~Inverse() = default;
  // x may be b; no allocation once x has its size. One thread at a time.
  virtual void solve(const VectorXd& b, VectorXd& x) const = 0;
  // A^-1 e_j for every j of `which`, each in [0, n), A n x n.
  virtual MatrixXd columns(const std::vector<Index>& which, Index n) const {
    MatrixXd all(n, static_cast<Index>(which.size()));
    VectorXd e = VectorXd::Zero(n), x(n);
    for (size_t k = 0; k < which.size(); ++k) {
      e[which[k]] = 1;
      solve(e, x);
      e[which[k]] = 0;
      all.col(static_cast<Index>(k)) = x;
    }
    return all;
  }
};

}  // namespace mb
