#include "cases/exact/struck_plate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/contract/touchdown.h"
#include "cases/exact/fit.h"
#include "cases/exact/zener_impact.h"
#include "cases/scene/number_text.h"
#include "mechanics/contact/hertz.h"

namespace mb {
namespace {

constexpr double largest_lambda = 50, least_phase = 15;

// m [kg], v [m/s], lambda [-], T_0 [s] of a scene that fits.
struct Strike {
  double mass, speed, lambda, unit;
};
Strike strike_of(const Scene& scene) {
  const Body& body = scene.bodies[0];
  const Striker& striker = *striker_of(scene, body)->striker;
  const double h = std::get<Box>(body.shape).size.z(), k = touchdown(scene, body).meetings.at(0).size.stiffness;
  const double D = contact_modulus(body.material) * h * h * h / 12;
  const double unit = std::pow(striker.mass / k, 0.4) * std::pow(striker.speed, -0.2);
  return {striker.mass, striker.speed, striker.mass / (8 * std::sqrt(D * body.material.density * h) * unit), unit};
}

std::string problem(const Scene& scene) {
  Misfit misfit = one_struck_undamped_body(scene, Theory::kirchhoff);
  if (!misfit.empty()) return misfit.text();
  const auto [mass, speed, lambda, unit] = strike_of(scene);
  misfit.require(lambda <= largest_lambda, fmt::format("lambda is {}, beyond {}: the ball stays on the plate",
                                                       number_beside(lambda, largest_lambda), largest_lambda));
  if (!misfit.empty()) return misfit.text();
  const Body& body = scene.bodies[0];
  const Vector3d size = std::get<Box>(body.shape).size;
  const double l = std::min(size.x(), size.y()), T = zener_impact(lambda).duration * unit;
  const double c = size.z() * std::sqrt(contact_modulus(body.material) / (12 * body.material.density));
  const double phase = l * l / (4 * c * T), least = l * std::sqrt(least_phase / phase);
  misfit.require(phase >= least_phase,
                 fmt::format("waves come back from the rim while the ball touches: the shorter edge is {} m, and must "
                             "be {} m at least",
                             number_text(l), number_beside(least, l)));
  return misfit.text();
}

Trajectory at(const Scene& scene, const EvaluationPoints& points, const VectorXd& t) {
  const auto [mass, speed, lambda, unit] = strike_of(scene);
  const ZenerImpact impact = zener_impact(lambda);
  const ZenerMotion motion = zener_motion(lambda, t / unit);
  const double momentum = mass * speed;
  BodyTrajectory body{MatrixXd(3 * points.size(), 0), MatrixXd(6 * points.n_strained(), 0)};
  body.contact = {Matrix3Xd::Zero(3, t.size()),
                  Matrix3Xd::Zero(3, t.size()),
                  0.4 * momentum * speed * motion.force.cwiseProduct(motion.sigma.cwiseMax(0)),
                  VectorXd::Zero(t.size()),
                  {}};
  body.contact.force.row(2) = -momentum / unit * motion.force.transpose();
  // The ball's speed is that of approach and the plate's, lambda F, together.
  body.contact.impulse.row(2) =
      -momentum * (1 - motion.rate.array() - lambda * motion.force.array()).matrix().transpose();
  const double end = impact.duration * unit;
  if (t.size() > 0 && t[t.size() - 1] > 0)
    body.contact.touches = {{0, end, momentum / unit * impact.peak_force, impact.peak_time * unit,
                             -momentum * (1 + impact.restitution) * Vector3d::UnitZ()}};
  return {t, {body}, {}, Status::ok};
}

}  // namespace

ExactSolution struck_plate() {
  return {"zener-impact",
          "large Kirchhoff plate, struck by a ball in the middle: Zener's equation, of the contact alone",
          "Zener 1941, Phys. Rev. 59, 669-673",
          problem,
          at,
          1e-4};  // what comes back from the rim of the smallest plate that fits
}

}  // namespace mb
