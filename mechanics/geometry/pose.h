// Where a rigid frame stands:   x = position + orientation X,   X in the frame, x in the world.
#pragma once

#include "mechanics/types.h"

namespace mb {

struct Pose {
  Vector3d position = Vector3d::Zero();        // [m]
  Eigen::Quaterniond orientation{1, 0, 0, 0};  // [-] of unit length
  Vector3d to_world(const Vector3d& X) const { return position + orientation * X; }
  Vector3d to_frame(const Vector3d& x) const { return orientation.conjugate() * (x - position); }
};

// Rigid velocity: of the frame's origin, and the angular one, both in world axes.
struct Twist {
  Vector3d velocity = Vector3d::Zero();          // [m/s]
  Vector3d angular_velocity = Vector3d::Zero();  // [rad/s]
};

}  // namespace mb
