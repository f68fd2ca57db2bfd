#include "cases/exact/sphere_impact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/exact/sphere_on_plane.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"
#include "mechanics/geometry/gauss.h"

namespace mb {
namespace {

double in_range(double value, double low, double high, const char* name) {
  if (!(value >= low && value <= high))
    throw std::invalid_argument(fmt::format("sphere_impact: {} = {} not in [{}, {}]", name, value, low, high));
  return value;
}

// x/R as a function of alpha, its derivative, and w = int (alpha^3 - weight) d(x/R), the work over 4/3 E* R^3, that of
// the weight [4/3 E* R^2] taken off.
struct Approach {
  double C, D, E, G, layer, weight;

  double x(double alpha) const {
    const double l = std::log(alpha);
    return alpha * (alpha * (1 + alpha * (C + D * l + alpha * (E + G * l))) + layer);
  }
  double slope(double alpha) const {
    const double l = std::log(alpha);
    return alpha * (2 + alpha * (3 * C + D + 3 * D * l + alpha * (4 * E + G + 4 * G * l))) + layer;
  }
  double work(double alpha) const {  // int alpha^p ln alpha = alpha^(p+1) (ln alpha - 1/(p+1))/(p+1)
    const double l = std::log(alpha), a4 = std::pow(alpha, 4);
    return -weight * x(alpha) +
           a4 * (layer / 4 + alpha * (0.4 + alpha * ((3 * C + D + 3 * D * (l - 1.0 / 6)) / 6 +
                                                     alpha * (4 * E + G + 4 * G * (l - 1.0 / 7)) / 7)));
  }
  // alpha at which that work is done, in [high/3, high], where the weight is small: bisection, then Newton on the
  // convex work.
  double after(double wanted, double high) const {
    double low = high / 3;
    for (int k = 0; k < 8; ++k) (work(0.5 * (low + high)) < wanted ? low : high) = 0.5 * (low + high);
    double alpha = high;
    for (int k = 0; k < 6; ++k)
      alpha = std::clamp(alpha - (work(alpha) - wanted) / ((std::pow(alpha, 3) - weight) * slope(alpha)), low, high);
    return alpha;
  }
};

Approach approach_of(double nu, double alpha, double layer, double weight) {
  const SmallContact small = small_contact(nu, PressureAlong::plane_normal);
  double at[2], rest[2];
  for (int i = 0; i < 2; ++i) {
    const SphereOnPlane contact = sphere_on_plane(i == 0 ? alpha : alpha / 2, nu);
    at[i] = std::cbrt(0.75 * contact.force);
    const double first = small.constant + small.logarithm * std::log(at[i]);
    rest[i] = (approach_over_hertz(contact) - 1 - at[i] * first) / (at[i] * at[i]);
  }
  const double G = (rest[0] - rest[1]) / std::log(at[0] / at[1]);
  return {small.constant, small.logarithm, rest[0] - G * std::log(at[0]), G, layer, weight};
}

// An impact with lengths in R, times in R/v: the way in, u = x'/v from 1 to 0; the way out is its mirror image. From
// touch up to half the work it is followed in alpha, from there to the peak in u,
//
//   t = int slope / sqrt(1 - w/w_m) d alpha,   T/2 - t = 2 w_m int du / (alpha^3 - weight),   w = w_m (1 - u^2),
//
// whose integrands are smooth but for alpha^2 ln alpha.
class WayIn {
 public:
  WayIn(const Approach& approach, double work, double high)
      : approach_(approach),
        rule_(gauss_legendre(40)),
        w_m_(work),
        alpha_m_(approach.after(work, high)),
        split_(approach.after(work / 2, alpha_m_)),
        t_split_(since_touch(split_)),
        half_(t_split_ + to_peak(u_split)) {}

  double half_duration() const { return half_; }
  double largest_alpha() const { return alpha_m_; }
  struct State {
    double alpha, u;
  };
  // At t in [0, T/2].
  State at(double t) const {
    if (t >= t_split_) {
      const double to_go = half_ - t;
      const double u = inverse(
          to_go, u_split, [&](double u_now) { return Eigen::Vector2d(to_peak(u_now), 2 * w_m_ / push(after(u_now))); });
      return {after(u), u};
    }
    const double alpha = inverse(
        t, split_, [&](double now) { return Eigen::Vector2d(since_touch(now), approach_.slope(now) / speed(now)); });
    return {alpha, speed(alpha)};
  }

 private:
  static constexpr double u_split = 0.70710678118654752;

