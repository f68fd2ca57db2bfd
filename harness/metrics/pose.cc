#include "harness/metrics/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/geometry/pose.h"

namespace mb {

namespace {

using Points = Eigen::Map<const Matrix3Xd>;

Points as_points(const VectorXd& u) { return {u.data(), 3, u.size() / 3}; }

}  // namespace

Vector3d centroid(const Matrix3Xd& X, const VectorXd& w) { return X * w / w.sum(); }

RigidFrame rigid_frame(const Matrix3Xd& X, const VectorXd& w, const VectorXd& u) {
  if (!u.allFinite()) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {Vector3d::Constant(nan), Eigen::Matrix3d::Constant(nan)};
  }
  const Matrix3Xd x = X + as_points(u);
  const Vector3d c = centroid(x, w), X_c = centroid(X, w);
  const Eigen::Matrix3d correlation = (x.colwise() - c) * w.asDiagonal() * (X.colwise() - X_c).transpose();
  return {c, nearest_rotation(correlation)};
}

VectorXd deformation(const RigidFrame& frame, const Vector3d& X_c, const Matrix3Xd& X, const VectorXd& u) {
  const Matrix3Xd moved = (X + as_points(u)).colwise() - frame.c;
  const Matrix3Xd d = frame.R.transpose() * moved - (X.colwise() - X_c);
  return d.reshaped();
}

double angle_between(const Eigen::Matrix3d& R, const Eigen::Matrix3d& S) {
  const double half_sine = (R - S).norm() / std::sqrt(8.0);
  return 2 * std::asin(std::min(1.0, half_sine));
}

}  // namespace mb
