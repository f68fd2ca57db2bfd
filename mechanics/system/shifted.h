// The operator of every implicit step, on one SPD factor:
//
//   A = M + gamma C + gamma^2 K,   S = (1 + gamma alpha) M + (gamma beta + gamma^2) K = L L^T
//   A^-1 b = S^-1 b + gamma alpha / (1 + gamma alpha) R R^T b
//
// since A = S - gamma alpha M R R^T M, S^-1 M R = R / (1 + gamma alpha) and R^T M R = I (Sherman-Morrison-Woodbury).
#pragma once

#include "mechanics/algebra/cholesky.h"
#include "mechanics/system/system.h"

namespace mb {

class Shifted {
 public:
  Shifted(const System& system, double gamma);  // gamma [s] > 0; the system must outlive this
  void set_gamma(double gamma);                 // refactors, keeping the symbolic factorisation
  double gamma() const { return gamma_; }
  void solve(const VectorXd& b, VectorXd& x) const;  // x = A^-1 b without allocation once x has its size

 private:
  const System* system_;
  double gamma_;
  Cholesky factor_;
};

}  // namespace mb
