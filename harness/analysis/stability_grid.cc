#include "harness/analysis/stability_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/analysis/modal_body.h"
#include "harness/analysis/step_limit.h"
#include "mechanics/system/exact.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double transient = 100;          // [-] of energy, beside what grows by rho^2 a step
constexpr double not_growing = 1 + 1e-12;  // [-] rho but for rounding

// Where a part of the damping, that of the mass, does not lag, the modes say so (stepped_modes.h).
const Scheme* scheme_of_steps(const std::string& integrator, const System& system) {
  if (const Scheme* one = scheme_of(integrator, system)) return one;
  return integrator == "central-difference" ? &scheme("central-difference, lagged damping") : nullptr;
}

// u0 = +-1/omega_i: kinetic energy none, strain energy 1/2 in every elastic mode.
System in_free_vibration(const MappedSystem& mapped) {
  const Index n = mapped.system.M.rows(), n_elastic = mapped.modes.omega.size();
  VectorXd u = VectorXd::Zero(n);
  for (Index i = 0; i < n_elastic; ++i) u(n - n_elastic + i) = (i % 2 ? -1 : 1) / mapped.modes.omega(i);
  return let_go(mapped.system, u);
}

Settings stepping_by(double dt) {
  Settings settings;
  settings.time_step = dt;
  return settings;
}

// E(t)/E(0) of that motion `scale` times as large.
double largest_energy(const MappedSystem& mapped, const Integrator& integrator, double dt, long n_steps,
                      double scale = 1) {
  System free = in_free_vibration(mapped);
  free.u0 *= scale;
  const VectorXd times = VectorXd::LinSpaced(n_steps, dt, static_cast<double>(n_steps) * dt);
  const States states = integrator.prepare(free, stepping_by(dt), times(n_steps - 1))->run(times);
  if (states.status != Status::ok) return std::numeric_limits<double>::infinity();
  const VectorXd k = free.K.diagonal();
  const VectorXd twice = states.v.colwise().squaredNorm().transpose() +
                         (k.asDiagonal() * states.u).cwiseProduct(states.u).colwise().sum().transpose();
  return twice.maxCoeff() / (scale * scale * static_cast<double>(mapped.modes.omega.size()));
}

double error_of_steps(const MappedSystem& mapped, const Integrator& integrator, double dt) {
  const double end = mapped.times(mapped.times.size() - 1);
  const States states = integrator.prepare(mapped.system, stepping_by(dt), end)->run(mapped.times);
  if (states.status != Status::ok) return std::numeric_limits<double>::infinity();
  return (states.u.bottomRows(mapped.modes.omega.size()) - mapped.exact).norm() / mapped.exact.norm();
}

// Of one mode that starts at rest, x = omega h, a = c h: see the header. NaN where its step turns it round no more.
double swing_of_symplectic_euler(double x, double a) {
  const double least = 1 - a / 2 - std::hypot(a, a / x - x) / 2;
  return least > 0 ? 1 / least : nan;
}

// Of central differences whose damping lags, likewise.
double swing_of_lagged_differences(double x, double a) {
  const Matrix2d Q{{x * (1 - a), (a - x * x) / 2}, {(a - x * x) / 2, x}};
  if (!(a < 1 && Q.determinant() > 0)) return nan;
  const Eigen::Vector2d l{1 - a / 2, -x / 2}, start{x / (2 * (1 - a)), 1};
  const Matrix2d energy = l * l.transpose() + Matrix2d{{0, 0}, {0, 1}};
  return start.dot(Q * start) * spectral_radius(Matrix2d(Q.inverse() * energy));
}

// Of modes alike in energy the mean of what each may have.
double energy_of_theory(const Scheme& scheme, const SteppedModes& modes, double dt) {
  if (scheme.name == "newmark" || scheme.name == "central-difference") return 1;
  const bool lags = scheme.name == "central-difference, lagged damping";
  if (!(lags || scheme.name == "symplectic-euler") || modes.coupled.K.size() > 0) return nan;
  if (lags && modes.zeta_by_mean.size() > 0) return nan;
  double sum = 0;
  for (Index i = 0; i < modes.omega.size(); ++i) {
    const double x = modes.omega[i] * dt, a = 2 * modes.zeta[i] * x;
    sum += lags ? swing_of_lagged_differences(x, a) : swing_of_symplectic_euler(x, a);
  }
  return sum / static_cast<double>(modes.omega.size());
}

// Energy grows by rho^2 a step at last: what would not pass the bound in these steps is not told from what is stable.
std::optional<StepClass> prediction(double radius, long n_steps) {
  if (std::isnan(radius)) return std::nullopt;
  const double growth = 2 * static_cast<double>(n_steps) * std::log(radius);
  if (growth <= 1e-6) return StepClass::stable;
  return growth > 2 * std::log(energy_bound) ? std::optional(StepClass::unstable) : std::nullopt;
}

