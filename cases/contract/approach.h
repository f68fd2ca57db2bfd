// A body's way as seen from what it meets, neither deformed: the world, or the frame of another body,
//
//   y = Q_b^T (x - c_b),   y' = Q_b^T (v - v_b - w_b x (x - c_b)),
//   |y'' - Q_b^T (g - g_b)| <= turning r + turning_b |y| + 2 |w_b| |y'|      turning: |w x (w x r) + w' x r| / |r|
//
// What supports hold stands still.
#pragma once

#include <optional>

#include "cases/scene/scene.h"
#include "mechanics/contact/first_touch.h"
#include "mechanics/rigid/flight.h"

namespace mb {

class RigidMotion {
 public:
  RigidMotion(const Scene& scene, const Body& body);
  Pose pose(double t) const { return moves_ ? flight_.at(t) : pose_; }
  Twist twist(double t) const { return moves_ ? flight_.twist_at(t) : Twist{}; }
  Vector3d acceleration() const { return moves_ ? gravity_ : Vector3d::Zero(); }  // [m/s^2] of its centroid
  double spin() const { return moves_ ? flight_.max_angular_speed() : 0; }        // [rad/s] at most
  double turning() const { return (1 + spin_up_) * spin() * spin(); }             // [1/s^2] at most

 private:
  bool moves_;
  Pose pose_;
  Vector3d gravity_;
  Flight flight_;
  double spin_up_;  // I_max/I_min: |w'| <= it |w|^2, by Euler's equations
};

class Approach final : public BodyMotion {
 public:
  Approach(const Scene& scene, const Body& body, const Body* partner);  // nullptr: as seen from the world
  Pose pose(double t) const;
  Vector3d velocity(double t, const Vector3d& X) const;  // [m/s]
  Vector3d weight() const;  // [m/s^2] what presses the one on the other where both are at rest
  void at(double t, std::span<const Vector3d> X, std::span<PointMotion> out) const override;
  MotionBounds bounds(double ta, double tb) const override;

 private:
  RigidMotion a_;
  std::optional<RigidMotion> b_;
  double circumradius_;
};

}  // namespace mb
