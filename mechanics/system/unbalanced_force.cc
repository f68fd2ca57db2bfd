#include "mechanics/system/unbalanced_force.h"

namespace mb {

namespace {

const System& consistent(const System& system) {
  require_consistent(system);
  return system;
}

const SparseMatrix& chosen(const System& system, UnbalancedForce::Mass mass) {
  const bool lumped = mass == UnbalancedForce::Mass::lumped_if_any && system.lumped_mass.rows() > 0;
  return lumped ? system.lumped_mass : system.M;
}

MatrixXd orthonormal_in(const SparseMatrix& M, const MatrixXd& R) {
  if (R.cols() == 0) return R;
  const MatrixXd gram = R.transpose() * (M * R);
  return gram.llt().matrixU().solve<Eigen::OnTheRight>(R);
}

}  // namespace

UnbalancedForce::UnbalancedForce(const System& system, Mass mass)
    : system_(consistent(system)),
      M_(chosen(system, mass)),
      R_(&M_ == &system.M ? system.R : orthonormal_in(M_, system.R)),
      K_product_(system.K),
      low_rank_(system.damping.alpha, system.damping.alpha != 0 ? MatrixXd(M_ * R_) : MatrixXd(), system.modal_damping),
      factors_(system),
      w_(system.u0.size()) {
  if (system.damping.alpha != 0) M_product_.emplace(M_);
  if (system.viscous.rows() > 0) viscous_product_.emplace(system.viscous);
}

void UnbalancedForce::operator()(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  const auto [alpha, beta] = system_.damping;
  if (beta != 0) {
    w_.noalias() = u + beta * v;
    K_product_(w_, f);
  } else {
    K_product_(u, f);
  }
  if (M_product_) {
    (*M_product_)(v, w_);
    f.noalias() += alpha * w_;
  }
  if (viscous_product_) {
    (*viscous_product_)(v, w_);
    f += w_;
  }
  low_rank_.add_product(1, v, f);
  f = -f;
  add_load(t, f);
}

void UnbalancedForce::without_damping(double t, const VectorXd& u, VectorXd& f) const {
  K_product_(u, f);
  f = -f;
  add_load(t, f);
}

void UnbalancedForce::add_load(double t, VectorXd& f) const {
  const VectorXd& s = factors_(t);
  if (!s.isZero(0)) f.noalias() += system_.F * s;
}

}  // namespace mb
