#include "harness/metrics/pose.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;

const Matrix3Xd X = (Matrix3Xd::Random(3, 40).array() * Eigen::Array3d(0.05, 0.05, 0.1).replicate(1, 40)).matrix();
const VectorXd w = VectorXd::Random(40).array() + 1.5;

VectorXd displacement(const Matrix3Xd& x) { return (x - X).reshaped(); }

TEST(RigidFrame, OfARigidMotionIsThatMotion) {
  const Vector3d shift(0.3, -2, 1), axis = Vector3d(1, 2, -1).normalized();
  for (const double angle : {0.0, 1e-8, 0.5, 3.1, pi}) {
    const Matrix3d Q = AngleAxisd(angle, axis).toRotationMatrix();
    const VectorXd u = displacement((Q * X).colwise() + shift);
    const RigidFrame frame = rigid_frame(X, w, u);
    // Rounding of coordinates of about 2 m against a body of 0.1 m.
    EXPECT_LT(angle_between(frame.R, Q), 1e-14);
    EXPECT_LT((frame.c - (Q * centroid(X, w) + shift)).norm(), 1e-14);
    EXPECT_NEAR(frame.R.determinant(), 1, 1e-14);
    EXPECT_LT(deformation(frame, centroid(X, w), X, u).norm(), 1e-14);
  }
}

TEST(RigidFrame, MinimisesTheWeightedDistance) {
  const VectorXd u = 0.03 * VectorXd::Random(3 * 40);
  const auto cost = [&](const RigidFrame& frame) {
    const VectorXd d = deformation(frame, centroid(X, w), X, u);
    return (d.reshaped(3, 40).colwise().squaredNorm() * w).value();
  };
  const RigidFrame best = rigid_frame(X, w, u);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double step : {-1e-3, 1e-3}) {
      RigidFrame moved = best, turned = best;
      moved.c(axis) += step;
      turned.R = AngleAxisd(step, Vector3d::Unit(axis)).toRotationMatrix() * best.R;
      EXPECT_GT(cost(moved), cost(best));
      EXPECT_GT(cost(turned), cost(best));
    }
  }
}

TEST(RigidFrame, AMirrorImageIsNotARotation) {
  const RigidFrame frame = rigid_frame(X, w, displacement(Vector3d(1, 1, -1).asDiagonal() * X));
  EXPECT_NEAR(frame.R.determinant(), 1, 1e-14);
}

TEST(RigidFrame, StretchIsAllDeformation) {
  const VectorXd u = displacement(1.01 * X);
  const RigidFrame frame = rigid_frame(X, w, u);
  EXPECT_LT(angle_between(frame.R, Matrix3d::Identity()), 1e-14);
  const Matrix3Xd expected = 0.01 * (X.colwise() - centroid(X, w));
  EXPECT_LT((deformation(frame, centroid(X, w), X, u) - VectorXd(expected.reshaped())).norm(), 1e-14);
}

TEST(RigidFrame, WhatIsNotFiniteStaysSo) {
  VectorXd u = VectorXd::Zero(3 * 40);
  u(7) = INFINITY;
  const RigidFrame frame = rigid_frame(X, w, u);
  EXPECT_TRUE(frame.c.hasNaN());
  EXPECT_TRUE(frame.R.hasNaN());
}

TEST(AngleBetween, IsExactForSmallAndForLargeAngles) {
  for (const double angle : {1e-12, 1e-3, 1.0, 3.0}) {
    const Matrix3d R = AngleAxisd(0.7, Vector3d::UnitX()).toRotationMatrix();
    // Entries carry rounding of 1e-16 each; d angle / d |R - S| grows as 1 / cos(angle/2), to 14 at 3.
    EXPECT_NEAR(angle_between(R, R * AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix()), angle,
                angle < 2 ? 2e-15 : 2e-14);
  }
}

}  // namespace
}  // namespace mb
