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

// x/R as a function of alpha, its derivative, and w = int alpha^3 d(x/R), the work over 4/3 E* R^3.
struct Approach {
  double C, D, E, G, layer;

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
    return a4 * (layer / 4 + alpha * (0.4 + alpha * ((3 * C + D + 3 * D * (l - 1.0 / 6)) / 6 +
                                                     alpha * (4 * E + G + 4 * G * (l - 1.0 / 7)) / 7)));
  }
  // alpha at which that work is done, in [high/3, high]: bisection, then Newton on the convex work.
  double after(double wanted, double high) const {
    double low = high / 3;
    for (int k = 0; k < 8; ++k) (work(0.5 * (low + high)) < wanted ? low : high) = 0.5 * (low + high);
    double alpha = high;
    for (int k = 0; k < 6; ++k)
      alpha = std::clamp(alpha - (work(alpha) - wanted) / (std::pow(alpha, 3) * slope(alpha)), low, high);
    return alpha;
  }
};

Approach approach_of(double nu, double alpha, double layer) {
  const SmallContact small = small_contact(nu, PressureAlong::plane_normal);
  double at[2], rest[2];
  for (int i = 0; i < 2; ++i) {
    const SphereOnPlane contact = sphere_on_plane(i == 0 ? alpha : alpha / 2, nu);
    at[i] = std::cbrt(0.75 * contact.force);
    const double first = small.constant + small.logarithm * std::log(at[i]);
    rest[i] = (approach_over_hertz(contact) - 1 - at[i] * first) / (at[i] * at[i]);
  }
  const double G = (rest[0] - rest[1]) / std::log(at[0] / at[1]);
  return {small.constant, small.logarithm, rest[0] - G * std::log(at[0]), G, layer};
}

// T v/(2 R), of work w_m = W(alpha_m): from touch up to half the work over alpha, from the peak over the speed u =
// x'/v, dt = -du w_m 2 / (v alpha^3) R. Both integrands are smooth but for alpha^2 ln alpha.
double half_duration(const Approach& approach, double alpha_m) {
  const Rule rule = gauss_legendre(40);
  const double w_m = approach.work(alpha_m), split = approach.after(w_m / 2, alpha_m), u_end = std::sqrt(0.5);
  double sum = 0;
  for (Index i = 0; i < rule.x.size(); ++i) {
    const double alpha = split * rule.x[i], u = u_end * rule.x[i];
    sum += rule.w[i] * split * approach.slope(alpha) / std::sqrt(1 - approach.work(alpha) / w_m);
    sum += rule.w[i] * u_end * 2 * w_m / std::pow(approach.after(w_m * (1 - u * u), alpha_m), 3);
  }
  return sum;
}

}  // namespace

SphereImpactPeaks sphere_impact(const SphereImpact& impact) {
  const double R = impact.radius, modulus = contact_modulus(impact.material);
  const double mass = 4 * pi / 3 * R * R * R * impact.material.density;
  const HertzSphere contact{R, modulus};
  const HertzPeaks hertz = hertz_peaks({mass, hertz_stiffness(contact), impact.speed});
  const double alpha = in_range(std::sqrt(hertz.approach / R), 0.004, 0.25, "Hertz's a/R");
  if (!(impact.layer_stiffness > 0)) throw std::invalid_argument("sphere_impact: the layer's stiffness must be > 0");
  const double layer = modulus / (pi * impact.layer_stiffness * R);
  in_range(layer / alpha, 0, 0.1, "the layer's share E*/(pi k_n a)");
  const Approach approach = approach_of(impact.material.poissons_ratio, alpha, layer);
  const double work = mass * impact.speed * impact.speed / 2 / (4.0 / 3 * modulus * R * R * R);
  const double alpha_m = approach.after(work, 1.5 * alpha);
  return {2 * R / impact.speed * half_duration(approach, alpha_m), 4.0 / 3 * modulus * R * R * std::pow(alpha_m, 3),
          R * approach.x(alpha_m), R * alpha_m};
}

}  // namespace mb
