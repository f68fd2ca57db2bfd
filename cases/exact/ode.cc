#include "cases/exact/ode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb {
namespace {

constexpr int n_rows = 8;      // of the tableau: n = 2 ... 16
constexpr int wanted_row = 5;  // 42 evaluations a step; fewer rows, longer steps and conversely
constexpr int max_steps = 1000000;

// n steps of the midpoint rule with Gragg's smoothing; f0 = f(t, y) is shared by all n.
VectorXd midpoint(const Derivative& f, const OdeState& from, const VectorXd& f0, double h, int n) {
  const double step = h / n;
  VectorXd before = from.y, now = from.y + step * f0;
  for (int i = 1; i < n; ++i) {
    VectorXd next = before + 2 * step * f(from.t + i * step, now);
    before = std::move(now);
    now = std::move(next);
  }
  return 0.5 * (now + before + step * f(from.t + h, now));
}

struct Step {
  VectorXd y;
  double error;  // in terms of the tolerance
  int row;       // in which it was met, or n_rows
};

double error_of(const VectorXd& difference, const VectorXd& from, const VectorXd& to, const OdeTolerance& tolerance) {
  double error = 0;
  for (Index i = 0; i < to.size(); ++i) {
    const double size = std::max(std::abs(from[i]), std::abs(to[i]));
    const double scaled = std::abs(difference[i]) / std::max(tolerance.absolute + tolerance.relative * size, 1e-300);
    if (!std::isfinite(scaled)) return scaled;
    error = std::max(error, scaled);
  }
  return error;
}

Step extrapolate(const Derivative& f, const OdeState& from, const VectorXd& f0, double h,
                 const OdeTolerance& tolerance) {
  std::array<VectorXd, n_rows> T;
  double error = 1e300;
  for (int j = 0; j < n_rows; ++j) {
    VectorXd current = midpoint(f, from, f0, h, 2 * (j + 1)), last;
    for (int k = 1; k <= j; ++k) {
      const double ratio = (j + 1.0) / (j + 1 - k);
      last = current + (current - T[k - 1]) / (ratio * ratio - 1);
      T[k - 1] = std::move(current);
      current = std::move(last);
    }
    T[j] = current;
    if (j < 2) continue;
    error = error_of(T[j] - T[j - 1], from.y, T[j], tolerance);
    if (error <= 1) return {T[j], error, j};
    if (!(error < 1e300)) break;  // not finite
  }
  return {{}, error, n_rows};
}

double factor(const Step& step) {
  if (step.row == n_rows)
    return std::isfinite(step.error) ? std::clamp(std::pow(step.error, -1.0 / 15), 0.1, 0.6) : 0.1;
  if (step.row < wanted_row) return 1.5;
  const double by_error = 0.9 * std::pow(std::max(step.error, 1e-10), -1.0 / (2 * step.row + 1));
  return std::clamp(by_error, 0.5, 1.0) * (step.row == wanted_row ? 1.1 : 0.9);
}

void check(const OdeState& start, const OdeTolerance& tolerance) {
  if (!std::isfinite(start.t) || !start.y.allFinite())
    throw std::invalid_argument("integrate: the start is not finite");
  if (!(tolerance.relative >= 1e-15 && tolerance.relative < 1 && tolerance.absolute >= 0))
    throw std::invalid_argument(
        fmt::format("integrate: tolerances {} and {} out of range", tolerance.relative, tolerance.absolute));
}

// Marches one accepted step at a time, signed like h.
class Marcher {
 public:
  Marcher(const Derivative& f, const OdeState& start, const OdeTolerance& tolerance, double h)
      : f_(f), tolerance_(tolerance), now_(start), h_(h) {}

  const OdeState& now() const { return now_; }

  // One step, at most to t_end, which is met exactly.
  void advance(double t_end) {
    if (++n_steps_ > max_steps) fail("a million steps do not suffice");
    const VectorXd f0 = f_(now_.t, now_.y);
    for (;;) {
      const bool last = std::abs(h_) >= std::abs(t_end - now_.t);
      const double h = last ? t_end - now_.t : h_;
      const Step step = extrapolate(f_, now_, f0, h, tolerance_);
      if (step.row < n_rows) {
        now_ = {last ? t_end : now_.t + h, step.y};
        if (!last || step.row >= wanted_row) h_ = h * factor(step);
        return;
      }
      h_ = h * factor(step);
      if (!(std::abs(h_) > 1e-15 * std::abs(now_.t)) || std::abs(h_) < 1e-290) fail("no step meets the tolerance");
    }
  }

 private:
  [[noreturn]] void fail(const char* why) const {
    throw std::runtime_error(fmt::format("integrate: {} at t = {}", why, now_.t));
  }

  const Derivative& f_;
  OdeTolerance tolerance_;
  OdeState now_;
  double h_;
  int n_steps_ = 0;
};

// A thousandth of the time in which y changes by its size: the controller finds the rest.
double first_step(const Derivative& f, const OdeState& start) {
  const VectorXd slope = f(start.t, start.y);
  const double rate = slope.norm(), size = start.y.norm();
  return rate > 0 && size > 0 ? 1e-3 * size / rate : 1e-3;
}

}  // namespace

OdeState integrate(const Derivative& f, const OdeState& start, double t_end, const OdeTolerance& tolerance) {
  check(start, tolerance);
  if (!std::isfinite(t_end)) throw std::invalid_argument("integrate: the end is not finite");
  Marcher march(f, start, tolerance, std::copysign(first_step(f, start), t_end - start.t));
  while (march.now().t != t_end) march.advance(t_end);
  return march.now();
}

OdeState integrate_to_zero(const Derivative& f, const OdeState& start, Index component, const OdeTolerance& tolerance) {
  check(start, tolerance);
  if (component < 0 || component >= start.y.size())
    throw std::invalid_argument(fmt::format("integrate_to_zero: no component {}", component));
  Marcher march(f, start, tolerance, first_step(f, start));
  OdeState before = march.now();
  do {
    before = march.now();
    march.advance(std::numeric_limits<double>::infinity());
    if (march.now().y[component] <= 0 && !(before.y[component] > 0))
      throw std::invalid_argument("integrate_to_zero: the component does not start out positive");
  } while (march.now().y[component] > 0);
  OdeState at = march.now();
  double low = before.t, high = at.t;  // positive, not positive
  const double size = before.y[component] - at.y[component];
  for (int k = 0; k < 60 && std::abs(at.y[component]) > 1e-16 * size && high > low; ++k) {
    double t = at.t - at.y[component] / f(at.t, at.y)[component];
    if (!(t > low && t < high)) t = low + 0.5 * (high - low);
    if (t == at.t) break;
    at = integrate(f, at, t, tolerance);
    (at.y[component] > 0 ? low : high) = at.t;
  }
  return at;
}

}  // namespace mb
