// Free flight of a rigid body under constant gravity g: with c the centroid,
//
//   c(t) = c0 + v0 t + g t^2/2,   v(t) = v0 + g t,   and about c the rotation of torque_free.h, for gravity has no
//   torque.
#pragma once

#include "mechanics/geometry/pose.h"
#include "mechanics/rigid/inertia.h"
#include "mechanics/rigid/torque_free.h"
#include "mechanics/types.h"

namespace mb {

class Flight {
 public:
  // Pose and twist of the body's frame at t = 0, gravity [m/s^2] in the world. Throws std::invalid_argument where
  // TorqueFree or principal_axes do and where a number is not finite.
  Flight(const MassProperties& body, const Pose& pose0, const Twist& twist0, const Vector3d& gravity);

  Pose at(double t) const;         // of the body's frame, t [s] of any sign
  Twist twist_at(double t) const;  // of the body's frame, world axes

  Vector3d centroid_at(double t) const { return centroid0_ + t * (velocity0_ + 0.5 * t * gravity_); }  // [m] world
  Vector3d centroid_velocity_at(double t) const { return velocity0_ + t * gravity_; }                  // [m/s] world
  double max_angular_speed() const { return rotation_.max_angular_speed(); }                           // [rad/s]

  // Upper bound [m/s] of the speed of every material point within r [m] >= 0 of the centroid, at all times between
  // t0 and t1 [s]: max |v| + r max |w|. |v| is convex, so its maximum is at an end. Throws std::invalid_argument where
  // r is negative or a number not finite.
  double speed_bound(double r, double t0, double t1) const;

 private:
  Vector3d centroid_;                         // [m] body frame
  Eigen::Quaterniond from_body_;              // [-] body axes to principal axes
  Vector3d centroid0_, velocity0_, gravity_;  // [m], [m/s], [m/s^2] world
  TorqueFree rotation_;                       // of the principal axes
};

}  // namespace mb
