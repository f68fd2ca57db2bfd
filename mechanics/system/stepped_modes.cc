#include "mechanics/system/stepped_modes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/system/symmetric_product.h"

namespace mb {

namespace {

constexpr double decoupled = 1e-8;  // [-]

// Of what is left below that, a mode damped 10^8 times as much as another one leaves nothing.
bool couples(const MatrixXd& C) {
  const double rounding = decoupled * decoupled * C.diagonal().cwiseAbs().maxCoeff();
  for (Index j = 0; j < C.cols(); ++j)
    for (Index i = j + 1; i < C.rows(); ++i) {
      const double larger = std::max(std::abs(C(i, i)), std::abs(C(j, j)));
      if (std::abs(C(i, j)) > std::max(rounding, decoupled * larger)) return true;
    }
  return false;
}

MatrixXd damping_matrix(const System& system) {
  const Index n = system.M.rows();
  MatrixXd C(n, n);
  for (Index j = 0; j < n; ++j) C.col(j) = apply_damping(system, VectorXd::Unit(n, j));
  return C;
}

}  // namespace

bool is_in_modes(const System& system) {
  return is_diagonal(system.M) && is_diagonal(system.K) && (VectorXd(system.M.diagonal()).array() == 1).all();
}

SteppedModes stepped_modes(const System& system) {
  if (!is_in_modes(system)) throw std::invalid_argument("stepped modes: the system is not in modal coordinates");
  const Index n_elastic = system.M.rows() - system.R.cols();
  const VectorXd lambda = system.K.diagonal();
  SteppedModes modes;
  modes.omega = lambda.tail(n_elastic).cwiseSqrt();
  const auto [alpha, beta] = system.damping;
  VectorXd c = (alpha + beta * lambda.array()).matrix();
  if (system.modal_damping.d.size() > 0 || system.viscous.rows() > 0) {
    MatrixXd C = damping_matrix(system);
    c = C.diagonal();
    if (couples(C)) modes.coupled = {lambda.asDiagonal(), std::move(C)};
  }
  modes.zeta = (c.tail(n_elastic).array() / (2 * modes.omega.array())).cwiseMax(0);
  if (system.lumped_mass.rows() > 0 && alpha != 0) {
    modes.zeta_by_mean = alpha / 2 * modes.omega.cwiseInverse();
    if (modes.coupled.K.size() > 0) {
      modes.coupled.by_mean = VectorXd::Constant(c.size(), alpha);
      modes.coupled.by_mean.head(system.R.cols()).setZero();
    }
  }
  return modes;
}

double step_radius(const SteppedModes& modes, const Scheme& scheme, double h) {
  const bool splits = scheme.name == "central-difference, lagged damping" && modes.zeta_by_mean.size() > 0;
  if (modes.coupled.K.size() > 0) return spectral_radius(one_step(modes.coupled, scheme.name, h));
  double largest = 0;
  for (Index i = 0; i < modes.omega.size(); ++i)
    largest = std::max(
        largest, spectral_radius(splits ? lagged_amplification(modes.omega(i) * h, modes.zeta(i), modes.zeta_by_mean(i))
                                        : scheme.amplification(modes.omega(i) * h, modes.zeta(i))));
  return largest;
}

}  // namespace mb
