// What accelerates a body of finite deformation (stored_energy.h):
//
//   M v' = F s(t) + Q(u) F' s'(t) - f(u, v) - alpha M (v - R R^T M v)
//
// Q: rotation of the body (stored_energy.h), with which loads F' turn that follow it.
// R: rigid velocities about the present places, R^T M R = 1, so that mass-proportional damping brakes no rotation of
// the body as it is, nor its free fall; v^T M (v - R R^T M v) >= 0.
#pragma once

#include "mechanics/system/stored_energy.h"
#include "mechanics/system/symmetric_product.h"
#include "mechanics/system/system.h"

namespace mb {

class FiniteForce {
 public:
  // The system must outlive this. Throws std::invalid_argument for one without a stored energy, for damping of single
  // modes and as require_consistent. M of the damping: the lumped one for steps that accelerate with it.
  enum class Mass { consistent, lumped_if_any };
  explicit FiniteForce(const System& system, Mass mass = Mass::consistent);

  // [N] n; false: the deformation inverts, f is not to be used. One thread at a time.
  bool operator()(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const;
  // What depends on the motion, turned round: f(u, v) + alpha M (v - R R^T M v) - Q(u) F' s'(t)
  bool resistance(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const;
  void add_load(double t, double factor, VectorXd& f) const;  // f += factor F s(t), of loads that do not turn
  void mass(const VectorXd& v, VectorXd& Mv) const { M_product_(v, Mv); }
  const SparseMatrix& M() const { return M_; }
  MatrixXd rigid(const VectorXd& u) const;  // R, n x m

 private:
  void take_turned_loads(double t, const VectorXd& u, VectorXd& f) const;

  const System& system_;
  MatrixXd F_, F_turning_;  // n x loads: of either kind, 0 in the other's columns; of no columns where there is none
  const SparseMatrix& M_;
  SymmetricProduct M_product_;
  LoadFactors factors_;
  mutable VectorXd Mv_, w_;
};

}  // namespace mb
