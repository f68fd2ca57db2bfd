#include "mechanics/system/shifted.h"

#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

LowRankDamping low_rank_damping(const System& s) {
  return {s.damping.alpha, s.damping.alpha != 0 ? MatrixXd(s.M * s.R) : MatrixXd(), s.modal_damping};
}

double positive(double gamma) {
  if (!(gamma > 0 && std::isfinite(gamma))) throw std::invalid_argument("Shifted: gamma must be positive and finite");
  return gamma;
}

}  // namespace

Shifted::Shifted(const System& system, double gamma) : Shifted(system, gamma, gamma * gamma) {}

Shifted::Shifted(const System& system, double gamma, double kappa)
    : system_(&system),
      gamma_(positive(gamma)),
      low_rank_(low_rank_damping(system)),
      factor_(sparse_part(gamma, kappa)) {
  correct_rank();
}

SparseMatrix Shifted::sparse_part(double gamma, double kappa) const {
  const auto [alpha, beta] = system_->damping;
  SparseMatrix S = (1 + gamma * alpha) * system_->M;
  if (gamma * beta + kappa != 0) S += (gamma * beta + kappa) * system_->K;
  if (system_->viscous.rows() > 0) S += gamma * system_->viscous;
  for (Index i = 0; i < low_rank_.diagonal().size(); ++i) S.coeffRef(i, i) += gamma * low_rank_.diagonal()[i];
  S.makeCompressed();
  return S;
}

void Shifted::correct_rank() {
  const Index rank = low_rank_.rank(), n_rigid = low_rank_.n_rigid();
  if (rank == 0) return;
  const MatrixXd& V = low_rank_.V();
  const MatrixXd modal = V.rightCols(rank - n_rigid);
  Y_.resize(V.rows(), rank);
  Y_.leftCols(n_rigid) = system_->R.leftCols(n_rigid) / (1 + gamma_ * system_->damping.alpha);
  if (modal.cols() > 0) Y_.rightCols(modal.cols()) = factor_.solve(modal);
  const MatrixXd E = gamma_ * MatrixXd(low_rank_.e().asDiagonal());
  G_ = (MatrixXd::Identity(rank, rank) + E * (V.transpose() * Y_)).partialPivLu().solve(E);
  coordinates_.resize(rank);
  corrections_.resize(rank);
}

void Shifted::set_gamma(double gamma) {
  gamma_ = positive(gamma);
  factor_.refactor(sparse_part(gamma, gamma * gamma));
  correct_rank();
}

void Shifted::solve(const VectorXd& b, VectorXd& x) const {
  if (low_rank_.rank() > 0) {
    coordinates_.noalias() = Y_.transpose() * b;
    corrections_.noalias() = G_ * coordinates_;
  }
  factor_.solve(b.data(), x.data());
  if (low_rank_.rank() > 0) x.noalias() -= Y_ * corrections_;
}

}  // namespace mb
