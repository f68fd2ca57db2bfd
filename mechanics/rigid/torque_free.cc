#include "mechanics/rigid/torque_free.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mechanics/rigid/inertia.h"

namespace mb {

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;

constexpr double steady = 1e-150;  // [-] |w'| / |w|^2 that counts as none

// exp(k phi) S(l) times sqrt(2 (1 + l3)), which lies in [1.4, 2]; l of unit length, l3 >= 0.
Quaterniond turn(double phi, const Vector3d& l) {
  const double c = std::cos(phi), s = std::sin(phi), w = 1 + l[2];
  return Quaterniond(c * w, c * l[1] + s * l[0], s * l[1] - c * l[0], s * w);
}

// The axes named 1, 2, 3 in the header, with signs that make l1, l3 >= 0 and the frame right-handed. Moments and l are
// free of units. r = (1/I2 - 1/I3) / (1/I1 - 1/I3) and 1 - r both come from differences of the given moments.
struct Order {
  Matrix3d to_ordered;
  Vector3d moments;   // I1, I2, I3
  double r, r_rest;   // [-] r > 0 and 1 - r
  double separation;  // [-] r l3^2 - (1 - r) l1^2 >= 0, 0 on the separatrix |L|^2 = 2 T I2
};

Order order(const Vector3d& I, const Vector3d& l) {
  std::array<Index, 3> axis = {0, 1, 2};
  std::sort(axis.begin(), axis.end(), [&](Index i, Index j) { return I[i] < I[j]; });
  const auto [least, middle, most] = axis;
  const double range = I[most] - I[least];
  const double r_most = I[least] / I[middle] * ((I[most] - I[middle]) / range);
  const double r_least = I[most] / I[middle] * ((I[middle] - I[least]) / range);
  // The larger one tells about which of the outer axes l circulates: the sign of |L|^2 - 2 T I2.
  const double to_most = r_most * l[most] * l[most], to_least = r_least * l[least] * l[least];
  const bool about_most = to_most != to_least ? to_most > to_least : r_most >= r_least;
  const Index first = about_most ? least : most, third = about_most ? most : least;

  Order o{Matrix3d(), Vector3d(I[first], I[middle], I[third]), about_most ? r_most : r_least,
          about_most ? r_least : r_most, std::abs(to_most - to_least)};
  o.to_ordered.row(0) = std::copysign(1.0, l[first]) * Vector3d::Unit(first).transpose();
  o.to_ordered.row(2) = std::copysign(1.0, l[third]) * Vector3d::Unit(third).transpose();
  o.to_ordered.row(1) = o.to_ordered.row(2).cross(o.to_ordered.row(0));
  return o;
}

}  // namespace

// The curve that l draws in the body, and how fast.
struct TorqueFree::Polhode {
  Matrix3d to_ordered = Matrix3d::Identity();
  double m = 0, m1 = 1;               // [-] elliptic parameter and 1 - m
  double b = 0;                       // [-] shift of the theta function
  double u0 = 0, lambda = 0;          // [-], [1/s]
  double mu = 0;                      // [rad/s] half the mean of alpha'
  Vector3d l = Vector3d::UnitZ();     // [-] A, B, C
  Vector3d omega = Vector3d::Zero();  // [rad/s] |L| (A/I1, B/I2, C/I3)

  static Polhode of_spin(const Vector3d& omega0);
  static Polhode of(const Vector3d& moments, const Vector3d& omega0);
};

// About a fixed axis, taken for axis 3: A = B = 0.
TorqueFree::Polhode TorqueFree::Polhode::of_spin(const Vector3d& omega0) {
  Polhode p;
  const double speed = omega0.stableNorm();
  if (!(speed > 0)) return p;
  const double up = std::copysign(1.0, omega0[2]);
  const Vector3d half_turn(1, up, up);
  const Quaterniond shortest = turn(0, half_turn.cwiseProduct(omega0 / speed)).normalized();
  p.to_ordered = shortest.toRotationMatrix() * half_turn.asDiagonal();
  p.to_ordered.row(2) = omega0.transpose() / speed;  // exactly: small components keep all their digits
  p.mu = 0.5 * speed;
  p.omega = {0, 0, speed};
  return p;
}

