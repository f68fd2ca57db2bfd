#include "harness/analysis/layer_impact.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "mechanics/geometry/gauss.h"

namespace mb {

namespace {

void require_impact(double speed, double until) {
  if (!(speed > 0) || !std::isfinite(speed)) throw std::invalid_argument("impact: the speed is not positive");
  if (!(until >= 0)) throw std::invalid_argument("impact: the time is negative or NaN");
}

// delta = centre + amplitude sin(phase + omega (t - start))
struct Swing {
  double start, phase, omega, amplitude;
  double rate(double t) const { return amplitude * omega * std::cos(phase + omega * (t - start)); }
};

// From touch to rest, a swing for each sample that is met.
struct Descent {
  std::vector<Swing> swings;
  double rest, peak_force;
};

Descent descent(const HeightSamples& samples, double speed) {
  const auto height = [&](Index i) { return std::max(samples.height(i), 0.0); };
  Descent all{{}, height(0) / speed, 0};
  double u = speed, stiffness = 0, load = 0;
  for (Index j = 0; j < samples.size(); ++j) {
    stiffness += samples.weight(j);
    load += samples.weight(j) * height(j);
    const double centre = load / stiffness, omega = std::sqrt(stiffness), y = height(j) - centre;
    const double phase = std::atan2(omega * y, u), amplitude = std::hypot(y, u / omega);
    all.swings.push_back({all.rest, phase, omega, amplitude});
    if (j + 1 < samples.size()) {
      const double ahead = height(j + 1) - height(j), next = y + ahead;
      const double left = u * u - stiffness * ahead * (next + y);
      if (left > 0) {
        u = std::sqrt(left);
        all.rest += (std::atan2(omega * next, u) - phase) / omega;
        continue;
      }
    }
    all.rest += (pi / 2 - phase) / omega;
    all.peak_force = stiffness * amplitude;
    break;
  }
  return all;
}

double rate_before_rest(const Descent& way, double speed, double t) {
  if (t < way.swings.front().start) return speed;  // no sample touches yet
  const auto after =
      std::upper_bound(way.swings.begin(), way.swings.end(), t, [](double at, const Swing& s) { return at < s.start; });
  return std::prev(after)->rate(t);
}

}  // namespace

double time_to_rest(const ContactOfDepth& law, double greatest_depth) {
  if (!(greatest_depth > 0)) throw std::invalid_argument("impact: the greatest depth is not positive");
  const Rule rule = gauss_legendre(20);
  const double energy = law(greatest_depth).energy;
  double time = 0;  // depth = greatest (1 - s^2): no singularity at rest
  for (Index i = 0; i < rule.x.size(); ++i) {
    const double s = rule.x[i], left = energy - law(greatest_depth * (1 - s * s)).energy;
    time += rule.w[i] * 2 * greatest_depth * s / std::sqrt(2 * left);
  }
  return time;
}

LayerImpact impact_on_samples(const HeightSamples& samples, double speed, double until) {
  require_impact(speed, until);
  if (samples.size() == 0) throw std::invalid_argument("impact: without samples nothing stops the body");
  const Descent way = descent(samples, speed);
  double rate = -speed;
  if (until <= way.rest) rate = rate_before_rest(way, speed, until);
  if (until > way.rest && until < 2 * way.rest) rate = -rate_before_rest(way, speed, 2 * way.rest - until);
  return {2 * (way.rest - way.swings.front().start), way.peak_force, speed - rate};
}

// xi = depth / greatest, tau = t sqrt(c greatest): xi'' = -xi^2, xi'(0) = sqrt(2/3), at rest at B(1/3, 1/2)/3 / that.
LayerImpact impact_on_square_law(double c, double speed, double until) {
  require_impact(speed, until);
  if (!(c > 0) || !std::isfinite(c)) throw std::invalid_argument("impact: the layer's stiffness is not positive");
  const double greatest = std::cbrt(1.5 * speed * speed / c), rate = std::sqrt(c * greatest);
  const double rest = std::beta(1.0 / 3, 0.5) / 3 / std::sqrt(2.0 / 3);
  const double tau = std::min(until * rate, 2 * rest);
  constexpr int n = 4000;  // Runge and Kutta's steps: (5/4000)^4 of error
  const double h = tau / n;
  double x = 0, v = std::sqrt(2.0 / 3);
  for (int i = 0; i < n; ++i) {
    const double v2 = v - h / 2 * x * x, x2 = x + h / 2 * v;
    const double v3 = v - h / 2 * x2 * x2, x3 = x + h / 2 * v2;
    const double v4 = v - h * x3 * x3, x4 = x + h * v3;
    const double a = x * x + 2 * x2 * x2 + 2 * x3 * x3 + x4 * x4;
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v -= h / 6 * a;
  }
  return {2 * rest / rate, c * greatest * greatest, speed - v * greatest * rate};
}

}  // namespace mb
