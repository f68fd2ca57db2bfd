// A frame turned by a rotation vector given in world axes:   Q+ = exp(rotation / 2) Q.
#pragma once

#include <cmath>

#include "mechanics/types.h"

namespace mb {

inline Eigen::Quaterniond turned(const Eigen::Quaterniond& Q, const Vector3d& rotation) {
  const double angle = rotation.norm(), half = angle / 2;
  const double part = angle > 1e-4 ? std::sin(half) / angle : 0.5 - angle * angle / 48;  // next term: angle^4 / 3840
  const Vector3d v = part * rotation;
  return (Eigen::Quaterniond(std::cos(half), v.x(), v.y(), v.z()) * Q).normalized();
}

// Of theta -> theta x arm.
inline Eigen::Matrix3d turning(const Vector3d& arm) {
  return (Eigen::Matrix3d() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0).finished();
}

}  // namespace mb
