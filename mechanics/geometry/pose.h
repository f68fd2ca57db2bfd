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

// The rotation nearest to A in the Frobenius norm:   A = U S V^T,   R = U diag(1, 1, det(U V^T)) V^T.   Kabsch 1978.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& A);

// The least turn that takes the direction `from` to the direction `to`; of opposite ones, one of many.
Eigen::Quaterniond shortest_turn(const Vector3d& from, const Vector3d& to);

}  // namespace mb
