// The operator of every implicit step, on one SPD factor:
//
//   A = M + gamma C + kappa K = S + gamma V diag(e) V^T,
//   S = (1 + gamma alpha) M + (gamma beta + kappa) K + gamma C_viscous = L L^T
//   A^-1 b = S^-1 b - Y G Y^T b,   Y = S^-1 V,   G = (I + gamma diag(e) V^T Y)^-1 gamma diag(e)
//
// with V diag(e) V^T the damping of low rank (rigid modes exempted, modes with ratios of their own;
// low_rank_damping.h): Sherman, Morrison and Woodbury's formula. Since S^-1 M R = R / (1 + gamma alpha), the rigid
// modes cost no solve.
#pragma once

#include "mechanics/algebra/inverse.h"
#include "mechanics/system/low_rank_damping.h"
#include "mechanics/system/spd_factor.h"
#include "mechanics/system/system.h"

namespace mb {

class Shifted final : public Inverse {
 public:
  Shifted(const System& system, double gamma);  // kappa = gamma^2; gamma [s] > 0; the system must outlive this
  Shifted(const System& system, double gamma, double kappa);  // gamma [s] > 0, kappa [s^2] >= 0
  void set_gamma(double gamma);                               // kappa = gamma^2; refactors, keeping the symbolic part
  double gamma() const { return gamma_; }
  const LowRankDamping& low_rank() const { return low_rank_; }
  bool is_diagonal() const { return factor_.is_diagonal(); }
  void solve(const VectorXd& b, VectorXd& x) const override;

 private:
  SparseMatrix sparse_part(double gamma, double kappa) const;  // S, with V diag(e) V^T where that is diagonal
  void correct_rank();                                         // Y and G

  const System* system_;
  double gamma_;
  LowRankDamping low_rank_;
  SpdFactor factor_;
  MatrixXd Y_, G_;
  mutable VectorXd coordinates_, corrections_;
};

}  // namespace mb
