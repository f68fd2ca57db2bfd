#include "mechanics/system/shifted.h"

namespace mb {

namespace {

SparseMatrix shifted_matrix(const System& s, double gamma) {
  return (1 + gamma * s.damping.alpha) * s.M + (gamma * s.damping.beta + gamma * gamma) * s.K;
}

}  // namespace

Shifted::Shifted(const System& system, double gamma)
    : system_(&system), gamma_(gamma), factor_(shifted_matrix(system, gamma)) {}

void Shifted::set_gamma(double gamma) {
  gamma_ = gamma;
  factor_.refactor(shifted_matrix(*system_, gamma));
}

void Shifted::solve(const VectorXd& b, VectorXd& x) const {
  const double g = gamma_ * system_->damping.alpha;
  const MatrixXd& R = system_->R;
  if (g == 0 || R.cols() == 0) {
    factor_.solve(b.data(), x.data());
    return;
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> rigid = R.transpose() * b;  // no heap: at most six
  factor_.solve(b.data(), x.data());
  x.noalias() += R * (g / (1 + g) * rigid);
}

}  // namespace mb
