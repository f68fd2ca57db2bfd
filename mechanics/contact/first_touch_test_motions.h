// Motions for the tests of first touch: ballistic, spinning steadily, vibrating,
//
//   x = c + v0 t + g t^2/2 + Q(t) (X + u),   Q = exp(omega t) Q0,   u = sum_k sin(w_k t + phase_k) (L_k X + S_k[X, X])
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "mechanics/contact/first_touch.h"
#include "mechanics/contact/first_touch_support.h"

namespace mb {

inline Eigen::Matrix3d cross_matrix(const Vector3d& a) {
  return (Eigen::Matrix3d() << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0).finished();
}

struct Vibration {
  double frequency = 0, phase = 0;                   // [rad/s], [rad]
  Eigen::Matrix3d linear = Eigen::Matrix3d::Zero();  // [-]
  std::vector<Eigen::Matrix3d> bends;                // [1/m] none or three symmetric ones, S[X, X]_i = X . bends[i] X
};

class TestMotion : public BodyMotion {
 public:
  explicit TestMotion(const Shape& shape) : radius(circumradius(shape)) {}

  double radius;
  Vector3d position = Vector3d::Zero(), velocity = Vector3d::Zero(), gravity = Vector3d::Zero();
  Eigen::Quaterniond orientation{1, 0, 0, 0};
  Vector3d spin = Vector3d::Zero();  // [rad/s] world
  std::vector<Vibration> vibrations;

  Eigen::Matrix3d rotation(double t) const {
    const double angle = spin.norm() * t;
    const Eigen::Matrix3d Q0 = orientation.toRotationMatrix();
    if (spin.norm() == 0) return Q0;
    return Eigen::AngleAxisd(angle, spin.normalized()).toRotationMatrix() * Q0;
  }

  void at(double t, std::span<const Vector3d> X, std::span<PointMotion> out) const override {
    const Eigen::Matrix3d Q = rotation(t), Q_rate = cross_matrix(spin) * Q;
    const Vector3d c = position + t * (velocity + 0.5 * t * gravity), c_rate = velocity + t * gravity;
    for (size_t i = 0; i < X.size(); ++i) {
      Vector3d y = X[i], y_rate = Vector3d::Zero();
      Eigen::Matrix3d G = Eigen::Matrix3d::Identity(), G_rate = Eigen::Matrix3d::Zero();
      for (const Vibration& k : vibrations) {
        Vector3d mode = k.linear * X[i];
        Eigen::Matrix3d gradient = k.linear;
        for (int j = 0; j < (k.bends.empty() ? 0 : 3); ++j) {
          const Vector3d half = k.bends[static_cast<size_t>(j)] * X[i];
          mode[j] += X[i].dot(half);
          gradient.row(j) += 2 * half.transpose();
        }
        const double q = std::sin(k.frequency * t + k.phase);
        const double q_rate = k.frequency * std::cos(k.frequency * t + k.phase);
        y += q * mode, y_rate += q_rate * mode, G += q * gradient, G_rate += q_rate * gradient;
      }
      out[i] = {c + Q * y, c_rate + Q_rate * y + Q * y_rate, Q * G, Q_rate * G + Q * G_rate};
    }
  }

  MotionBounds bounds(double, double) const override {
    const double turning = spin.norm();
    double u = 0, u_rate = 0, u_rate2 = 0, bend = 0, bend_rate = 0;
    for (const Vibration& k : vibrations) {
      double second = 0;
      for (const Eigen::Matrix3d& S : k.bends) second += 4 * S.squaredNorm();
      second = std::sqrt(second);
      const double amplitude = k.linear.norm() * radius + 0.5 * second * radius * radius;
      u += amplitude, u_rate += k.frequency * amplitude, u_rate2 += k.frequency * k.frequency * amplitude;
      bend += second, bend_rate += (turning + k.frequency) * second;
    }
    return {gravity, turning * turning * (radius + u) + 2 * turning * u_rate + u_rate2, bend, bend_rate};
  }

  Vector3d place(const Vector3d& X, double t) const {
    PointMotion m;
    at(t, {&X, 1}, {&m, 1});
    return m.x;
  }
};

// Modes of a few percent of strain over the body: one linear, one with bending.
inline Vibration random_vibration(std::mt19937& random, double radius, double strain, double frequency, bool bending) {
  std::normal_distribution<double> normal;
  Vibration v{frequency, normal(random), strain * Eigen::Matrix3d::NullaryExpr([&] { return normal(random) / 3; }), {}};
  for (int i = 0; bending && i < 3; ++i) {
    const Eigen::Matrix3d S = strain / radius * Eigen::Matrix3d::NullaryExpr([&] { return normal(random) / 6; });
    v.bends.push_back(S + S.transpose());
  }
  return v;
}

}  // namespace mb
