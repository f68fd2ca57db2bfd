// What integrators share, the force that accelerates:
//
//   f = F s(t) - K u - C v,   C = alpha (M - M R R^T M) + beta K + W diag(d) W^T
//
// R is made orthonormal in M where that is the lumped mass, so that rigid motion stays undamped.
#pragma once

#include <optional>

#include "mechanics/system/low_rank_damping.h"
#include "mechanics/system/symmetric_product.h"
#include "mechanics/system/system.h"

namespace mb {

class UnbalancedForce {
 public:
  enum class Mass { lumped_if_any, consistent };
  // The system must outlive this; throws as require_consistent.
  explicit UnbalancedForce(const System& system, Mass mass = Mass::lumped_if_any);
  const SparseMatrix& M() const { return M_; }
  const MatrixXd& R() const { return R_; }
  // f has the size of u; no allocation; one thread at a time.
  void operator()(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const;
  void without_damping(double t, const VectorXd& u, VectorXd& f) const;  // F s - K u

 private:
  void add_load(double t, VectorXd& f) const;

  const System& system_;
  const SparseMatrix& M_;
  MatrixXd R_;
  SymmetricProduct K_product_;
  std::optional<SymmetricProduct> M_product_;        // where alpha is not 0
  std::optional<SymmetricProduct> viscous_product_;  // where there is such damping
  LowRankDamping low_rank_;
  LoadFactors factors_;
  mutable VectorXd w_;  // n
};

}  // namespace mb