TorqueFree::Polhode TorqueFree::Polhode::of(const Vector3d& moments, const Vector3d& omega0) {
  const double speed = omega0.cwiseAbs().maxCoeff();
  if (!(speed > 0)) return of_spin(omega0);
  // Units in which nothing over- or underflows; a power of two leaves differences of moments exact.
  const int exponent = std::ilogb(moments.maxCoeff());
  const Vector3d I_body = moments.unaryExpr([exponent](double I) { return std::ldexp(I, -exponent); });
  const Vector3d w = omega0 / speed, L_body = I_body.cwiseProduct(w);
  const Vector3d w_dot((I_body[1] - I_body[2]) / I_body[0] * w[1] * w[2],
                       (I_body[2] - I_body[0]) / I_body[1] * w[2] * w[0],
                       (I_body[0] - I_body[1]) / I_body[2] * w[0] * w[1]);
  if (w_dot.cwiseAbs().maxCoeff() <= steady) return of_spin(omega0);
  const double L = L_body.norm();
  const Order o = order(I_body, L_body / L);
  const Vector3d l = o.to_ordered * L_body / L;
  const double B = std::hypot(l[0] / std::sqrt(o.r), l[1]), A = std::sqrt(o.r) * B;
  const double C = std::hypot(l[2], std::sqrt(o.r_rest) * l[1]);

  Polhode p;
  p.to_ordered = o.to_ordered;
  p.l = {A, B, C};
  p.omega = speed * L * p.l.cwiseQuotient(o.moments);
  p.m = std::min(1.0, o.r_rest * (B / C) * (B / C));
  p.m1 = std::min(1.0, o.separation / (o.r * C * C));
  const double sn = l[1] / B, cn = l[0] / A, dn = l[2] / C;
  p.u0 = sn * carlson_rf(cn * cn, dn * dn, 1);
  const double to_1 = speed * L / o.moments[0], to_3 = speed * L / o.moments[2];  // bounds of alpha'
  const double rate = to_1 * ((o.moments[2] - o.moments[0]) / o.moments[2]);      // their difference
  p.lambda = rate * C * std::sqrt(o.r);
  // F(b | m1); without modulation (m = 0) it is infinite and chi = 0.
  p.b = p.m > 0 ? std::sqrt(o.r) * carlson_rf(o.r_rest, o.r_rest + p.m * o.r, 1) : 0;
  // The mean of A^2 / (1 + C dn), or what it lacks to 1, on top of the lower bound: terms of one sign.
  const double lacking = C * std::sqrt(o.r) * agm(1, std::sqrt(p.m1)) + o.r_rest * mean_of_third_kind(p.m1, o.r);
  p.mu = 0.5 * (rate > 0 ? to_3 + rate * A * A * mean_of_third_kind(p.m1, C * C) : to_1 - rate * lacking);
  return p;
}

TorqueFree::TorqueFree(const Polhode& p, const Quaterniond& orientation0)
    : functions_(p.m1),
      chi_(p.m, p.m1, p.b),
      lambda_(p.lambda),
      u0_(p.u0),
      mu_(p.mu),
      l_(p.l),
      omega_(p.omega),
      to_ordered_(p.to_ordered),
      after_(Quaterniond(p.to_ordered).normalized()) {
  const Jacobi j = functions_.at(u0_);
  const Vector3d l0(l_[0] * j.cn, l_[1] * j.sn, l_[2] * j.dn);
  before_ = (orientation0 * after_.conjugate() * turn(-chi_.at(u0_), l0).conjugate()).normalized();
}

TorqueFree::TorqueFree(const Vector3d& principal_moments, const Quaterniond& orientation0, const Vector3d& omega0_body)
    : TorqueFree(
          [&] {
            require_principal_moments(principal_moments, "TorqueFree");
            if (!omega0_body.allFinite()) throw std::invalid_argument("TorqueFree: the angular velocity is not finite");
            if (!(std::abs(orientation0.norm() - 1) <= 1e-6))
              throw std::invalid_argument(
                  fmt::format("TorqueFree: the orientation is a quaternion of length {}, not 1", orientation0.norm()));
            return Polhode::of(principal_moments, omega0_body);
          }(),
          orientation0) {}

Rotation TorqueFree::at(double t) const {
  const double phase = mu_ * t, u = u0_ + lambda_ * t, M = functions_.mean();
  if (!(std::abs(phase) + std::abs(u) < 1e300))
    throw std::invalid_argument(fmt::format("TorqueFree::at: no phase at t = {} s", t));
  // sn and cn change sign every half period 2K = pi / M, dn and chi do not.
  const double halves = std::nearbyint(u * M / pi);
  const double v = halves == 0 ? u : std::fma(-halves, pi / M, u);
  const double sign = 0.5 * halves == std::nearbyint(0.5 * halves) ? 1 : -1;
  const Jacobi j = functions_.at(v);
  const Vector3d f(sign * j.cn, sign * j.sn, j.dn);
  return {(before_ * turn(phase - chi_.at(v), l_.cwiseProduct(f)) * after_).normalized(),
          to_ordered_.transpose() * omega_.cwiseProduct(f)};
}

// |w|^2 is linear in sn^2 in [0, 1] and largest at sn = 0: with 1/I2 = r/I1 + s/I3, s = 1 - r, A^2 = r B^2 and
// m C^2 = s B^2 it falls by |L|^2 B^2 (r/I1^2 + s/I3^2 - 1/I2^2) sn^2, which is not negative (Jensen).
double TorqueFree::max_angular_speed() const {
  return std::hypot(omega_[0], omega_[2]) * (1 + 1e-15);  // rounding must not take it below |w|
}

}  // namespace mb
