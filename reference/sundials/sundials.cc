#include "reference/sundials/sundials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "mechanics/contact/touches.h"
#include "reference/sundials/arkode.h"

namespace mb {

namespace {

using ark::Stop;
constexpr double longest_step = 0.25;         // [-] of the duration
constexpr double expression_resolved = 0.01;  // [-] of its mean and its own size (history.h)
constexpr double overrated = 100;             // [-] a scale over what the motion reaches: run again
constexpr int most_runs = 8;

double mass_of(const System& system) { return system.M.sum() / 3; }

// sqrt(x.A x / m), m the body's mass where it is free; a scale is all that is needed. Of a nearly rigid x rounding may
// fall below 0.
double norm_per_mass(const VectorXd& x, const VectorXd& Ax, double mass) {
  const double square = x.dot(Ax) / mass;
  return std::isfinite(square) ? std::sqrt(std::max(0.0, square)) : square;
}

// Sizes that the motion can reach, in the M norm per root mass: with T the duration, the initial state and the
// responses to each load at its peak and to the initial velocity of  (K + M/T^2) x = F max|s|, by M + T^2 K.
ark::Scales motion_scales(const System& system, double duration, const Shifted& shifted) {
  const double mass = mass_of(system);
  const auto norm = [&](const SparseMatrix& A, const VectorXd& x) { return norm_per_mass(x, A * x, mass); };
  VectorXd x = VectorXd::Zero(system.u0.size());
  ark::Scales scale{norm(system.M, system.u0), norm(system.M, system.v0) + norm(system.K, system.u0)};
  for (Index l = 0; l < system.F.cols(); ++l) {
    shifted.solve(system.F.col(l) * (duration * duration * peak(system.s[static_cast<size_t>(l)], duration)), x);
    scale.displacement += norm(system.M, x);
    scale.velocity += norm(system.K, x) + norm(system.M, x) / duration;
  }
  shifted.solve(system.M * system.v0, x);
  scale.displacement += std::sqrt(std::max(0.0, system.v0.dot(system.M * x) / mass)) * duration;
  if (!std::isfinite(scale.displacement) || !std::isfinite(scale.velocity))
    throw std::runtime_error("sundials: loads or initial state not finite");
  return {scale.displacement > 0 ? scale.displacement : 1, scale.velocity > 0 ? scale.velocity : 1};  // 1: at rest
}

// Breakpoints, and the pieces that a load without any, an expression, is resampled to. The last is beyond all times.
std::vector<Stop> stops(const System& system, double duration) {
  std::map<double, bool> all;
  for (const History& s : system.s) {
    const auto value = evaluator(s);
    const double small = 1e-9 * peak(s, duration);
    const auto add = [&](double t) { all[t] |= std::abs(value(t) - value(std::nextafter(t, 0.0))) > small; };
    for (const double t : breakpoints(s, duration)) add(t);
    if (!std::holds_alternative<Expression>(s)) continue;
    for (const Segment& piece : segments(s, duration, expression_resolved).pieces)
      if (piece.start > 0) add(piece.start);
  }
  std::vector<Stop> ascending;
  for (const auto& [t, jump] : all) ascending.push_back({t, jump});
  ascending.push_back({std::numeric_limits<double>::max(), false});
  return ascending;
}

class Sundials final : public Stepper {
 public:
  Sundials(const System& system, double tolerance, double duration)
      : system_(system),
        tolerance_(tolerance),
        duration_(duration),
        parts_(system, duration, {}),
        scales_(motion_scales(system, duration, parts_.factors.at(duration).A)),
        stops_(stops(system, duration)) {}

  // A load far shorter than the periods of what it moves leaves the motion far below what its peak could do, and an
  // absolute tolerance made of that would be met by anything: such a run is made again, with the sizes it reached.
  States run(const VectorXd& times) const override {
    ark::Scales scales = scales_;
    Work work;
    for (int n = 1;; ++n) {
      States out = integrated(times, scales);
      work = out.work = work + out.work;
      if (out.status != Status::ok) return out;
      const ark::Scales reached = sizes(out);
      const bool is_overrated =
          reached.displacement > 0 && reached.velocity > 0 &&
          (scales.displacement > overrated * reached.displacement || scales.velocity > overrated * reached.velocity);
      if (!is_overrated) return out;
      if (n == most_runs) {
        out.status = Status::no_convergence;
        return out;
      }
      scales = {std::min(scales.displacement, reached.displacement), std::min(scales.velocity, reached.velocity)};
    }
  }

 private:
  ark::Scales sizes(const States& states) const {
    VectorXd Mx(system_.u0.size());
    const double mass = mass_of(system_);
    const auto largest = [&](const MatrixXd& X) {
      double norm = 0;
      for (Index k = 0; k < states.n_valid; ++k) {
        parts_.M(X.col(k), Mx);
        norm = std::max(norm, norm_per_mass(X.col(k), Mx, mass));
      }
      return norm;
    };
    return {largest(states.u), largest(states.v)};
  }
  States integrated(const VectorXd& times, const ark::Scales& scales) const {
    States out{MatrixXd(system_.u0.size(), times.size()), MatrixXd(system_.u0.size(), times.size()), {}, Status::ok, 0};
    ark::Run run(system_, parts_, {tolerance_, scales, true, longest_step * duration_});
    size_t next = 0;
    for (Index k = 0; k < times.size(); ++k) {
      int flag = 0;
      for (; stops_[next].t < times[k] && flag >= 0; ++next) flag = run.advance(stops_[next].t, stops_[next]);
      if (times[k] > 0 && flag >= 0) flag = run.advance(times[k], stops_[next]);
      if (flag < 0 || !run.displacement().allFinite()) {
        out.status = flag < 0 ? run.status_of(flag) : Status::not_finite;
        break;
      }
      out.u.col(k) = run.displacement();
      out.v.col(k) = run.velocity();
      out.n_valid = k + 1;
    }
    blank_rest(out);
    out.work = run.work();
    out.work.factorisations += parts_.mass.is_diagonal() ? 0 : 1;
    return out;
  }

  const System& system_;
  double tolerance_, duration_;
  mutable ark::Parts parts_;  // a run leaves its last factor behind; what it starts from changes no digit
  ark::Scales scales_;
  std::vector<Stop> stops_;
};

}  // namespace

std::unique_ptr<Stepper> sundials(const System& system, double relative_tolerance, double duration) {
  if (!(relative_tolerance >= 1e-12 && relative_tolerance <= 1e-2))
    throw std::invalid_argument("sundials: the relative tolerance must lie in [1e-12, 1e-2]");
  if (!(duration > 0)) throw std::invalid_argument("sundials: the duration must be positive");
  return std::make_unique<Sundials>(system, relative_tolerance, duration);
}

}  // namespace mb
