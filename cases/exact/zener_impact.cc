#include "cases/exact/zener_impact.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "cases/exact/ode.h"
#include "mechanics/contact/hertz.h"

namespace mb {
namespace {

enum Component : Index { s, v, tau, to_go };  // to_go: time left until a wanted instant

Derivative equation(double lambda) {
  if (!(lambda >= 0 && lambda <= 50))
    throw std::invalid_argument(fmt::format("zener_impact: lambda must lie in [0, 50], not {}", lambda));
  return [lambda](double, const VectorXd& y) {
    const double s2 = y[s] * y[s];
    return VectorXd{{y[v], -s2 * (2 * s2 + 3 * lambda * y[v]), 2 * y[s], -2 * y[s]}};
  };
}

OdeState touch() { return {0, VectorXd{{0.0, 1.0, 0.0, 0.0}}}; }

double ball_mass(const PlateImpact& impact) {
  for (const double value : {impact.radius, impact.thickness, impact.speed, impact.ball.density, impact.plate.density})
    if (!(std::isfinite(value) && value > 0))
      throw std::invalid_argument(
          fmt::format("zener: radius {}, thickness {}, speed {} and densities {}, {} must be positive and finite",
                      impact.radius, impact.thickness, impact.speed, impact.ball.density, impact.plate.density));
  return 4 * pi / 3 * impact.radius * impact.radius * impact.radius * impact.ball.density;
}

}  // namespace

ZenerImpact zener_impact(double lambda) {
  const Derivative f = equation(lambda);
  const OdeState peak = integrate_to_zero(f, touch(), v), release = integrate_to_zero(f, peak, s);
  const double s_peak = peak.y[s];
  return {-release.y[v], release.y[tau], s_peak * s_peak * s_peak, peak.y[tau]};
}

ZenerMotion zener_motion(double lambda, const VectorXd& times) {
  const Derivative f = equation(lambda);
  if (!times.allFinite()) throw std::invalid_argument("zener_motion: a time is not finite");
  const OdeState release = integrate_to_zero(f, integrate_to_zero(f, touch(), v), s);
  ZenerMotion motion{VectorXd(times.size()), VectorXd(times.size()), VectorXd(times.size())};
  OdeState now = touch();
  for (Index j = 0; j < times.size(); ++j) {
    const double t = times[j];
    if (j > 0 && t < times[j - 1]) throw std::invalid_argument("zener_motion: the times do not ascend");
    if (t <= 0 || t >= release.y[tau]) {
      const double rate = t <= 0 ? 1 : release.y[v];
      motion.sigma[j] = rate * (t <= 0 ? t : t - release.y[tau]);
      motion.rate[j] = rate;
      motion.force[j] = 0;
      continue;
    }
    now.y[to_go] = t - now.y[tau];
    if (now.y[to_go] > 0) now = integrate_to_zero(f, now, to_go);
    motion.sigma[j] = now.y[s] * now.y[s];
    motion.rate[j] = now.y[v];
    motion.force[j] = now.y[s] * now.y[s] * now.y[s];
  }
  return motion;
}

double zener_time(const PlateImpact& impact) {
  const double m = ball_mass(impact), k = hertz_stiffness({impact.radius, contact_modulus(impact.ball, impact.plate)});
  return std::pow(m / k, 0.4) * std::pow(impact.speed, -0.2);
}

double zener_parameter(const PlateImpact& impact) {
  const double h = impact.thickness, bending = contact_modulus(impact.plate) * h * h * h / 12;
  return ball_mass(impact) / (8 * std::sqrt(bending * impact.plate.density * h) * zener_time(impact));
}

}  // namespace mb
