// The stored energy of bodies side by side (joined.h), of which some are linear:
//
//   W = sum_b W_b(u_b),   f = (f_1, f_2, ...),   of a linear body W_b = u_b^T K_b u_b / 2, f_b = K_b u_b + beta_b K_b
//   v_b
//
// A linear body's rigid motions are R's, about where it was at rest.
#pragma once

#include <vector>

#include "mechanics/system/stored_energy.h"
#include "mechanics/system/system.h"

namespace mb {

class JoinedEnergy final : public StoredEnergy {
 public:
  explicit JoinedEnergy(const std::vector<System>& systems);

  double energy(const VectorXd& u) const override;
  bool force(const VectorXd& u, const VectorXd& v, VectorXd& f) const override;
  bool add_tangent(const VectorXd& u, double by_u, double by_v, SparseMatrix& A) const override;
  std::vector<Turn> turns(const VectorXd& u) const override;
  MatrixXd rigid_motions(const VectorXd& u) const override;

 private:
  struct Part {
    std::shared_ptr<const StoredEnergy> finite;  // nullptr: linear
    SparseMatrix K;
    double beta;  // [s] of a linear body
    MatrixXd R;
    Index first, n;
  };
  std::vector<Part> parts_;
};

}  // namespace mb
