#include "cases/exact/timoshenko_impact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

using Eigen::ArrayXd;

void check(const BeamImpact& impact, const BeamMarch& march) {
  const auto positive = [](double value, const char* name) {
    if (!(std::isfinite(value) && value > 0))
      throw std::invalid_argument(fmt::format("beam impact: {} must be positive and finite, not {}", name, value));
  };
  positive(impact.length, "length");
  positive(impact.bending_stiffness, "bending stiffness");
  positive(impact.mass_per_length, "mass per length");
  positive(impact.ball_mass, "ball mass");
  positive(impact.contact_stiffness, "contact stiffness");
  positive(impact.speed, "speed");
  positive(march.interval, "interval");
  if (march.n_samples < 1 || march.n_steps < 1 || march.n_modes < 1)
    throw std::invalid_argument("beam impact: counts of samples, steps and modes must be at least 1");
}

// (z - sin z)/z^3
double ramp(double z) {
  if (std::abs(z) > 1) return (z - std::sin(z)) / (z * z * z);
  double term = 1.0 / 6, sum = 0;
  for (int k = 1; k <= 9; ++k, term *= -z * z / (2.0 * k * (2 * k + 1))) sum += term;
  return sum;
}

// The step h of oscillators q'' + omega^2 q = F, F from F_0 to F_1, exact for linear F:
//
//   q_1 = cos(omega h) q_0 + sin(omega h)/omega q_0' + (P - R/h) F_0 + R/h F_1,   P = (1 - cos)/omega^2,
//   q_1' = -omega sin(omega h) q_0 + cos(omega h) q_0' + (S - P/h) F_0 + P/h F_1,   R = (omega h - sin)/omega^3
struct Recurrence {
  ArrayXd cosine, sine /* [s] S = sin/omega */, omega2 /* [1/s^2] */;
  ArrayXd early, late;            // [s^2] of F_0 and F_1 in q_1
  ArrayXd early_rate, late_rate;  // [s] in q_1'
};

Recurrence recurrence(const BeamImpact& impact, Index n_modes, double h) {
  const double first = pi / impact.length * (pi / impact.length) *  //
                       std::sqrt(impact.bending_stiffness / impact.mass_per_length);
  const ArrayXd n = ArrayXd::LinSpaced(n_modes, 1, 2 * static_cast<double>(n_modes) - 1);
  const ArrayXd omega = first * n.square(), z = omega * h, half = (z / 2).sin() / (z / 2);
  Recurrence step{z.cos(), z.sin() / omega, omega.square(), {}, {}, {}, {}};
  const ArrayXd P = h * h / 2 * half.square();
  step.late = h * h * z.unaryExpr(&ramp);
  step.early = P - step.late;
  step.late_rate = P / h;
  step.early_rate = step.sine - step.late_rate;
  return step;
}

class March {
 public:
  March(const BeamImpact& impact, Index n_modes, double h)
      : impact_(impact),
        h_(h),
        step_(recurrence(impact, n_modes, h)),
        modal_(2 / (impact.mass_per_length * impact.length)),
        late_(h * h / (6 * impact.ball_mass) + modal_ * step_.late.sum()),
        q_(ArrayXd::Zero(n_modes)),
        q_rate_(ArrayXd::Zero(n_modes)),
        q_next_(n_modes),
        rate_(impact.speed) {}

  void advance() {
    q_next_ = step_.cosine * q_ + step_.sine * q_rate_ + step_.early * force_;
    q_rate_ = step_.cosine * q_rate_ - step_.omega2 * step_.sine * q_ + step_.early_rate * force_;
    const double x = ball_ + h_ * rate_ - h_ * h_ / (3 * impact_.ball_mass) * force_;
    const double next = solve(x - modal_ * q_next_.sum());
    q_.swap(q_next_);
    q_ += step_.late * next;
    q_rate_ += step_.late_rate * next;
    ball_ = x - h_ * h_ / (6 * impact_.ball_mass) * next;
    rate_ -= h_ / (2 * impact_.ball_mass) * (force_ + next);
    force_ = next;
  }

  double force() const { return force_; }
  double ball() const { return ball_; }
  double ball_rate() const { return rate_; }
  double midspan() const { return modal_ * q_.sum(); }
  VectorXd modes() const { return modal_ * q_; }
  double gap_rate() const { return rate_ - modal_ * q_rate_.sum(); }  // w'
  double approach() const { return ball_ - midspan(); }               // w
  double beam_energy() const { return modal_ / 2 * (q_rate_.square() + step_.omega2 * q_.square()).sum(); }

 private:
  // F of w = w_star - c F, by Newton on the convex s^2 + c k s^3 = w_star, from above.
  double solve(double w_star) const {
    if (!(w_star > 0)) return 0;
    const double ck = late_ * impact_.contact_stiffness;
    double s = std::sqrt(w_star);
    for (int k = 0; k < 60; ++k) {
      const double change = (s * s * (1 + ck * s) - w_star) / (s * (2 + 3 * ck * s));
      s -= change;
      if (change <= 1e-16 * s) break;
    }
    return impact_.contact_stiffness * s * s * s;
  }

