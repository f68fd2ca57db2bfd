#include "cases/exact/thrown_sphere.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "cases/contract/touchdown.h"
#include "cases/exact/fit.h"
#include "cases/exact/sphere_impact.h"
#include "cases/scene/number_text.h"
#include "mechanics/contact/hertz.h"

namespace mb {
namespace {

constexpr double least_layers = 50;     // [-] k_n a/E*
constexpr double least_periods = 6;     // [-] T/T_1
constexpr double lowest_period = 2.375; /* T_1 c_t/R [-] of the mode S2 at nu = 0.3, within a tenth for others */

struct Thrown {
  SphereImpact impact;
  double start;     // [s]
  Vector3d normal;  // [-] of the plane
};

Thrown thrown(const Scene& scene) {
  const Body& body = scene.bodies[0];
  const Meeting meeting = touchdown(scene, body).meetings.at(0);
  if (!std::isfinite(meeting.t)) throw std::invalid_argument("nothing touches within the duration");
  const Vector3d n = obstacle_of(scene, scene.contacts[0]).surface.pose.orientation * Vector3d::UnitZ();
  const Vector3d v = body.twist.velocity + meeting.t * scene.gravity;
  return {{body.material, std::get<Sphere>(body.shape).radius, -v.dot(n),
           law_of(scene.contacts[0], meeting.size).stiffness, -scene.gravity.dot(n)},
          meeting.t,
          n};
}

void check_regime(const Scene& scene, Misfit& misfit) {
  const auto [impact, start, normal] = thrown(scene);
  misfit.require(impact.gravity >= 0, "gravity pulls the sphere off the plane");
  if (!misfit.empty()) return;
  const SphereImpactPeaks peaks = sphere_impact(impact);
  const Material& m = impact.material;
  const double layers = impact.layer_stiffness * peaks.contact_radius / contact_modulus(m);
  const double c_t = std::sqrt(m.youngs_modulus / (2 * (1 + m.poissons_ratio) * m.density));
  const double periods = peaks.duration * c_t / (lowest_period * impact.radius);
  misfit.require(layers >= least_layers, fmt::format("the layer is soft, k_n a/E* = {}, below {}",
                                                     number_beside(layers, least_layers), least_layers));
  misfit.require(periods >= least_periods,
                 fmt::format("the contact lasts {} of the longest period, less than {}: waves count",
                             number_beside(periods, least_periods), least_periods));
  const double flight = impact.gravity > 0 ? 2 * impact.speed / impact.gravity : scene.duration;
  misfit.require(start + peaks.duration + flight >= scene.duration, "the sphere comes back within the duration");
}

std::string problem(const Scene& scene) {
  Misfit misfit = one_thrown_undamped_body(scene);
  for (const Body& body : scene.bodies)
    misfit.require(std::holds_alternative<Sphere>(body.shape), "the body is not a sphere");
  if (!misfit.empty()) return misfit.text();
  try {
    check_regime(scene, misfit);
  } catch (const std::invalid_argument& error) {
    misfit.require(false, error.what());
  }
  return misfit.text();
}

Trajectory at(const Scene& scene, const EvaluationPoints& points, const VectorXd& t) {
  const auto [impact, start, normal] = thrown(scene);
  const SphereImpactMotion motion = sphere_impact_motion(impact, t.array() - start);
  const double T = motion.peaks.duration, v = impact.speed, g = impact.gravity;
  const double mass = 4 * pi / 3 * std::pow(impact.radius, 3) * impact.material.density;
  const double whole = mass * (2 * v + g * T);  // [N s]
  BodyTrajectory body{MatrixXd(3 * points.size(), 0), MatrixXd(6 * points.n_strained(), 0)};
  VectorXd impulse(t.size());
  for (Index j = 0; j < t.size(); ++j) {
    const double since = t[j] - start;
    impulse[j] = since <= 0 ? 0 : since >= T ? whole : mass * (v - motion.rate[j] + g * since);
  }
  body.contact = {normal * motion.force.transpose(),
                  normal * impulse.transpose(),
                  motion.layer_energy,
                  VectorXd::Zero(t.size()),
                  {}};
  if (t.size() > 0 && t[t.size() - 1] > start)
    body.contact.touches = {{start, start + T, motion.peaks.force, start + T / 2, whole * normal}};
  return {t, {body}, {}, Status::ok};
}

}  // namespace

ExactSolution thrown_sphere() {
  return {"hertz-impact",
          "elastic sphere thrown on a rigid plane: Hertz's impact, corrected for the finite sphere and the penalty "
          "layer, of the contact alone",
          "Hertz 1882; Johnson 1985, Contact Mechanics, sect. 11.4; cases/exact/sphere_impact.h",
          problem,
          at,
          1e-3};  // waves and second order of the layer, where the problem allows most of both
}

}  // namespace mb
