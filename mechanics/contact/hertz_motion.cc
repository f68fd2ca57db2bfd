#include "mechanics/contact/hertz_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/geometry/gauss.h"

namespace mb {
namespace {

struct Scales {
  double length, time, force;  // L [m], L/v [s], m v^2/L [N]
};

Scales scales(const HertzImpact& impact) {
  for (const double value : {impact.mass, impact.stiffness, impact.speed})
    if (!(std::isfinite(value) && value > 0))
      throw std::invalid_argument(
          fmt::format("hertz impact: mass {}, stiffness {} and speed {} must be positive and finite", impact.mass,
                      impact.stiffness, impact.speed));
  const double energy = impact.mass * impact.speed * impact.speed;
  const double length = std::pow(energy / impact.stiffness, 0.4);
  return {length, length / impact.speed, energy / length};
}

double greatest_xi() { return std::pow(1.25, 0.4); }
double half_duration() { return 0.4 * greatest_xi() * std::tgamma(0.4) * std::sqrt(pi) / std::tgamma(0.9); }

struct Instant {
  double xi, rate;
};

// Energy integral from both ends. Each integrand is smooth where it is used, up to xi' = v = sqrt(1/2):
//
//   from touch      tau(xi) = int_0^sqrt(xi) 2 s ds / sqrt(1 - 4/5 s^5)
//   from the peak   tau_c/2 - tau = int_0^v dv / xi^(3/2),   xi^(5/2) = 5/4 (1 - v^2)
//
// Both are convex, so that Newton's steps come down on the root from above. In terms of the Gauss rule's rho > 2.1, 28
// points err by rho^-56 = 1e-18.
class HalfMotion {
 public:
  HalfMotion()
      : rule_(gauss_legendre(28)),
        xi_split_(std::pow(0.625, 0.4)),
        tau_split_(from_touch(xi_split_)),
        half_duration_(half_duration()) {}

  double duration() const { return 2 * half_duration_; }

  Instant at(double tau) const {  // in [0, tau_c/2]
    if (tau < tau_split_) {
      double xi = std::min(tau, xi_split_);  // tau >= xi, as no speed exceeds 1
      for (int k = 0; k < n_newton_; ++k) xi = std::max(0.0, xi - (from_touch(xi) - tau) * speed(xi));
      return {xi, speed(xi)};
    }
    const double rest = half_duration_ - tau;
    double v = std::min(rest * 1.25, std::sqrt(0.5));  // |v'| = xi^(3/2) <= (5/4)^(3/5) < 1.25
    for (int k = 0; k < n_newton_; ++k) v -= (from_peak(v) - rest) * std::pow(1.25 * (1 - v * v), 0.6);
    return {std::pow(1.25 * (1 - v * v), 0.4), v};
  }

 private:
  static double speed(double xi) { return std::sqrt(1 - 0.8 * xi * xi * std::sqrt(xi)); }
  double from_touch(double xi) const {
    const double s_end = std::sqrt(xi);
    double sum = 0;
    for (Index i = 0; i < rule_.x.size(); ++i) {
      const double s = s_end * rule_.x[i];
      sum += rule_.w[i] * 2 * s * s_end / std::sqrt(1 - 0.8 * s * s * s * s * s);
    }
    return sum;
  }
  double from_peak(double v_end) const {
    double sum = 0;
    for (Index i = 0; i < rule_.x.size(); ++i) {
      const double v = v_end * rule_.x[i];
      sum += rule_.w[i] * v_end / std::pow(1.25 * (1 - v * v), 0.6);
    }
    return sum;
  }

  static constexpr int n_newton_ = 6;  // from an error of 0.3, squared each time: 1e-16 after five
  Rule rule_;
  double xi_split_, tau_split_, half_duration_;
};

Instant at(const HalfMotion& half, double tau) {
  const double duration = half.duration();
  if (tau <= 0) return {tau, 1};
  if (tau >= duration) return {duration - tau, -1};
  if (tau <= duration / 2) return half.at(tau);
  const Instant mirrored = half.at(duration - tau);
  return {mirrored.xi, -mirrored.rate};
}

}  // namespace

HertzPeaks hertz_peaks(const HertzImpact& impact) {
  const auto [length, time, force] = scales(impact);
  return {2 * half_duration() * time, std::pow(1.25, 0.6) * force, greatest_xi() * length};
}

HertzMotion hertz_motion(const HertzImpact& impact, const VectorXd& t) {
  const auto [length, time, force] = scales(impact);
  if (!t.allFinite()) throw std::invalid_argument("hertz_motion: a time is not finite");
  const HalfMotion half;
  HertzMotion motion{VectorXd(t.size()), VectorXd(t.size()), VectorXd(t.size())};
  for (Index j = 0; j < t.size(); ++j) {
    const auto [xi, rate] = at(half, t[j] / time);
    motion.approach[j] = length * xi;
    motion.rate[j] = impact.speed * rate;
    motion.force[j] = xi > 0 ? force * xi * std::sqrt(xi) : 0;
  }
  return motion;
}

}  // namespace mb