  BeamImpact impact_;
  double h_;
  Recurrence step_;
  double modal_;  // 2/(rho A L): every odd mode has +-1 at midspan
  double late_;   // c [m/N]
  ArrayXd q_, q_rate_, q_next_;
  double ball_ = 0, rate_, force_ = 0;
};

struct Instant {
  double t, w, w_rate, force, impulse_rate;
};
Instant instant(const March& march, double t) {
  return {t, march.approach(), march.gap_rate(), march.force(), march.ball_rate()};
}

// Cubic through values and slopes of w at both ends, at the fraction x of the step, and its slope.
struct Cubic {
  double w, rate;
};
Cubic hermite(const Instant& a, const Instant& b, double x) {
  const double h = b.t - a.t, c = 3 * (b.w - a.w) - h * (2 * a.w_rate + b.w_rate);
  const double d = 2 * (a.w - b.w) + h * (a.w_rate + b.w_rate);
  return {a.w + x * (h * a.w_rate + x * (c + x * d)), (h * a.w_rate + x * (2 * c + 3 * x * d)) / h};
}

// The fraction at which w (or its rate) turns from positive to not positive, by bisection.
template <typename Positive>
double turning(const Positive& is_positive) {
  double low = 0, high = 1;
  for (int k = 0; k < 54; ++k) (is_positive(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

void note_peak(const BeamImpact& impact, const Instant& a, const Instant& b, BeamMotion& motion) {
  const double x = turning([&](double y) { return hermite(a, b, y).rate > 0; });
  const double force = impact.contact_stiffness * std::pow(std::max(hermite(a, b, x).w, 0.0), 1.5);
  if (force <= motion.peak) return;
  motion.peak = force;
  motion.peak_time = a.t + x * (b.t - a.t);
}

void note_release(const BeamImpact& impact, const March& march, const Instant& a, const Instant& b,
                  BeamMotion& motion) {
  motion.touch_end = a.t + turning([&](double y) { return hermite(a, b, y).w > 0; }) * (b.t - a.t);
  motion.rebound_speed = -march.ball_rate();
  motion.impulse = impact.ball_mass * (impact.speed - march.ball_rate());
  motion.beam_energy = march.beam_energy();
}

}  // namespace

BeamMotion march_beam_impact(const BeamImpact& impact, const BeamMarch& march) {
  check(impact, march);
  const double h = march.interval / static_cast<double>(march.n_steps);
  March state(impact, march.n_modes, h);
  const Index n = march.n_samples + 1;
  BeamMotion motion{VectorXd::LinSpaced(n, 0, march.interval * static_cast<double>(n - 1)),
                    VectorXd::Zero(n),
                    VectorXd::Zero(n),
                    VectorXd::Zero(n),
                    VectorXd::Constant(n, impact.speed),
                    MatrixXd::Zero(march.n_modes, n),
                    0,
                    0,
                    0,
                    0,
                    0,
                    0,
                    0};
  bool touches = false, released = false;
  Instant before = instant(state, 0);
  for (Index j = 1; j < n; ++j) {
    for (Index i = 0; i < march.n_steps; ++i) {
      state.advance();
      const Instant now = instant(state, h * static_cast<double>((j - 1) * march.n_steps + i + 1));
      if (now.force > 0 && !touches) ++motion.n_contacts;
      if (!released && now.force > 0 && before.w_rate > 0 && now.w_rate <= 0) note_peak(impact, before, now, motion);
      if (!released && touches && !(now.force > 0)) {
        note_release(impact, state, before, now, motion);
        released = true;
      }
      touches = now.force > 0;
      before = now;
    }
    motion.force[j] = state.force();
    motion.ball[j] = state.ball();
    motion.midspan[j] = state.midspan();
    motion.ball_rate[j] = state.ball_rate();
    motion.modes.col(j) = state.modes();
  }
  if (!released) note_release(impact, state, before, before, motion);
  return motion;
}

BeamMotion beam_impact(const BeamImpact& impact, const BeamMarch& march) {
  BeamMarch half = march;
  half.n_steps *= 2;
  const BeamMotion coarse = march_beam_impact(impact, march);
  BeamMotion motion = march_beam_impact(impact, half);
  const auto improve = [](auto& fine, const auto& rough) { fine += (fine - rough) / 3; };
  improve(motion.force, coarse.force);
  motion.force = motion.force.cwiseMax(0);  // not below it by the rest of the error, where contact ends
  improve(motion.ball, coarse.ball);
  improve(motion.midspan, coarse.midspan);
  improve(motion.ball_rate, coarse.ball_rate);
  improve(motion.modes, coarse.modes);
  improve(motion.peak, coarse.peak);
  improve(motion.peak_time, coarse.peak_time);
  improve(motion.touch_end, coarse.touch_end);
  improve(motion.impulse, coarse.impulse);
  improve(motion.rebound_speed, coarse.rebound_speed);
  improve(motion.beam_energy, coarse.beam_energy);
  return motion;
}

}  // namespace mb
