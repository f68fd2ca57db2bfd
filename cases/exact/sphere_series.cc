#include "cases/exact/sphere_series.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

void check(double nu) {
  if (!(nu > -1 && nu <= 0.5))
    throw std::invalid_argument(fmt::format("sphere: Poisson's ratio must lie in (-1, 1/2], not {}", nu));
}

// n = 1: u = alpha r^2 e_z + beta z r, whose divergence of stress the body force balances,
//   s_1 = (2 alpha + beta) G R,   t_1 = (2 alpha + 4 beta) lambda R + 4 (alpha + beta) G R,
// less its mean over the ball, (3/5 alpha + 1/5 beta) R^2 e_z.
Eigen::Matrix2d accelerated(double nu) {
  Eigen::Matrix2d C;
  for (int column = 0; column < 2; ++column) {
    const double t = column == 0 ? 1 : 0, s = 1 - t;
    const double alpha = (4 * s - (1 - 2 * nu) * t) / 2, beta = 2 * (1 + nu) * s - 2 * alpha;
    const double mean = 0.6 * alpha + 0.2 * beta;
    C.col(column) << alpha + beta - mean, alpha - mean;
  }
  return C;
}

}  // namespace

Eigen::Matrix2d surface_compliance(int n, double nu) {
  check(nu);
  if (n < 0) throw std::invalid_argument(fmt::format("surface_compliance: no order {}", n));
  Eigen::Matrix2d C = Eigen::Matrix2d::Zero();
  if (n == 1) return accelerated(nu);
  if (n == 0) {
    C(0, 0) = 1 - 2 * nu;
    return C;
  }
  const double N = n, D = N * N + N + 1 + nu * (2 * N + 1), cross = (1 - 2 * nu) * N - 2 + nu;
  C << 2 * (1 - nu) * N * N + nu * N - 1 + 2 * nu, -N * (N + 1) * cross,  //
      -cross, 2 * (1 - nu) * N * N + (3 * nu - 1) * N + 1 + nu;
  return (1 + nu) / ((N - 1) * D) * C;
}

// The tail of rho after N terms has an expansion in 1/N: Romberg's scheme over N = 8, 16, ... 4096.
SmallContact small_contact(double nu, PressureAlong along) {
  check(nu);
  const double soft = 1 - 2 * nu, scale = 1 / (3 * pi * (1 - nu));
  std::array<double, 10> sums;
  double sum = 0;
  for (int n = 0, level = 0; level < 10; ++n) {
    if (n == 8 << level) {
      double current = sum;
      for (int k = 0; k < level; ++k) {
        const double next = current + (current - sums[k]) / (std::exp2(k + 1) - 1);
        sums[k] = current;
        current = next;
      }
      sums[level++] = current;
    }
    const double N = 2.0 * n + 1;
    sum += N * surface_compliance(n, nu)(0, 0) / (1 + nu) - 4 * (1 - nu) - 4 * soft * soft / N;
  }
  const double across = along == PressureAlong::plane_normal ? 2 * soft : 0;
  return {scale * (2 * soft * soft * (std::log(2.0) + 19.0 / 12) + sums[9] - across), -2 * soft * soft * scale};
}

}  // namespace mb
