#include "cases/exact/thrown_rod.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "cases/contract/touchdown.h"
#include "cases/exact/fit.h"
#include "cases/exact/rod_impact.h"

namespace mb {
namespace {

constexpr double upright = 1e-12;  // [-] 1 - cosine between the rod's axis and the plane's normal

// The axis of a prism that stands on the plane, and how it looks along its normal.
struct Stance {
  Index axis;
  double sign;          // [-] of the axis along the normal, world
  double length, area;  // [m], [m^2]
  Vector3d normal;      // [-] of the plane, world
};

std::optional<Stance> stance_of(const Scene& scene) {
  const Body& body = scene.bodies[0];
  const Vector3d n = obstacle_of(scene, scene.contacts[0]).surface.pose.orientation * Vector3d::UnitZ();
  const Vector3d along = body.pose.orientation.conjugate() * n;
  Index axis = 2;
  along.cwiseAbs().maxCoeff(&axis);
  const double sign = along[axis] > 0 ? 1 : -1;
  if (1 - std::abs(along[axis]) > upright) return {};
  if (const auto* box = std::get_if<Box>(&body.shape))
    return Stance{axis, sign, box->size[axis], box->size.prod() / box->size[axis], n};
  if (const auto* cylinder = std::get_if<Cylinder>(&body.shape); cylinder && axis == 2)
    return Stance{axis, sign, cylinder->length, pi * cylinder->radius * cylinder->radius, n};
  return {};
}

RodImpact impact_of(const Scene& scene, const Stance& stance, const Meeting& meeting) {
  const Body& body = scene.bodies[0];
  return {stance.length, body.material.youngs_modulus, body.material.density, -body.twist.velocity.dot(stance.normal),
          law_of(scene.contacts[0], meeting.size).stiffness};
}

std::string problem(const Scene& scene) {
  Misfit misfit = one_thrown_undamped_body(scene);
  if (!misfit.empty()) return misfit.text();
  const Body& body = scene.bodies[0];
  misfit.require(body.material.poissons_ratio == 0,
                 fmt::format("Poisson's ratio is {}, not 0", body.material.poissons_ratio));
  misfit.require(scene.gravity.isZero(0), "there is gravity");
  const std::optional<Stance> stance = stance_of(scene);
  misfit.require(stance.has_value(), "the body is no box or cylinder that meets the plane with a whole face");
  if (!misfit.empty()) return misfit.text();
  try {
    const Meeting meeting = touchdown(scene, body).meetings.at(0);
    misfit.require(std::isfinite(meeting.t), "nothing touches within the duration");
    if (misfit.empty()) RodImpactWaves(impact_of(scene, *stance, meeting));
  } catch (const std::invalid_argument& error) {
    misfit.require(false, error.what());
  }
  return misfit.text();
}

ContactHistory contact_of(const RodImpactWaves& waves, const Stance& stance, double k_n, const VectorXd& t,
                          double start) {
  const double A = stance.area;
  ContactHistory contact{
      Matrix3Xd(3, t.size()), Matrix3Xd(3, t.size()), VectorXd(t.size()), VectorXd::Zero(t.size()), {}};
  for (Index j = 0; j < t.size(); ++j) {
    const double p = waves.pressure(t[j] - start);
    contact.force.col(j) = A * p * stance.normal;
    contact.impulse.col(j) = A * waves.impulse(t[j] - start) * stance.normal;
    contact.stored[j] = A * p * p / (2 * k_n);
  }
  const auto& [duration, peak, peak_time, impulse] = waves.contact();
  if (t.size() > 0 && t[t.size() - 1] > start)
    contact.touches = {{start, start + duration, A * peak, start + peak_time, A * impulse * stance.normal}};
  return contact;
}

Trajectory at(const Scene& scene, const EvaluationPoints& points, const VectorXd& t) {
  const Body& body = scene.bodies[0];
  const Stance stance = *stance_of(scene);
  const Meeting meeting = touchdown(scene, body).meetings.at(0);
  const RodImpact rod = impact_of(scene, stance, meeting);
  const RodImpactWaves waves(rod);
  const Vector3d &v = body.twist.velocity, along = v + rod.speed * stance.normal;
  const Matrix3Xd all = points.all();
  BodyTrajectory answer{MatrixXd(3 * all.cols(), t.size()), MatrixXd::Zero(6 * points.n_strained(), t.size()),
                        contact_of(waves, stance, rod.layer_stiffness, t, meeting.t)};
  for (Index j = 0; j < t.size(); ++j) {
    const double before = std::min(t[j], meeting.t), since = t[j] - before;
    for (Index p = 0; p < all.cols(); ++p) {
      const double z = rod.length / 2 + stance.sign * all(stance.axis, p);
      const RodImpactState state = waves.state(std::clamp(z, 0.0, rod.length), since);
      answer.displacement.col(j).segment<3>(3 * p) =
          body.pose.to_world(all.col(p)) - all.col(p) + before * v + since * along + state.u * stance.normal;
      if (const Index e = points.strained(p); e >= 0) answer.strain(6 * e + stance.axis, j) = state.strain;
    }
  }
  return {t, {answer}, {}, Status::ok};
}

}  // namespace

ExactSolution thrown_rod() {
  return {"rod-on-wall",
          "box or cylinder, nu = 0, thrown flat on a rigid plane: d'Alembert's waves, the penalty layer included",
          "Graff 1975, Wave Motion in Elastic Solids, sect. 2.4; with the layer cases/exact/rod_impact.h",
          problem,
          at,
          1e-11};  // rounding: of the time since the touch, where its first time is sought to 1e-12 of the extent
}

}  // namespace mb
