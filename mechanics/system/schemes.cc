#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "mechanics/system/stability.h"

// Amplification of (q, p), p = h v, less the identity, with x = omega h; lagged schemes take p half a step before.

namespace mb {

namespace {

constexpr double none = std::numeric_limits<double>::infinity(), unknown = std::numeric_limits<double>::quiet_NaN();

Matrix2d matrix(double a, double b, double c, double d) { return (Matrix2d() << a, b, c, d).finished(); }

Matrix2d explicit_euler_increment(double x, double zeta) { return matrix(0, 1, -x * x, -2 * zeta * x); }

// p+ = p - (x^2 q + 2 zeta x p)/D,  q+ = q + p+.  D = 1: damping explicit; 1 + zeta x: by the mean of p and p+;
// 1 + 2 zeta x: by p+.
Matrix2d leap_frog(double x, double zeta, double D) {
  const double c = -x * x / D, d = -2 * zeta * x / D;
  return matrix(c, 1 + d, c, d);
}

// q+ = q + p + (1/2 - beta) a + beta a+,  p+ = p + (1 - gamma) a + gamma a+,  a = -x^2 q - 2 zeta x p, a+ alike:
// solved by hand, since at large x a matrix inverse cancels.
Matrix2d newmark_increment(double x, double zeta, double beta, double gamma) {
  const double k = x * x, c = 2 * zeta * x, D = 1 + gamma * c + beta * k;
  const double of_a_in_q = 0.5 + (gamma / 2 - beta) * c, of_a_in_p = 1 + (beta - gamma / 2) * k;
  return matrix(-k * of_a_in_q, 1 + gamma * c - c * of_a_in_q, -k * of_a_in_p, -c * of_a_in_p - gamma * k) / D;
}

// L + L^2/2 + ... + L^order/order!
Matrix2d runge_kutta(double x, double zeta, int order) {
  const Matrix2d L = matrix(0, 1, -x * x, -2 * zeta * x);
  Matrix2d sum = L, power = L;
  for (int i = 2; i <= order; ++i) {
    power = power * L / i;
    sum += power;
  }
  return sum;
}

Scheme newmark_scheme(double beta, double gamma, const std::string& name, const std::string& integrator) {
  const auto formula = [=](double zeta) {
    const double a = gamma / 2 - beta, b = zeta * (gamma - 0.5);
    return a > 0 ? (b + std::sqrt(a + b * b)) / a : none;
  };
  const bool unconditional = 2 * beta >= gamma;
  return {name,
          integrator,
          [=](double x, double zeta) { return newmark_increment(x, zeta, beta, gamma); },
          formula,
          unconditional ? "none" : "(zeta (g - 1/2) + sqrt(g/2 - b + zeta^2 (g - 1/2)^2)) / ((g/2 - b) omega)",
          "Hughes 2000, The Finite Element Method, sect. 9.1.2"};
}

Scheme runge_kutta_scheme(int order, double undamped, const std::string& formula_text) {
  return {fmt::format("rk{}", order),
          "",
          [=](double x, double zeta) { return runge_kutta(x, zeta, order); },
          [=](double zeta) { return zeta == 0 ? undamped : unknown; },
          formula_text + " (undamped)",
          "Hairer & Wanner 1996, Solving Ordinary Differential Equations II, sect. IV.2"};
}

double explicit_euler_limit(double zeta) { return 2 * (zeta <= 1 ? zeta : 1 / (zeta + std::sqrt(zeta * zeta - 1))); }
double damping_lowers(double zeta) { return 2 / (std::sqrt(1 + zeta * zeta) + zeta); }
double damping_raises(double zeta) { return 2 * (std::sqrt(1 + zeta * zeta) + zeta); }

std::vector<Scheme> all_schemes() {
  const std::string leap_frog_source = "Belytschko, Liu & Moran 2000, Nonlinear Finite Elements, sect. 6.6";
  const std::string lowers = "2 (sqrt(1 + zeta^2) - zeta) / omega", raises = "2 (sqrt(1 + zeta^2) + zeta) / omega";
  std::vector<Scheme> all = {
      {"explicit-euler", "explicit-euler", explicit_euler_increment, explicit_euler_limit,
       "2 zeta / omega; 2 (zeta - sqrt(zeta^2 - 1)) / omega for zeta > 1", "eigenvalues of A"},
      {"symplectic-euler", "symplectic-euler", [](double x, double zeta) { return leap_frog(x, zeta, 1); },
       damping_lowers, lowers, "eigenvalues of A; undamped: " + leap_frog_source},
      {"symplectic-euler, implicit damping", "",
       [](double x, double zeta) { return leap_frog(x, zeta, 1 + 2 * zeta * x); }, damping_raises, raises,
       "eigenvalues of A"},
      {"central-difference", "central-difference",
       [](double x, double zeta) { return leap_frog(x, zeta, 1 + zeta * x); }, [](double) { return 2.0; }, "2 / omega",
       leap_frog_source},
      {"central-difference, lagged damping", "central-difference",
       [](double x, double zeta) { return leap_frog(x, zeta, 1); }, damping_lowers, lowers, leap_frog_source},
      newmark_scheme(0.25, 0.5, "newmark", "newmark"),
      newmark_scheme(0, 0.5, "newmark (0, 1/2)", ""),
      newmark_scheme(1. / 12, 0.5, "newmark (1/12, 1/2)", ""),
      newmark_scheme(1. / 6, 0.5, "newmark (1/6, 1/2)", ""),
      newmark_scheme(0, 0.6, "newmark (0, 0.6)", ""),
      newmark_scheme(0.1, 0.6, "newmark (0.1, 0.6)", ""),
      newmark_scheme(0.3025, 0.6, "newmark (0.3025, 0.6)", ""),
      runge_kutta_scheme(2, 0, "0"),
      runge_kutta_scheme(3, std::sqrt(3.0), "sqrt(3) / omega"),
      runge_kutta_scheme(4, std::sqrt(8.0), "2 sqrt(2) / omega"),
  };
  return all;
}

}  // namespace

Matrix2d lagged_amplification(double omega_h, double zeta, double zeta_by_mean) {
  return Matrix2d::Identity() + leap_frog(omega_h, zeta, 1 + zeta_by_mean * omega_h);
}

const std::vector<Scheme>& schemes() {
  static const std::vector<Scheme> all = all_schemes();
  return all;
}

}  // namespace mb
