// What explicit steps share, the force that accelerates:
//
//   f = F s(t) - K u - C v,   C = alpha (M - M R R^T M) + beta K + W diag(d) W^T
//
// M is the lumped mass where the system has one; R is then made orthonormal in it, so that rigid motion stays undamped.
#pragma once

#include <optional>

#include "mechanics/system/low_rank_damping.h"
#include "mechanics/system/symmetric_product.h"
#include "mechanics/system/system.h"

namespace mb {

class UnbalancedForce {
 public:
  explicit UnbalancedForce(const System& system);  // which must outlive this; throws as require_consistent
  const SparseMatrix& M() const { return M_; }
  const MatrixXd& R() const { return R_; }
  // f has the size of u; no allocation; one thread at a time.
  void operator()(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const;

 private:
  const System& system_;
  const SparseMatrix& M_;
  MatrixXd R_;
  SymmetricProduct K_product_;
  std::optional<SymmetricProduct> M_product_;  // where alpha is not 0
  LowRankDamping low_rank_;
  LoadFactors factors_;
  mutable VectorXd w_;  // n
};

}  // namespace mb
