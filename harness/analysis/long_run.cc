// A million steps of free vibration without damping: what of the energy is left, and how what is lost or gained grows,
//
//   drift(n) = mean E over a window at step n / mean E over the first window - 1 ~ n^p
//
// p = 1: a scheme that loses or gains as it goes; p = 1/2: rounding that wanders; p about 0: none.
#include <array>
#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/power_law.h"
#include "harness/analysis/step_limit.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double n_steps = 1e6;
constexpr Index window = 1000;  // [-] steps over which energy is averaged: fifty periods of the fastest mode and more
constexpr double step_times_omega = 2 * pi / 20;  // [-] of the fastest mode kept
constexpr int fewest = 2, most = 8;               // modes kept

Finding long_run_table() {
  return table("long-run", "long-run", "Energy over a million steps",
               "Free vibration of the modes kept, all alike in energy, without damping, at a twentieth of the shortest "
               "period a step. Swing: the largest deviation of energy within the first 1000 steps; drift: of its mean "
               "over 1000 steps, weighted after Hann, at the end from that at the start, positive where energy grows; "
               "exponent: of the drift "
               "over the number of steps, from 2000 on.",
               {{"integrator", ""},
                {"modes r", ""},
                {"dt", "s"},
                {"steps", ""},
                {"status", ""},
                {"swing", "-"},
                {"drift", "-"},
                {"exponent", "-"},
                {"standard error", "-"}});
}

// Ends of the windows, steps.
std::vector<double> ends() {
  std::vector<double> all{static_cast<double>(window)};
  for (double n = 2.0 * window; n < 1.01 * n_steps; n *= std::pow(10., 1. / 3)) all.push_back(std::round(n));
  all.back() = n_steps;
  return all;
}

// [s] every step of every window, ascending.
VectorXd window_times(const std::vector<double>& ends, double dt) {
  VectorXd t(static_cast<Index>(ends.size()) * window);
  for (size_t w = 0; w < ends.size(); ++w)
    for (Index i = 0; i < window; ++i)
      t(static_cast<Index>(w) * window + i) = (ends[w] - static_cast<double>(window - 1 - i)) * dt;
  return t;
}

// Hann's: of a swing, which all but vanishes in the mean, the ends of the window leave next to nothing.
VectorXd window_weights() {
  VectorXd w(window);
  for (Index i = 0; i < window; ++i) w(i) = std::pow(std::sin(pi * (static_cast<double>(i) + 0.5) / window), 2);
  return w / w.sum();
}

System undamped(System system) {
  system.damping = {};
  system.modal_damping = {MatrixXd(system.M.rows(), 0), VectorXd(0)};
  const Index n_elastic = system.M.rows() - system.R.cols();
  VectorXd u = VectorXd::Zero(system.M.rows());
  u.tail(n_elastic) = VectorXd(system.K.diagonal()).tail(n_elastic).cwiseSqrt().cwiseInverse();
  return let_go(system, u);
}

std::vector<FindingCell> row(const Integrator& integrator, const System& system, double dt) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> at = ends();
  Settings settings;
  settings.time_step = dt;
  const States states = integrator.prepare(system, settings, n_steps * dt)->run(window_times(at, dt));
  const Index r = system.M.rows() - system.R.cols();
  const std::vector<FindingCell> named{integrator.name, count(r), dt, n_steps, to_string(states.status)};
  const auto with = [&](const std::array<double, 4>& values) {
    std::vector<FindingCell> all = named;
    all.insert(all.end(), values.begin(), values.end());
    return all;
  };
  if (states.status != Status::ok) return with({nan, nan, nan, nan});
  const VectorXd k = system.K.diagonal();
  const VectorXd E = (states.v.colwise().squaredNorm().transpose() +
                      (k.asDiagonal() * states.u).cwiseProduct(states.u).colwise().sum().transpose()) /
                     static_cast<double>(r);
  const auto n_windows = static_cast<Index>(at.size());
  const VectorXd mean = E.reshaped(window, n_windows).transpose() * window_weights();
  const VectorXd drift = (mean.array() / mean(0) - 1).matrix();
  const PowerLaw law =
      power_law(Eigen::Map<const VectorXd>(at.data() + 1, n_windows - 1), drift.tail(n_windows - 1).cwiseAbs());
  return with({(E.head(window).array() - 1).abs().maxCoeff(), drift(n_windows - 1), law.exponent, law.standard_error});
}

}  // namespace

std::vector<Finding> long_run(const AnalysisContext& context) {
  const int r = std::clamp(mode_counts(context).front(), fewest, most);
  const ModalBody body = modal_body(context, r);
  const System system = undamped(project(body.system, body.modes));
  const double dt = step_times_omega / body.modes.omega(body.modes.size() - 1);
  Finding found = long_run_table();
  for (const Integrator& integrator : context.catalogue.integrators)
    if (integrator.knob != Integrator::Knob::tolerance) found.rows.push_back(row(integrator, system, dt));
  return {found};
}

}  // namespace mb
