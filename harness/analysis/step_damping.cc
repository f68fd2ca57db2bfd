#include "harness/analysis/step_damping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Of the roots of lambda^2 - (2 + trace) lambda + (1 + trace + determinant) = 0: trace and determinant of A - I, since
// ln|lambda| would be lost in 1 at small steps.
double damping_of(double trace, double determinant) {
  constexpr double rounding = 1e-12;
  const double square = trace * trace / 4 - determinant, root = std::sqrt(std::abs(square));
  if (square < 0) {
    const double log_modulus = std::log1p(trace + determinant) / 2;
    return -log_modulus / std::hypot(log_modulus, std::atan2(root, 1 + trace / 2));
  }
  // The larger of lambda - 1 by the formula, the other by their product: a difference would lose it.
  const double far = trace / 2 + std::copysign(root, trace), near = far == 0 ? 0 : determinant / far;
  const double lower = 1 + std::min(far, near), upper = 1 + std::max(far, near);
  if (lower > 0) {
    const double product = std::log1p(far) * std::log1p(near);
    return product > 0 ? -(std::log1p(far) + std::log1p(near)) / (2 * std::sqrt(product)) : nan;
  }
  if (!(lower < 0) || (upper > 0 && !(-lower > upper + rounding))) return nan;  // neither outlasts the other
  const double log_modulus = std::log(-lower);
  return -log_modulus / std::hypot(log_modulus, pi);
}

}  // namespace

double step_damping(const Scheme& scheme, double omega_h, double zeta) {
  if (!(omega_h > 0 && std::isfinite(omega_h) && zeta >= 0 && std::isfinite(zeta)))
    throw std::invalid_argument("the damping of a step needs omega h > 0 and zeta >= 0");
  const Matrix2d B = scheme.increment(omega_h, zeta);
  return damping_of(B.trace(), B.determinant());
}

double run_damping(const System& system, const SteppedMode& mode, const Integrator& integrator, double dt) {
  constexpr Index n_samples = 6;               // enough to tell two unknowns and to even out rounding
  constexpr double most_steps = 4000;          // between samples: modes slower than that are told less precisely
  constexpr double told_from_rounding = 1e-2;  // [-] of both states' decay between samples: one may be gone
  const double steps = std::clamp(std::floor(1 / (mode.omega * dt * std::max(1.0, 2 * mode.zeta))), 1.0, most_steps);
  // Not from the start: there central differences step by the initial velocity.
  const VectorXd times = steps * dt * VectorXd::LinSpaced(n_samples, 1, n_samples);
  const System alone = let_go(system, mode.phi);
  Settings settings;
  settings.time_step = dt;
  const States states = integrator.prepare(alone, settings, times(n_samples - 1))->run(times);
  if (states.status != Status::ok) return nan;
  const VectorXd y = states.u.transpose() * mode.M_phi;
  // y_{k+2} - 2 y_{k+1} + y_k = trace (y_{k+1} - y_k) - determinant y_k, both of A^m - I.
  MatrixXd equations(n_samples - 2, 2);
  VectorXd right(n_samples - 2);
  for (Index k = 0; k + 2 < n_samples; ++k) {
    const double size = y.segment(k, 3).cwiseAbs().maxCoeff();  // growing runs are not told by their end alone
    equations.row(k) << (y(k + 1) - y(k)) / size, -y(k) / size;
    right(k) = (y(k + 2) - 2 * y(k + 1) + y(k)) / size;
  }
  if (!equations.allFinite() || !right.allFinite()) return nan;
  const VectorXd found = equations.colPivHouseholderQr().solve(right);
  if (std::abs(1 + found(0) + found(1)) < told_from_rounding) return nan;
  return damping_of(found(0), found(1));
}

}  // namespace mb
