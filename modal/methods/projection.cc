#include "modal/methods/projection.h"

namespace mb {
namespace {

SparseMatrix diagonal(const VectorXd& d) {
  SparseMatrix D(d.size(), d.size());  // may be 0 x 0: a supported body with no elastic mode
  D.reserve(d.size());
  for (Index i = 0; i < d.size(); ++i) D.insert(i, i) = d(i);
  return D;
}

// Eigenvectors of two eigensolves of one mesh differ by the tolerance of both (1e-10) over the relative distance of the
// next frequency, but not by more: multiplets are whole in either.
constexpr double rounding = 1e-8;  // [-]

// Whether what couples two modes is no more than that angle makes of the stronger damping of either: beside a mode
// damped 10^8 times as much another one's damping still counts.
bool decouples(const MatrixXd& C) {
  const double least = rounding * rounding * C.diagonal().cwiseAbs().maxCoeff();
  for (Index j = 0; j < C.cols(); ++j)
    for (Index i = j + 1; i < C.rows(); ++i)
      if (std::abs(C(i, j)) > std::max(least, rounding * std::max(std::abs(C(i, i)), std::abs(C(j, j))))) return false;
  return true;
}

// C = W diag(d) W^T as sum of C_ii e_i e_i^T. Of a mode that W does not hold it is the square of that angle.
ModalDamping decoupled(const MatrixXd& C, double largest) {
  std::vector<Index> damped;
  for (Index i = 0; i < C.rows(); ++i)
    if (std::abs(C(i, i)) > rounding * rounding * largest) damped.push_back(i);
  return {MatrixXd::Identity(C.rows(), C.cols())(Eigen::all, damped), C.diagonal()(damped)};
}

ModalDamping project(const ModalDamping& damping, const MatrixXd& Phi) {
  if (damping.d.size() == 0 || Phi.cols() == 0) return {MatrixXd(Phi.cols(), 0), VectorXd(0)};
  const MatrixXd W = Phi.transpose() * damping.W;
  const MatrixXd C = W * damping.d.asDiagonal() * W.transpose();
  if (decouples(C)) return decoupled(C, damping.d.cwiseAbs().maxCoeff());  // columns of W: at most of unit length
  std::vector<Index> seen;                                                 // modes of W of which Phi sees anything
  for (Index k = 0; k < W.cols(); ++k)
    if (W.col(k).norm() > rounding) seen.push_back(k);
  return {W(Eigen::all, seen), damping.d(seen)};
}

Observation observe_modes(const SparseMatrix& at_points, const Modes& modes, const MatrixXd& correction) {
  return {.of_state = MatrixXd(at_points * modes.Phi), .of_load = MatrixXd(at_points * correction)};
}

}  // namespace

System project(const System& system, const Modes& modes) {
  const Index size = modes.size();
  System reduced;
  reduced.M = diagonal(VectorXd::Ones(size));
  reduced.K = diagonal(modes.omega.array().square());
  reduced.damping = system.damping;
  reduced.modal_damping = project(system.modal_damping, modes.Phi);
  reduced.R = MatrixXd::Identity(size, modes.n_rigid);
  reduced.F = modes.Phi.transpose() * system.F;
  reduced.s = system.s;
  reduced.u0 = modes.Phi.transpose() * (system.M * system.u0);
  reduced.v0 = modes.Phi.transpose() * (system.M * system.v0);
  return reduced;
}

MatrixXd residual_flexibility(const Modes& modes, const MatrixXd& F, const MatrixXd& G_F) {
  const Index n_elastic = modes.size() - modes.n_rigid;
  const auto Phi = modes.Phi.rightCols(n_elastic);
  const VectorXd flexibility = modes.omega.tail(n_elastic).array().square().inverse();
  return G_F - Phi * (flexibility.asDiagonal() * (Phi.transpose() * F));
}

LinearBody reduce(const BodyModel& body, const Modes& modes, const MatrixXd& correction) {
  return {.system = project(body.full->system(), modes),
          .displacement = observe_modes(body.displacement, modes, correction),
          .strain = observe_modes(body.strain, modes, correction)};
}

}  // namespace mb
