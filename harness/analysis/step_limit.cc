#include "harness/analysis/step_limit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

namespace mb {

namespace {

void expect_modes(const VectorXd& omega, const VectorXd& zeta) {
  if (omega.size() == 0 || omega.size() != zeta.size() || !(omega.minCoeff() > 0))
    throw std::invalid_argument("a step limit needs modes of positive frequency, and the damping of each");
}

}  // namespace

StepLimit measured_limit(const Scheme& scheme, const VectorXd& omega, const VectorXd& zeta) {
  expect_modes(omega, zeta);
  StepLimit least{std::numeric_limits<double>::infinity(), 0};
  for (Index i = 0; i < omega.size(); ++i) {
    const double dt = stable_omega_h(scheme, zeta(i)) / omega(i);
    if (dt < least.dt) least = {dt, i};
  }
  return least;
}

double formula_limit(const Scheme& scheme, const VectorXd& omega, const VectorXd& zeta) {
  expect_modes(omega, zeta);
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < omega.size(); ++i) {
    const double dt = scheme.formula(zeta(i)) / omega(i);
    if (std::isnan(dt)) return dt;
    least = std::min(least, dt);
  }
  return least;
}

double bar_of_limit(double zeta) { return 1e-9 + 3e-12 * zeta; }

std::vector<Scheme> explicit_schemes() {
  return {scheme("explicit-euler"), scheme("symplectic-euler"), scheme("symplectic-euler, implicit damping"),
          scheme("central-difference"), scheme("central-difference, lagged damping")};
}

System let_go(const System& system, const VectorXd& phi) {
  System alone = system;
  alone.stored_energy = nullptr;  // about rest
  alone.F.resize(system.M.rows(), 0);
  alone.s.clear();
  alone.follows.clear();
  alone.u0 = phi;
  alone.v0 = VectorXd::Zero(phi.size());
  return alone;
}

GrowthRun growth_run(const System& system, const SteppedMode& mode, const Scheme& scheme, const Integrator& integrator,
                     double dt, long most_steps) {
  using Complex = std::complex<double>;
  const Matrix2d A = scheme.amplification(mode.omega * dt, mode.zeta);
  const Complex root = std::sqrt(Complex(A.trace() * A.trace() / 4 - A.determinant()));
  const Complex plus = A.trace() / 2 + root, minus = A.trace() / 2 - root;
  const Complex lambda = std::abs(plus) >= std::abs(minus) ? plus : minus, mu = A.trace() - lambda;
  const double rate = std::log(std::abs(lambda)), wanted = std::log(3) / std::max(std::abs(rate), 1e-12);
  const long n = std::min(most_steps, std::max(20L, std::lround(std::ceil(std::min(wanted, 1e9)))));

  System alone = let_go(system, mode.phi);
  if (lambda.imag() == 0) {
    const Eigen::Vector2d start = Eigen::Vector2d(A(0, 1), lambda.real() - A(0, 0)).normalized();
    alone.u0 = start(0) * mode.phi;
    alone.v0 = start(1) / dt * mode.phi;
  }
  Settings settings;
  settings.time_step = dt;
  VectorXd times(4);  // from the second step on, the first one may differ from the rest
  times << dt, 2 * dt, static_cast<double>(n + 1) * dt, static_cast<double>(n + 2) * dt;
  const States states = integrator.prepare(alone, settings, times(3))->run(times);
  GrowthRun run{dt, n, std::pow(std::abs(lambda), static_cast<double>(n)), std::numeric_limits<double>::quiet_NaN(),
                static_cast<double>(n) * mode.omega * dt};
  if (states.status != Status::ok) return run;
  const VectorXd y = states.u.transpose() * mode.M_phi;
  run.observed = std::abs(y(3) - mu * y(2)) / std::abs(y(1) - mu * y(0));
  return run;
}

namespace {

// [-] Of a logarithm of growth: below it rounding of n steps may be 1 %, where 4e-9 over 8000 is the most that was
// seen.
constexpr double least_logarithm = 1e-6;
constexpr double rounding_of_step = 4e-12;  // [-] of a logarithm: twice what is seen of a rod of aspect 200

double scale_of(const GrowthRun& run) { return std::max(std::abs(std::log(run.theory)), least_logarithm); }

}  // namespace

double difference_of_logarithms(const GrowthRun& run) {
  return (std::log(run.observed) - std::log(run.theory)) / scale_of(run);
}

double bar_of_growth(const GrowthRun& run) {
  return rounding_of_step * static_cast<double>(run.n_steps) + run.other_modes;
}

double bar_of_difference(const GrowthRun& run) { return bar_of_growth(run) / scale_of(run); }

std::string growth_verdict(const GrowthRun& run) {
  if (std::abs(std::log(run.theory)) < 0.01 * least_logarithm && run.phase < 1) return "too short to tell";
  return std::abs(difference_of_logarithms(run)) <= 0.01 ? "confirmed" : "not confirmed";
}

GrowthRun growth_run(const System& system, const SteppedMode& mode, const Integrator& integrator, double dt,
                     double rho) {
  const double until = 10 / std::log(rho);
  const long n = until < 200 ? std::max(20L, std::lround(until)) : 200;
  Settings settings;
  settings.time_step = dt;
  System alone = let_go(system, VectorXd::Zero(mode.phi.size()));
  alone.v0 = mode.phi;
  const auto from = static_cast<double>(n), to = 2 * from;
  const States states =
      integrator.prepare(alone, settings, (to + 1) * dt)->run(dt * VectorXd{{from, from + 1, to, to + 1}});
  const double first = (states.u.col(1) - states.u.col(0)).norm(), last = (states.u.col(3) - states.u.col(2)).norm();
  GrowthRun run{dt, n, std::pow(rho, from), last / first};
  run.other_modes = 1 / run.theory;
  return run;
}

}  // namespace mb