// Over the run under the scene's loads, by theory.
bool grows_in_run(const MappedSystem& mapped, double radius, double dt) {
  return mapped.times(mapped.times.size() - 1) / dt * std::log(radius) > std::log(grown_from);
}

// Whether the limit lies within `near_limit` of the step.
bool is_at_limit(const SteppedModes& modes, const Scheme& scheme, double dt) {
  return step_radius(modes, scheme, (1 - near_limit) * dt) <= not_growing &&
         step_radius(modes, scheme, (1 + near_limit) * dt) > 1;
}

}  // namespace

const char* to_string(StepClass of) {
  switch (of) {
    case StepClass::stable:
      return "stable";
    case StepClass::inaccurate:
      return "inaccurate";
    case StepClass::unstable:
      return "unstable";
  }
  return "unknown";
}

MappedSystem mapped_system(System system, const VectorXd& times, double duration, double load_tolerance) {
  SteppedModes modes = stepped_modes(system);
  MatrixXd motion = exact(system, duration, load_tolerance)->run(times).u.bottomRows(modes.omega.size());
  return {std::move(system), std::move(modes), times, std::move(motion)};
}

StepCell step_cell(const MappedSystem& mapped, const Integrator& integrator, double dt, long n_steps) {
  const Scheme* scheme = scheme_of_steps(integrator.name, mapped.system);
  const double radius = scheme ? step_radius(mapped.modes, *scheme, dt) : nan;
  const double bound = scheme && radius <= not_growing ? energy_of_theory(*scheme, mapped.modes, dt) : nan;
  StepCell cell{dt, radius, mapped.modes.omega.size(), n_steps, 0, bound, nan, StepClass::unstable, {}, false};
  cell.predicted = prediction(cell.radius, n_steps);
  cell.energy = largest_energy(mapped, integrator, dt, n_steps);
  if (!(cell.energy <= energy_bound)) {
    cell.at_limit = scheme && cell.predicted != StepClass::unstable && is_at_limit(mapped.modes, *scheme, dt);
    return cell;
  }
  const double error = error_of_steps(mapped, integrator, dt);
  const bool grows = grows_in_run(mapped, radius, dt);
  if (!(error <= runaway_from) || (grows && error > lost_from)) {
    if (!cell.predicted && grows) cell.predicted = StepClass::unstable;
    return cell;
  }
  cell.error = error;
  cell.found = error <= inaccurate_from ? StepClass::stable : StepClass::inaccurate;
  return cell;
}

double bar_of_energy(const MappedSystem& mapped, const Integrator& integrator, const StepCell& cell) {
  const double by_step = static_cast<double>(cell.n_steps) * std::numeric_limits<double>::epsilon() * cell.energy;
  return std::max(by_step,
                  2 * std::abs(largest_energy(mapped, integrator, cell.dt, cell.n_steps, 1. / 3) - cell.energy));
}

std::string verdict(const StepCell& cell) {
  if (std::isnan(cell.radius)) return "no prediction";
  if (cell.at_limit) return "at the limit";
  if (!cell.predicted) {
    const double growth = 2 * static_cast<double>(cell.n_steps) * std::log(cell.radius);  // of one of the modes
    const double most = growth + std::log(transient);
    const double least = growth - std::log(transient * static_cast<double>(cell.n_modes));
    const bool as_it_grows = cell.found == StepClass::unstable ? most > std::log(energy_bound)
                                                               : least < std::log(std::max(1.0, cell.energy));
    return as_it_grows ? "too slow to be seen" : "not as predicted";
  }
  const bool grows = cell.found == StepClass::unstable;
  return grows == (*cell.predicted == StepClass::unstable) ? "as predicted" : "not as predicted";
}

double predicted_limit(const MappedSystem& mapped, const std::string& integrator) {
  const Scheme* scheme = scheme_of_steps(integrator, mapped.system);
  if (!scheme) return nan;
  const auto& [omega, zeta, coupled, by_mean] = mapped.modes;
  const bool splits = scheme->name == "central-difference, lagged damping" && by_mean.size() > 0;
  if (coupled.K.size() == 0) {  // of what lags alone: at the limit rates turn round, and their mean is 0
    const VectorXd lagging = splits ? VectorXd((zeta - by_mean).cwiseMax(0)) : zeta;
    return measured_limit(*scheme, omega, without_rounding(omega, lagging)).dt;
  }
  const MatrixXd C = (coupled.C.array().abs() > rounding_of_damping(coupled.C)).select(coupled.C, 0);
  return stable_step({coupled.K, C, coupled.by_mean}, scheme->name);
}

}  // namespace mb
