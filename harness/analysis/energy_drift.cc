#include "harness/analysis/energy_drift.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "harness/analysis/step_limit.h"
#include "harness/metrics/gci.h"

namespace mb {

namespace {

// Ends of the windows, steps; three a decade.
std::vector<double> ends(Index n_steps) {
  const auto last = static_cast<double>(n_steps);
  std::vector<double> all{static_cast<double>(drift_window)};
  for (double n = 2.0 * drift_window; n < 1.01 * last; n *= std::pow(10., 1. / 3)) all.push_back(std::round(n));
  all.back() = last;
  return all;
}

// [s] every step of every window, ascending.
VectorXd window_times(const std::vector<double>& ends, double dt) {
  VectorXd t(static_cast<Index>(ends.size()) * drift_window);
  for (size_t w = 0; w < ends.size(); ++w)
    for (Index i = 0; i < drift_window; ++i)
      t(static_cast<Index>(w) * drift_window + i) = (ends[w] - static_cast<double>(drift_window - 1 - i)) * dt;
  return t;
}

// Hann's: of a swing, which all but vanishes in the mean, the ends of the window leave next to nothing.
VectorXd window_weights(Index n) {
  VectorXd w(n);
  for (Index i = 0; i < n; ++i)
    w(i) = std::pow(std::sin(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n)), 2);
  return w / w.sum();
}

// E: energies of every window, one a column. From the first window on, by n steps of each from the step `first` on.
VectorXd drifts(const MatrixXd& E, Index first, Index n) {
  const VectorXd mean = E.middleRows(first, n).transpose() * window_weights(n);
  return mean.tail(mean.size() - 1).array() / mean(0) - 1;
}

// Every elastic mode with the energy scale^2/2.
System undamped(System system, double scale) {
  system.damping = {};
  system.modal_damping = {MatrixXd(system.M.rows(), 0), VectorXd(0)};
  const Index n_elastic = system.M.rows() - system.R.cols();
  VectorXd u = VectorXd::Zero(system.M.rows());
  u.tail(n_elastic) = scale * VectorXd(system.K.diagonal()).tail(n_elastic).cwiseSqrt().cwiseInverse();
  return let_go(system, u);
}

// [-] E/E(0)
VectorXd energy(const System& system, const States& states) {
  const VectorXd k = system.K.diagonal();
  return (states.v.colwise().squaredNorm().transpose() +
          (k.asDiagonal() * states.u).cwiseProduct(states.u).colwise().sum().transpose()) /
         static_cast<double>(system.M.rows() - system.R.cols());
}

// What Hann's lets through of a swing falls with the third power of the window's length (Harris 1978, Proc. IEEE 66:
// 18 dB an octave). Of two halves, whose phases differ, the farther: one alone may agree by chance. NaN without both.
double bar(const MatrixXd& E, double drift) {
  constexpr Index half = drift_window / 2;
  double widest = 0;
  for (const Index first : {Index{0}, half}) {
    const VectorXd by_half = drifts(E, first, half);
    const std::optional<double> gci = gci_of_two(1 + drift, 1 + by_half(by_half.size() - 1), 2, 3);
    if (!gci) return std::numeric_limits<double>::quiet_NaN();
    widest = std::max(widest, *gci);
  }
  return widest * std::abs(1 + drift);
}

// [-] E/E(0) of every window, one a column, of motion `scale` times as large. None where the run does not end well.
struct Windows {
  Status status;
  MatrixXd E;
  double drift() const { return drifts(E, 0, drift_window).tail<1>()(0); }
  double swing() const { return (E.col(0).array() - 1).abs().maxCoeff(); }
};
Windows run_windows(const Integrator& integrator, const System& system, const std::vector<double>& at, double dt,
                    double scale) {
  const System alone = undamped(system, scale);
  Settings settings;
  settings.time_step = dt;
  const States states = integrator.prepare(alone, settings, at.back() * dt)->run(window_times(at, dt));
  if (states.status != Status::ok) return {states.status, {}};
  const VectorXd E = energy(alone, states) / (scale * scale);
  return {states.status, E.reshaped(drift_window, static_cast<Index>(at.size()))};
}

// Twice what the drift is otherwise where the motion is a third as large, which is the same but for rounding; that of a
// quotient near 1 at the least. NaN where that motion is not known.
double rounding(const Windows& whole, const Windows& third) {
  if (third.status != Status::ok) return std::numeric_limits<double>::quiet_NaN();
  return std::max(2 * std::abs(third.drift() - whole.drift()), std::numeric_limits<double>::epsilon());
}

double rounding_of_swing(const Windows& whole, const Windows& third) {
  if (third.status != Status::ok) return std::numeric_limits<double>::quiet_NaN();
  return std::max(2 * std::abs(third.swing() - whole.swing()), drift_window * std::numeric_limits<double>::epsilon());
}

}  // namespace

EnergyDrift energy_drift(const Integrator& integrator, const System& system, double dt, Index n_steps) {
  if (system.M.rows() <= system.R.cols() || n_steps < 3 * drift_window)
    throw std::invalid_argument(
        fmt::format("energy drift: {} elastic modes over {} steps", system.M.rows() - system.R.cols(), n_steps));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> at = ends(n_steps);
  const Windows windows = run_windows(integrator, system, at, dt, 1);
  if (windows.status != Status::ok) return {windows.status, nan, nan, nan, nan, {nan, nan, 0}};
  const VectorXd drift = drifts(windows.E, 0, drift_window);
  const auto n_apart = static_cast<Index>(at.size()) - 1;
  const VectorXd apart = Eigen::Map<const VectorXd>(at.data() + 1, n_apart).array() - at[0];
  const Windows third = run_windows(integrator, system, at, dt, 1. / 3);
  return {windows.status,
          windows.swing(),
          rounding_of_swing(windows, third),
          windows.drift(),
          bar(windows.E, windows.drift()) + rounding(windows, third),
          power_law(apart, drift.cwiseAbs())};
}

}  // namespace mb
