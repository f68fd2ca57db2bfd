// Bodies in free rotation, ordinary and nearly degenerate ones, and how far apart two answers are.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "mechanics/algebra/worse_test.h"
#include "mechanics/rigid/torque_free.h"
#include "mechanics/types.h"

namespace mb {

inline constexpr double eps = 2.2e-16;  // [-]

struct TestBody {
  Vector3d moments, omega0;         // [kg m^2], [rad/s]
  Eigen::Quaterniond orientation0;  // [-]
  double duration;                  // [s] of either sign, up to 60 / |w|
};

// kind 0 two moments equal but for 1e-12, 1 three but for 1e-10, 2 flat, 3 a needle, 4 spin next to the intermediate
// axis, 5 spin next to a stable one, else nothing special.
inline TestBody random_body(std::mt19937& generator, int kind) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.05, 1);
  Vector3d s(uniform(generator), uniform(generator), uniform(generator));  // int x^2, int y^2, int z^2
  if (kind == 0) s[1] = s[0] * (1 + 1e-12 * normal(generator));
  if (kind == 1) s = Vector3d::Constant(s[0]) + 1e-10 * s;
  if (kind == 2) s[2] *= 1e-14;
  if (kind == 3) s.head<2>() *= 1e-3;
  if (kind == 4 || kind == 5) s = Vector3d(0.2, 0.5, 0.9);  // y is the intermediate axis
  Vector3d omega(normal(generator), normal(generator), normal(generator));
  if (kind == 4) omega = Vector3d(1e-4 * omega[0], omega[1], 1e-4 * omega[2]);
  if (kind == 5) omega = Vector3d(omega[0], 1e-7 * omega[1], 1e-5 * omega[2]);
  const Eigen::Vector4d q(normal(generator), normal(generator), normal(generator), normal(generator));
  const double turns = 60 * uniform(generator) * (normal(generator) < 0 ? -1 : 1);
  return {{s[1] + s[2], s[2] + s[0], s[0] + s[1]}, omega, Eigen::Quaterniond(q.normalized()), turns / omega.norm()};
}

// Angle [rad] between two orientations, and the difference of angular velocities over the first one's size, the larger.
inline double difference(const Rotation& a, const Rotation& b) {
  const Eigen::Vector4d p = a.orientation.coeffs(), q = b.orientation.coeffs();
  const double angle = 4 * std::asin(std::min(1.0, 0.5 * std::min((p - q).norm(), (p + q).norm())));
  const double speed = a.angular_velocity.norm(), error = (a.angular_velocity - b.angular_velocity).norm();
  return worse(angle, error == 0 ? 0 : error / speed);
}

// What a few roundings amount to at time t: of the phases, and of the data, which the motion near the intermediate axis
// magnifies (measured: an angular velocity off by 1e-9).
inline double rounding(const TorqueFree& body, const Vector3d& moments, const Eigen::Quaterniond& orientation0,
                       const Vector3d& omega0, double t) {
  const TorqueFree off(moments, orientation0, omega0 + 1e-9 * omega0.reverse());
  return 4 * eps * (1 + body.max_angular_speed() * std::abs(t) + difference(body.at(t), off.at(t)) / 1e-9);
}

}  // namespace mb
