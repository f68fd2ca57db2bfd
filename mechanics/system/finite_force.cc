#include "mechanics/system/finite_force.h"

#include <stdexcept>

namespace mb {

namespace {

const System& checked(const System& system) {
  require_consistent(system);
  if (!system.stored_energy) throw std::invalid_argument("finite deformation: the system has no stored energy");
  if ((system.modal_damping.d.array() != 0).any())
    throw std::invalid_argument("finite deformation: damping of single modes is of linear systems");
  return system;
}

}  // namespace

FiniteForce::FiniteForce(const System& system)
    : system_(checked(system)), M_(system.M), factors_(system), Mv_(system.u0.size()), w_(system.u0.size()) {}

MatrixXd FiniteForce::rigid(const VectorXd& u) const {
  const MatrixXd R = system_.stored_energy->rigid_motions(u);
  if (R.cols() == 0) return R;
  const MatrixXd gram = R.transpose() * (system_.M * R);
  return gram.llt().matrixU().solve<Eigen::OnTheRight>(R);
}

bool FiniteForce::resistance(const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  if (!system_.stored_energy->force(u, v, f)) return false;
  if (const double alpha = system_.damping.alpha; alpha != 0) {
    const MatrixXd R = rigid(u);
    M_(v, Mv_);
    w_ = v;
    if (R.cols() > 0) w_.noalias() -= R * (R.transpose() * Mv_).eval();
    M_(w_, Mv_);
    f.noalias() += alpha * Mv_;
  }
  return true;
}

void FiniteForce::add_load(double t, double factor, VectorXd& f) const {
  const VectorXd& s = factors_(t);
  if (!s.isZero(0)) f.noalias() += factor * (system_.F * s);
}

bool FiniteForce::operator()(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  if (!resistance(u, v, f)) return false;
  f = -f;
  add_load(t, 1, f);
  return true;
}

}  // namespace mb
