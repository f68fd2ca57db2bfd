// For tests: bodies of particles, whose motion in the world's axes is known without any frame.
#pragma once

#include <cmath>
#include <memory>
#include <random>

#include "mechanics/geometry/pose.h"
#include "modal/frame/spin.h"

namespace mb {

// A body of n particles: all it can do is rigid motion and 3 n - 6 modes, so that the modes leave nothing out and its
// motion in the world's axes, of the potential energy q.Lambda q/2 alone, is known without any frame.
struct Particles {
  Matrix3Xd X;  // [m] about the centre of mass
  VectorXd mass;
  MatrixXd Phi;  // 3 n x (3 n - 6)
  FloatingBody body;

  VectorXd masses() const { return mass.replicate(1, 3).transpose().reshaped(); }

  // The frame in which deformation carries no angular momentum: Q^T sum m (x - c) X^T is symmetric (Eckart).
  Eigen::Matrix3d frame(const Matrix3Xd& x) const {
    const Vector3d c = x * mass / mass.sum();
    const Eigen::Matrix3d A = (x.colwise() - c) * mass.asDiagonal() * X.transpose();
    return nearest_rotation(A);
  }
  VectorXd coordinates(const Matrix3Xd& x) const {
    const Vector3d c = x * mass / mass.sum();
    const Matrix3Xd u = frame(x).transpose() * (x.colwise() - c) - X;
    return Phi.transpose() * masses().cwiseProduct(VectorXd(u.reshaped()));
  }
  double potential(const Matrix3Xd& x) const {
    const VectorXd q = coordinates(x);
    double V = 0;
    for (Index i = 0; i < q.size(); ++i) V += 0.5 * body.modes[static_cast<size_t>(i)].k * q[i] * q[i];
    return V;
  }
  Matrix3Xd acceleration(const Matrix3Xd& x) const {
    Matrix3Xd a(3, X.cols());
    const double d = 1e-5;  // error: d^2 and 1e-16 / d of what changes over 1 m
    for (Index k = 0; k < X.cols(); ++k)
      for (Index i = 0; i < 3; ++i) {
        Matrix3Xd up = x, low = x;
        up(i, k) += d, low(i, k) -= d;
        a(i, k) = -(potential(up) - potential(low)) / (2 * d * mass[k]);
      }
    return a;
  }
  Matrix3Xd places(const BodyState& state) const {
    const VectorXd u = Phi * state.q;
    return state.Q.toRotationMatrix() * (X + u.reshaped(3, X.cols()));
  }
  Matrix3Xd velocities(const BodyState& state) const {
    const Spin now = spin(body, state);
    const VectorXd u = Phi * state.q, u_t = Phi * now.rate;
    Matrix3Xd v(3, X.cols());
    for (Index k = 0; k < X.cols(); ++k)
      v.col(k) = state.Q * (now.Omega.cross(Vector3d(X.col(k) + u.segment<3>(3 * k))) + u_t.segment<3>(3 * k));
    return v;
  }
};

inline Particles five_particles() {
  Particles p{Matrix3Xd(3, 5), VectorXd(5), {}, {}};
  p.X << 1, -0.8, 0.1, -0.3, 0.2, 0, 0.7, -0.9, 0.4, 0.1, 0.1, -0.2, -0.3, 0.9, -0.6;
  p.mass << 1, 2, 1.5, 0.7, 1.2;
  p.X.colwise() -= Vector3d(p.X * p.mass / p.mass.sum());
  const VectorXd root = p.masses().cwiseSqrt();
  MatrixXd rigid(15, 6);
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  for (Index k = 0; k < 5; ++k) {
    const Vector3d x = p.X.col(k);
    rigid.block<3, 3>(3 * k, 0).setIdentity();
    for (Index i = 0; i < 3; ++i) rigid.block<3, 1>(3 * k, 3 + i) = Vector3d::Unit(i).cross(x);
    J += p.mass[k] * (x.squaredNorm() * Eigen::Matrix3d::Identity() - x * x.transpose());
  }
  const Eigen::HouseholderQR<MatrixXd> qr(root.asDiagonal() * rigid);
  p.Phi = root.cwiseInverse().asDiagonal() * MatrixXd(qr.householderQ()).rightCols(9);
  p.body = {true, p.mass.sum(), J, Vector3d::Zero(), {}, VectorXd::Zero(9), {}, {}};
  for (int i = 0; i < 9; ++i) p.body.modes.push_back(roots({(20.0 + 7 * i) * (20.0 + 7 * i), 0}));
  p.body.coupling = std::make_shared<const SpinCoupling>(spin_coupling(p.X, p.mass, p.Phi));
  return p;
}

inline BodyState tumbling(const FloatingBody& body, double amplitude) {
  const Index r = body.n_modes();
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  BodyState state{Vector3d::Zero(),    Vector3d::Zero(), Eigen::Quaterniond(0.8, 0.2, -0.5, 0.3).normalized(),
                  Vector3d(9, -5, 12), VectorXd(r),      VectorXd(r),
                  VectorXd(0)};
  for (Index i = 0; i < r; ++i) {
    state.q[i] = amplitude * normal(random);
    state.p[i] = amplitude * body.modes[static_cast<size_t>(i)].omega * normal(random);
  }
  return state;
}

}  // namespace mb
