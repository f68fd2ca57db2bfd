#include "mechanics/rigid/flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

const MassProperties& checked(const MassProperties& body, const Pose& pose0, const Twist& twist0,
                              const Vector3d& gravity) {
  if (!body.centroid.allFinite()) throw std::invalid_argument("Flight: the centroid is not finite");
  if (!pose0.position.allFinite()) throw std::invalid_argument("Flight: the position is not finite");
  if (!twist0.velocity.allFinite()) throw std::invalid_argument("Flight: the velocity is not finite");
  if (!gravity.allFinite()) throw std::invalid_argument("Flight: gravity is not finite");
  return body;
}

TorqueFree rotation(const PrincipalAxes& principal, const Pose& pose0, const Twist& twist0) {
  const Eigen::Quaterniond orientation0 = pose0.orientation * principal.axes;
  return {principal.moments, orientation0, orientation0.conjugate() * twist0.angular_velocity};
}

}  // namespace

Flight::Flight(const MassProperties& body, const Pose& pose0, const Twist& twist0, const Vector3d& gravity)
    : centroid_(checked(body, pose0, twist0, gravity).centroid),
      from_body_(principal_axes(body.inertia).axes.conjugate()),
      centroid0_(pose0.to_world(centroid_)),
      velocity0_(twist0.velocity + twist0.angular_velocity.cross(pose0.orientation * centroid_)),
      gravity_(gravity),
      rotation_(rotation(principal_axes(body.inertia), pose0, twist0)) {}

Pose Flight::at(double t) const {
  const Eigen::Quaterniond orientation = rotation_.at(t).orientation * from_body_;
  return {centroid_at(t) - orientation * centroid_, orientation};
}

Twist Flight::twist_at(double t) const {
  const Rotation r = rotation_.at(t);
  const Vector3d omega = r.orientation * r.angular_velocity;
  const Vector3d arm = r.orientation * (from_body_ * centroid_);
  return {centroid_velocity_at(t) - omega.cross(arm), omega};
}

double Flight::speed_bound(double r, double t0, double t1) const {
  if (!(r >= 0) || !std::isfinite(r) || !std::isfinite(t0) || !std::isfinite(t1))
    throw std::invalid_argument(fmt::format("Flight::speed_bound: r = {} m, from {} s to {} s", r, t0, t1));
  const double v = std::max(centroid_velocity_at(t0).norm(), centroid_velocity_at(t1).norm());
  return (v + r * max_angular_speed()) * (1 + 1e-14);  // rounding must not take it below the speed
}

}  // namespace mb
