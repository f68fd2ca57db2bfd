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

System undamped(System system) {
  system.damping = {};
  system.modal_damping = {MatrixXd(system.M.rows(), 0), VectorXd(0)};
  const Index n_elastic = system.M.rows() - system.R.cols();
  VectorXd u = VectorXd::Zero(system.M.rows());
  u.tail(n_elastic) = VectorXd(system.K.diagonal()).tail(n_elastic).cwiseSqrt().cwiseInverse();
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

}  // namespace

EnergyDrift energy_drift(const Integrator& integrator, const System& system, double dt, Index n_steps) {
  if (system.M.rows() <= system.R.cols() || n_steps < 3 * drift_window)
    throw std::invalid_argument(
        fmt::format("energy drift: {} elastic modes over {} steps", system.M.rows() - system.R.cols(), n_steps));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const System alone = undamped(system);
  const std::vector<double> at = ends(n_steps);
  Settings settings;
  settings.time_step = dt;
  const States states =
      integrator.prepare(alone, settings, static_cast<double>(n_steps) * dt)->run(window_times(at, dt));
  if (states.status != Status::ok) return {states.status, nan, nan, nan, {nan, nan, 0}};
  const VectorXd E = energy(alone, states);
  const auto n_windows = static_cast<Index>(at.size());
  const MatrixXd of_windows = E.reshaped(drift_window, n_windows);
  const VectorXd drift = drifts(of_windows, 0, drift_window);
  const VectorXd apart = Eigen::Map<const VectorXd>(at.data() + 1, n_windows - 1).array() - at[0];
  const Index last = drift.size() - 1;
  return {states.status, (E.head(drift_window).array() - 1).abs().maxCoeff(), drift(last), bar(of_windows, drift(last)),
          power_law(apart, drift.cwiseAbs())};
}

}  // namespace mb
