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

// F with the columns of the other kind set to 0.
MatrixXd loads(const System& system, bool turning) {
  const auto is_turning = [&](size_t l) { return !system.follows.empty() && system.follows[l]; };
  MatrixXd F = system.F;
  bool any = false;
  for (Index l = 0; l < F.cols(); ++l) {
    if (is_turning(static_cast<size_t>(l)) == turning)
      any = true;
    else
      F.col(l).setZero();
  }
  return any ? F : MatrixXd(F.rows(), 0);
}

}  // namespace

FiniteForce::FiniteForce(const System& system, Mass mass)
    : system_(checked(system)),
      F_(loads(system, false)),
      F_turning_(loads(system, true)),
      M_(mass == Mass::lumped_if_any && system.lumped_mass.rows() > 0 ? system.lumped_mass : system.M),
      M_product_(M_),
      factors_(system),
      Mv_(system.u0.size()),
      w_(system.u0.size()) {}

MatrixXd FiniteForce::rigid(const VectorXd& u) const {
  const MatrixXd R = system_.stored_energy->rigid_motions(u);
  if (R.cols() == 0) return R;
  const MatrixXd gram = R.transpose() * (M_ * R);
  return gram.llt().matrixU().solve<Eigen::OnTheRight>(R);
}

void FiniteForce::take_turned_loads(double t, const VectorXd& u, VectorXd& f) const {
  const VectorXd& s = factors_(t);
  if (s.isZero(0)) return;
  w_.noalias() = F_turning_ * s;
  for (const auto& [first, n, Q] : system_.stored_energy->turns(u)) {
    auto turned = w_.segment(first, n).reshaped(3, n / 3);
    turned = (Q * turned.matrix()).eval();
  }
  f -= w_;
}

bool FiniteForce::resistance(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  if (!system_.stored_energy->force(u, v, f)) return false;
  if (const double alpha = system_.damping.alpha; alpha != 0) {
    const MatrixXd R = rigid(u);
    M_product_(v, Mv_);
    w_ = v;
    if (R.cols() > 0) w_.noalias() -= R * (R.transpose() * Mv_).eval();
    M_product_(w_, Mv_);
    f.noalias() += alpha * Mv_;
  }
  if (F_turning_.cols() > 0) take_turned_loads(t, u, f);
  return true;
}

void FiniteForce::add_load(double t, double factor, VectorXd& f) const {
  if (F_.cols() == 0) return;
  const VectorXd& s = factors_(t);
  if (!s.isZero(0)) f.noalias() += factor * (F_ * s);
}

bool FiniteForce::operator()(double t, const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  if (!resistance(t, u, v, f)) return false;
  f = -f;
  add_load(t, 1, f);
  return true;
}

}  // namespace mb
