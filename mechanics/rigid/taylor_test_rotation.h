// An independent target for free rotation: Taylor series of Euler's equations and of q' = q (0, w)/2 in long double,
//
//   (n + 1) I1 w1_{n+1} = (I2 - I3) sum_k w2_k w3_{n-k},   and cyclically;   2 (n + 1) q_{n+1} = sum_k q_k (0, w_{n-k})
//
// of order 24, each step as long as the last terms stay below the rounding of long double. Passing by the intermediate
// axis at a distance of 1e-10 it has 1e-9 left: such motions need more digits than this target has.
#pragma once

#include <algorithm>
#include <cmath>

#include "mechanics/rigid/torque_free.h"
#include "mechanics/types.h"

namespace mb::taylor {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Quaternion = Eigen::Quaternion<Real>;

inline constexpr int order = 24;

struct Series {
  Eigen::Matrix<Real, 3, order + 1> w;  // [rad/s^(1+n)] body axes
  Eigen::Matrix<Real, 4, order + 1> q;
};

inline Series series(const Vector& I, const Vector& w0, const Quaternion& q0) {
  Series s;
  s.w.col(0) = w0;
  s.q.col(0) = q0.coeffs();
  const Vector c((I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]);
  for (int n = 0; n < order; ++n) {
    Vector w = Vector::Zero();
    Eigen::Matrix<Real, 4, 1> q = Eigen::Matrix<Real, 4, 1>::Zero();
    for (int k = 0; k <= n; ++k) {
      const Vector a = s.w.col(k), b = s.w.col(n - k);
      w += Vector(a[1] * b[2], a[2] * b[0], a[0] * b[1]);
      q += (Quaternion(s.q.col(k)) * Quaternion(0, b[0], b[1], b[2])).coeffs();
    }
    s.w.col(n + 1) = c.cwiseProduct(w) / (n + 1);
    s.q.col(n + 1) = q / (2 * (n + 1));
  }
  return s;
}

// Step [s] at which neither of the last two terms matters.
inline Real longest_step(const Series& s) {
  Real rate = 0;
  for (const int n : {order - 1, order}) {
    const Real size = std::max(s.w.col(n).norm() / s.w.col(0).norm(), s.q.col(n).norm());
    rate = std::max(rate, std::pow(size / Real(1e-20), Real(1) / n));
  }
  return 1 / rate;
}

// w0 not 0.
inline Rotation rotation(const Vector3d& moments, const Eigen::Quaterniond& q0, const Vector3d& omega0, double t) {
  const Vector I = moments.cast<Real>();
  Vector w = omega0.cast<Real>();
  Quaternion q = q0.cast<Real>();
  for (Real left = std::abs(t); left > 0;) {
    const Series s = series(I, w, q);
    const Real step = std::min(left, longest_step(s)), h = t < 0 ? -step : step;
    w = s.w.col(order), q.coeffs() = s.q.col(order);
    for (int n = order - 1; n >= 0; --n) w = s.w.col(n) + h * w, q.coeffs() = s.q.col(n) + h * q.coeffs();
    q.normalize();
    left -= step;
  }
  return {q.cast<double>(), w.cast<double>()};
}

}  // namespace mb::taylor
