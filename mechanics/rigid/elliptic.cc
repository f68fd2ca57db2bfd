#include "mechanics/rigid/elliptic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/types.h"

namespace mb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double converged = 1e-8;  // of (a - g)/a: one more mean leaves its square

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

}  // namespace

JacobiFunctions::JacobiFunctions(double m1) {
  require(m1 >= 0 && m1 <= 1, "JacobiFunctions: m1 is not in [0, 1]");
  g_[0] = std::sqrt(m1);
  if (m1 == 0) return;  // K is infinite: hyperbolic functions
  double a = 1, g = g_[0];
  while (true) {
    a_[n_] = a;
    g_[n_++] = g;
    const double next = 0.5 * (a + g);
    if (a - g <= converged * a || n_ == max_levels) {
      mean_ = next;
      return;
    }
    g = std::sqrt(a * g);
    a = next;
  }
}

Jacobi JacobiFunctions::at(double u) const {
  if (n_ == 0) {
    const double sech = 1 / std::cosh(u);
    return {std::tanh(u), sech, sech};
  }
  if (std::abs(u) < 1e-9) return {u, 1 - 0.5 * u * u, 1 - 0.5 * u * u * (1 - g_[0] * g_[0])};  // cot overflows
  const double sine = std::sin(mean_ * u);
  double a = std::cos(mean_ * u) / sine, c = mean_ * a, dn = 1;
  for (int n = n_ - 1; n >= 0; --n) {
    a *= c;
    c *= dn;
    dn = (g_[n] + a) / (a_[n] + a);
    a = c / a_[n];
  }
  const double sn = std::copysign(1 / std::sqrt(1 + c * c), sine);
  return {sn, c * sn, dn};
}

double agm(double a, double g) {
  require(a >= 0 && g >= 0, "agm: a number is negative");
  if (g > a) std::swap(a, g);
  if (g == 0) return 0;
  while (a - g > converged * a) {
    const double next = 0.5 * (a + g);
    g = std::sqrt(a * g);
    a = next;
  }
  return 0.5 * (a + g);
}

double carlson_rf(double x, double y, double z) {
  require(std::min({x, y, z}) >= 0 && std::min({x + y, y + z, z + x}) > 0 && std::isfinite(x + y + z),
          "carlson_rf: a number is negative or infinite, or two are 0");
  const double mean0 = (x + y + z) / 3;
  double mean = mean0, scale = 1;
  const double X0 = mean0 - x, Y0 = mean0 - y;
  const double spread = std::max({std::abs(X0), std::abs(Y0), std::abs(mean0 - z)}) * std::pow(0.25 * eps, -1.0 / 8);
  while (scale * spread > mean) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z), lambda = rx * ry + ry * rz + rz * rx;
    x = 0.25 * (x + lambda), y = 0.25 * (y + lambda), z = 0.25 * (z + lambda);
    mean = 0.25 * (mean + lambda);
    scale *= 0.25;
  }
  const double X = scale * X0 / mean, Y = scale * Y0 / mean, Z = -X - Y;
  const double E2 = X * Y - Z * Z, E3 = X * Y * Z;
  return (1 + E2 * (-1.0 / 10 + E2 / 24 - 5.0 / 208 * E2 * E2 - 3.0 / 44 * E3) +
          E3 * (1.0 / 14 + 3.0 / 104 * E3 + E2 * E2 / 16)) /
         std::sqrt(mean);
}

double mean_of_third_kind(double m1, double r) {
  require(m1 >= 0 && m1 <= 1 && r > 0 && std::isfinite(r), "mean_of_third_kind: m1 is not in [0, 1] or r not > 0");
  double a = 1, g = std::sqrt(m1), p = 1 / std::sqrt(r), Q = 1, sum = 1;
  while (std::abs(Q) > 0.25 * eps * sum) {
    const double pp = p * p, ag = a * g;
    Q *= 0.5 * (pp - ag) / (pp + ag);
    sum += Q;
    p = 0.5 * (pp + ag) / p;
    a = 0.5 * (a + g);
    g = std::sqrt(ag);
  }
  return 0.5 * sum;
}

ThetaArgument::ThetaArgument(double m, double m1, double b) : M_(agm(1, std::sqrt(m1))), M_dash_(agm(1, std::sqrt(m))) {
  require(m <= 1 && m1 <= 1 && b >= 0, "ThetaArgument: m and m1 are not in [0, 1] or b is negative");
  near_separatrix_ = 2 * M_ < M_dash_;
  if (near_separatrix_) {
    nome_ = std::exp(-pi * M_dash_ / (2 * M_));
    slope_ = -M_ * M_dash_ * b / pi;
    for (int n = 0; n < 4; ++n) {
      cos_[n] = std::cos((n + 0.5) * M_dash_ * b);
      sin_[n] = std::sin((n + 0.5) * M_dash_ * b);
      power_[n] = n == 0 ? 1 : std::pow(nome_, n * n - n);
    }
  } else if (m > 0) {
    outer_ = std::exp(2 * M_ * (b - pi / M_dash_));
    inner_ = outer_ * std::exp(-4 * M_ * b);
  }
}

// Near the separatrix sum_n nome^(n^2 + n) cosh((2n + 1) (x + i y)), scaled by 2 exp(-|x|); else
// 1 + sum_n (-1)^n (inner_n exp(2 i n z) + outer_n exp(-2 i n z)), outer_n = q^(2 n^2) exp(n pi b / K).
double ThetaArgument::at(double u) const {
  double re = 0, im = 0;
  if (near_separatrix_) {
    const double x = 0.5 * M_dash_ * std::abs(u), decay = std::exp(-2 * x);
    const double growth = std::exp(2 * x - pi * M_dash_ / M_);  // nome^2 exp(2x) <= nome
    double power = 1, opposite = decay;                         // growth^n, decay^(2n + 1)
    for (int n = 0; n < 4; ++n, power *= growth, opposite *= decay * decay) {
      re += power * power_[n] * (1 + opposite) * cos_[n];
      im += power * power_[n] * (1 - opposite) * sin_[n];
    }
    return std::atan2(std::copysign(im, u), re) + slope_ * u;
  }
  const double c = std::cos(2 * M_ * u), s = std::sin(2 * M_ * u), both = outer_ * inner_;
  const double c2 = c * c - s * s, s2 = 2 * c * s;
  const double outer2 = outer_ * outer_ * both, inner2 = inner_ * inner_ * both;
  const double outer3 = outer2 * outer_ * both * both, inner3 = inner2 * inner_ * both * both;
  re = 1 - (outer_ + inner_) * c + (outer2 + inner2) * c2 - (outer3 + inner3) * (c * c2 - s * s2);
  im = (outer_ - inner_) * s - (outer2 - inner2) * s2 + (outer3 - inner3) * (s * c2 + c * s2);
  return std::atan2(im, re);
}

}  // namespace mb
