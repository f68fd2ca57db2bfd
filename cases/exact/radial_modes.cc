#include "cases/exact/radial_modes.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

// The root in ((n-1) pi, n pi) is x = n pi - y, y in (0, pi):  (-1)^n times the frequency equation becomes
//
//   g(y) = kappa x cos y - (x^2 - kappa) sin y = 0,   g(0) > 0 > g(pi) but for n = 1, where g vanishes at y = pi, x =
//   0.
//
// Bisection to the last bit of y, which keeps what x = n pi - y cannot: the digits of a small distance from n pi.
double root(double kappa, double n) {
  double low = 0, high = n > 1 ? pi : pi - 1e-9;  // x of the first root is at least sqrt(5 (3 - kappa)), roughly
  for (int k = 0; k < 60; ++k) {
    const double y = 0.5 * (low + high), x = n * pi - y;
    (kappa * x * std::cos(y) > (x * x - kappa) * std::sin(y) ? low : high) = y;
  }
  return n * pi - 0.5 * (low + high);
}

}  // namespace

double traction_ratio(double nu) { return 2 * (1 - 2 * nu) / (1 - nu); }

VectorXd radial_roots(double kappa, Index n_before, Index count) {
  if (!(kappa > 0 && kappa < 3))
    throw std::invalid_argument(fmt::format("radial_roots: kappa = {} not in (0, 3)", kappa));
  if (n_before < 0 || count < 0) throw std::invalid_argument("radial_roots: counts must not be negative");
  VectorXd x(count);
  for (Index i = 0; i < count; ++i) x[i] = root(kappa, static_cast<double>(n_before + 1 + i));
  return x;
}

Bessel spherical_bessel(double z) {
  if (z > 1) {
    const double sine = std::sin(z), cosine = std::cos(z), j1 = (sine / z - cosine) / z;
    return {j1, sine / z - 2 * j1 / z, j1 / z};
  }
  // sin and cos would cancel: j_1(z)/z = sum_k (-z^2/2)^k / (k! (2k+3)!!), j_1' = sum_k (2k+1) (the same terms)
  double term = 1.0 / 3, over_z = 0, derivative = 0;
  for (int k = 0; k < 10; ++k) {
    over_z += term;
    derivative += (2 * k + 1) * term;
    term *= -z * z / (2.0 * (k + 1) * (2 * k + 5));
  }
  return {z * over_z, derivative, over_z};
}

}  // namespace mb
