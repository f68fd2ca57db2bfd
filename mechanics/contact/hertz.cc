#include "mechanics/contact/hertz.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

void require(bool holds, const char* what, double value) {
  if (!holds) throw std::invalid_argument(fmt::format("hertz: {}, not {}", what, value));
}

void require_positive(double value, const char* what) { require(std::isfinite(value) && value > 0, what, value); }

// (1 - nu^2)/E [1/Pa]
double compliance(const Material& material) {
  if (!is_uniform(material))
    throw std::invalid_argument("hertz: the contact modulus is that of isotropic materials without inclusions");
  const double nu = material.poissons_ratio;
  require_positive(material.youngs_modulus, "Young's modulus must be positive");
  require(nu > -1 && nu <= 0.5, "Poisson's ratio must lie in (-1, 1/2]", nu);
  return (1 - nu) * (1 + nu) / material.youngs_modulus;
}

void check(const HertzSphere& contact) {
  require_positive(contact.radius, "the radius must be positive");
  require_positive(contact.modulus, "the contact modulus must be positive");
}

HertzState state(const HertzSphere& contact, double approach, double force) {
  const double a = std::sqrt(contact.radius) * std::sqrt(approach);
  return {approach, force, a, 2 / pi * contact.modulus * (a / contact.radius)};
}

void check(const EllipticGap& gap) {
  require_positive(gap.k_1, "a curvature must be positive");
  require_positive(gap.modulus, "the contact modulus must be positive");
  require(std::isfinite(gap.k_2) && gap.k_2 >= gap.k_1, "k_2 must be finite and at least k_1", gap.k_2);
  require(gap.k_2 / gap.k_1 <= 1e12, "k_2/k_1 must be at most 1e12 (a line contact has no approach)",
          gap.k_2 / gap.k_1);
}

// y = ln(b/a), the root of g(y) = ln(B/D) - 2 y - ln(k_2/k_1): near -2/3 ln(k_2/k_1) and, as b/a <= B/D <= 1, between
// -1 and -1/2 of it. Regula falsi with halved ends (Illinois), which keeps the bracket.
double axis_ratio(double curvature_ratio) {
  const double target = std::log(curvature_ratio);
  const auto g = [&](double y) {
    const EllipticIntegrals e = elliptic_integrals(std::exp(y));
    return std::log(e.B / e.D) - 2 * y - target;
  };
  double low = -target, high = -target / 2, g_low = g(low), g_high = g(high);
  const double tolerance = 4e-16 * (1 + target);
  for (int k = 0, side = 0; k < 200 && g_low > tolerance && g_high < -tolerance; ++k) {
    const double y = std::clamp((low * g_high - high * g_low) / (g_high - g_low), low, high), value = g(y);
    if (value > 0) {
      low = y, g_low = value;
      if (side == 1) g_high /= 2;
      side = 1;
    } else {
      high = y, g_high = value;
      if (side == -1) g_low /= 2;
      side = -1;
    }
  }
  return std::exp(g_low <= tolerance ? low : high);
}

}  // namespace

double contact_modulus(const Material& one, const Material& other) { return 1 / (compliance(one) + compliance(other)); }
double contact_modulus(const Material& on_rigid) { return 1 / compliance(on_rigid); }

double hertz_stiffness(const HertzSphere& contact) {
  check(contact);
  return 4.0 / 3 * contact.modulus * std::sqrt(contact.radius);
}

HertzState hertz_at(const HertzSphere& contact, double approach) {
  require(std::isfinite(approach), "the approach must be finite", approach);
  const double k = hertz_stiffness(contact), delta = std::max(approach, 0.0);
  return state(contact, delta, k * delta * std::sqrt(delta));
}

HertzState hertz_under(const HertzSphere& contact, double force) {
  require(std::isfinite(force) && force >= 0, "the force must be finite and not negative", force);
  const double root = std::cbrt(force / hertz_stiffness(contact));
  return state(contact, root * root, force);
}

// a_0 = 1, b_0 = b/a, c_0^2 = m:  K = pi / (2 a_N),  K - E = K sum_n 2^(n-1) c_n^2,  c_(n+1) = c_n^2 / (4 a_(n+1)).
// d_n = c_n^2/m is carried beside c_n, as m itself vanishes with c_1.
EllipticIntegrals elliptic_integrals(double b_over_a) {
  require(b_over_a > 0 && b_over_a <= 1, "b/a must lie in (0, 1]", b_over_a);
  double a = (1 + b_over_a) / 2, b = std::sqrt(b_over_a), c = (1 - b_over_a) / 2;
  double d = (1 - b_over_a) / (4 * (1 + b_over_a)), power = 1, sum = 0.5 + d;
  while (c > 1e-9 * a) {  // the next is below 1e-18
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    power *= 2;
    d *= c * c / (16 * a * a);
    sum += power * d;
    c *= c / (4 * a);
  }
  const double K = pi / (a + b), D = K * sum, B = K - D;
  return {K, B + b_over_a * b_over_a * D, D, B};
}

EllipticContact elliptic_contact(const EllipticGap& gap, double force) {
  check(gap);
  require(std::isfinite(force) && force >= 0, "the force must be finite and not negative", force);
  const double ratio = axis_ratio(gap.k_2 / gap.k_1);
  const auto [K, E, D, B] = elliptic_integrals(ratio);
  const double a = std::cbrt(3 * D / pi * (force / gap.modulus / gap.k_1));
  const double stiffness = pi * gap.modulus * std::sqrt(8 * D / gap.k_1 / K) / (3 * K);
  if (!(a > 0)) return {stiffness, 0, 0, 0, 0};
  return {stiffness, 1.5 * K / pi * (force / gap.modulus) / a, a, ratio * a, 1.5 / pi * force / (ratio * a * a)};
}

}  // namespace mb