  double after(double u) const { return approach_.after(w_m_ * (1 - u * u), alpha_m_); }
  double push(double alpha) const { return std::pow(alpha, 3) - approach_.weight; }
  double speed(double alpha) const { return alpha > 0 ? std::sqrt(1 - approach_.work(alpha) / w_m_) : 1; }
  double since_touch(double alpha) const {
    double sum = 0;
    for (Index i = 0; i < rule_.x.size(); ++i) {
      const double x = alpha * rule_.x[i];
      sum += rule_.w[i] * alpha * approach_.slope(x) / speed(x);
    }
    return sum;
  }
  double to_peak(double u) const {
    double sum = 0;
    for (Index i = 0; i < rule_.x.size(); ++i) sum += rule_.w[i] * u * 2 * w_m_ / push(after(u * rule_.x[i]));
    return sum;
  }
  // x in [0, high] with f(x) = wanted, f ascending from f(0) = 0: Newton's method, halved where it leaves the bracket.
  template <class F>
  static double inverse(double wanted, double high, const F& f) {
    double low = 0, x = 0.7 * high;
    for (int k = 0; k < 60 && wanted > 0; ++k) {
      const Eigen::Vector2d now = f(x);
      (now[0] < wanted ? low : high) = x;
      const double newton = x - (now[0] - wanted) / now[1];
      const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (std::abs(next - x) <= 1e-14 * high) return next;
      x = next;
    }
    return wanted > 0 ? x : 0;
  }

  Approach approach_;
  Rule rule_;
  double w_m_, alpha_m_, split_, t_split_, half_;
};

struct Impact {
  Approach approach;
  WayIn way_in;
};

Impact impact_of(const SphereImpact& impact) {
  const double R = impact.radius, modulus = contact_modulus(impact.material);
  const double mass = 4 * pi / 3 * R * R * R * impact.material.density;
  const HertzSphere contact{R, modulus};
  const HertzPeaks hertz = hertz_peaks({mass, hertz_stiffness(contact), impact.speed});
  const double alpha = in_range(std::sqrt(hertz.approach / R), 0.004, 0.25, "Hertz's a/R");
  if (!(impact.layer_stiffness > 0)) throw std::invalid_argument("sphere_impact: the layer's stiffness must be > 0");
  const double layer = modulus / (pi * impact.layer_stiffness * R);
  in_range(layer / alpha, 0, 0.1, "the layer's share E*/(pi k_n a)");
  const double unit = 4.0 / 3 * modulus * R * R, weight = mass * impact.gravity / unit;
  in_range(mass * impact.gravity / hertz.force, 0, 0.01, "the weight over Hertz's largest force");
  const Approach approach = approach_of(impact.material.poissons_ratio, alpha, layer, weight);
  return {approach, WayIn(approach, mass * impact.speed * impact.speed / 2 / (unit * R), 1.5 * alpha)};
}

SphereImpactPeaks peaks_of(const SphereImpact& impact, const Impact& scaled) {
  const double R = impact.radius, alpha = scaled.way_in.largest_alpha();
  return {2 * R / impact.speed * scaled.way_in.half_duration(),
          4.0 / 3 * contact_modulus(impact.material) * R * R * std::pow(alpha, 3), R * scaled.approach.x(alpha),
          R * alpha};
}

}  // namespace

SphereImpactPeaks sphere_impact(const SphereImpact& impact) { return peaks_of(impact, impact_of(impact)); }

SphereImpactMotion sphere_impact_motion(const SphereImpact& impact, const VectorXd& t) {
  if (!t.allFinite()) throw std::invalid_argument("sphere_impact_motion: a time is not finite");
  const Impact scaled = impact_of(impact);
  const SphereImpactPeaks peaks = peaks_of(impact, scaled);
  const double R = impact.radius, v = impact.speed, g = impact.gravity, T = peaks.duration;
  const double unit = 4.0 / 3 * contact_modulus(impact.material) * R * R;
  SphereImpactMotion motion{peaks, VectorXd(t.size()), VectorXd(t.size()), VectorXd::Zero(t.size()),
                            VectorXd::Zero(t.size())};
  for (Index k = 0; k < t.size(); ++k) {
    const bool leaves = t[k] > T / 2;
    const double in = leaves ? T - t[k] : t[k];  // [s] of the way in that mirrors it
    if (in <= 0) {
      motion.approach[k] = in * (v + g * in / 2);
      motion.rate[k] = (leaves ? -1 : 1) * (v + g * in);
      continue;
    }
    const auto [alpha, u] = scaled.way_in.at(in * v / R);
    motion.approach[k] = alpha > 0 ? R * scaled.approach.x(alpha) : 0;
    motion.rate[k] = (leaves ? -1 : 1) * v * u;
    motion.force[k] = unit * std::pow(alpha, 3);
    motion.layer_energy[k] = unit * R * 0.75 * scaled.approach.layer * std::pow(alpha, 4);
  }
  return motion;
}

}  // namespace mb
