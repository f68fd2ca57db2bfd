#include "cases/contract/approach.h"

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/rigid/inertia.h"

namespace mb {

RigidMotion::RigidMotion(const Scene& scene, const Body& body)
    : moves_(!is_held(body)),
      pose_(body.pose),
      gravity_(scene.gravity),
      flight_(mass_properties(body.shape, body.material.density), body.pose, body.twist, scene.gravity) {
  const PrincipalAxes axes = principal_axes(mass_properties(body.shape, body.material.density).inertia);
  spin_up_ = axes.moments.maxCoeff() / axes.moments.minCoeff();
}

Approach::Approach(const Scene& scene, const Body& body, const Body* partner)
    : a_(scene, body), circumradius_(circumradius(body.shape)) {
  if (partner) b_.emplace(scene, *partner);
}

Pose Approach::pose(double t) const {
  const Pose now = a_.pose(t);
  if (!b_) return now;
  const Pose frame = b_->pose(t);
  return {frame.to_frame(now.position), (frame.orientation.conjugate() * now.orientation).normalized()};
}

Vector3d Approach::velocity(double t, const Vector3d& X) const {
  PointMotion out{};
  at(t, {&X, 1}, {&out, 1});
  return out.v;
}

Vector3d Approach::weight() const {
  if (!b_) return a_.acceleration();
  return b_->pose(0).orientation.conjugate() * (a_.acceleration() - b_->acceleration());
}

void Approach::at(double t, std::span<const Vector3d> X, std::span<PointMotion> out) const {
  const Pose now = a_.pose(t), frame = b_ ? b_->pose(t) : Pose{};
  const Twist twist = a_.twist(t), turn = b_ ? b_->twist(t) : Twist{};
  const Eigen::Matrix3d Q = now.orientation.toRotationMatrix(), B = frame.orientation.toRotationMatrix().transpose();
  const Vector3d w = twist.angular_velocity - turn.angular_velocity;
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  for (size_t i = 0; i < X.size(); ++i) {
    const Vector3d arm = Q * X[i], from = now.position + arm - frame.position;
    const Vector3d v =
        twist.velocity + twist.angular_velocity.cross(arm) - turn.velocity - turn.angular_velocity.cross(from);
    out[i] = {B * from, B * v, B * Q, B * W * Q};
  }
}

MotionBounds Approach::bounds(double ta, double tb) const {
  const double own = a_.turning() * circumradius_;
  if (!b_ || b_->spin() == 0) return {weight(), own, 0, 0};
  const double g = (a_.acceleration() - b_->acceleration()).norm(), dt = tb - ta;
  const double v = (a_.twist(ta).velocity - b_->twist(ta).velocity).norm() + g * dt;
  const double d = (a_.pose(ta).position - b_->pose(ta).position).norm() + v * dt + circumradius_;
  const double rate = v + a_.spin() * circumradius_ + b_->spin() * d;
  return {Vector3d::Zero(), own + g + b_->turning() * d + 2 * b_->spin() * rate, 0, 0};
}

}  // namespace mb
