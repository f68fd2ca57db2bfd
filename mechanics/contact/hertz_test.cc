#include "mechanics/contact/hertz.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/geometry/gauss.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

const Material steel{207e9, 0.29, 7850}, spruce{10e9, 0.35, 430};

TEST(HertzTest, ContactModulus) {
  const double plane_strain = steel.youngs_modulus / (1 - 0.29 * 0.29);
  EXPECT_NEAR(contact_modulus(steel), plane_strain, 1e-15 * plane_strain);
  EXPECT_NEAR(contact_modulus(steel, steel), plane_strain / 2, 1e-15 * plane_strain);
  EXPECT_EQ(contact_modulus(steel, spruce), contact_modulus(spruce, steel));
  EXPECT_NEAR(1 / contact_modulus(steel, spruce), 1 / contact_modulus(steel) + 1 / contact_modulus(spruce), 1e-25);
}

// delta = a^2/R, p_0 = 3F/(2 pi a^2) and the pressure p_0 sqrt(1 - r^2/a^2) carries F; both doors lead to one state.
TEST(HertzTest, SphereIsConsistent) {
  const HertzSphere contact{0.013, 8.1e10};
  for (const double approach : {1e-12, 3.7e-8, 2.2e-6, 4e-4}) {
    const HertzState s = hertz_at(contact, approach), t = hertz_under(contact, s.force);
    EXPECT_EQ(s.approach, approach);
    EXPECT_NEAR(s.contact_radius * s.contact_radius / contact.radius, approach, 1e-15 * approach);
    EXPECT_NEAR(2 * pi / 3 * s.peak_pressure * s.contact_radius * s.contact_radius, s.force, 2e-15 * s.force);
    EXPECT_NEAR(hertz_stiffness(contact) * std::pow(approach, 1.5), s.force, 1e-15 * s.force);
    EXPECT_NEAR(t.approach, approach, 2e-15 * approach);
    EXPECT_NEAR(t.peak_pressure, s.peak_pressure, 2e-15 * s.peak_pressure);
  }
  for (const HertzState& s : {hertz_at(contact, 0), hertz_at(contact, -1e-3), hertz_under(contact, 0)}) {
    EXPECT_EQ(s.approach, 0);
    EXPECT_EQ(s.force, 0);
    EXPECT_EQ(s.contact_radius, 0);
    EXPECT_EQ(s.peak_pressure, 0);
  }
}

// K = int dphi / Delta, D = int sin^2 / Delta, B = int cos^2 / Delta, Delta^2 = cos^2 + (b/a)^2 sin^2 over a quarter:
// periodic, so that equally spaced points (here at phi = (i + 1/2) pi / 2n) converge like (1 - b/a)^2n / (1 + b/a)^2n.
TEST(HertzVerification, EllipticIntegralsByQuadrature) {
  for (const double ratio : {1.0, 1 - 1e-13, 0.999, 0.7, 0.2, 0.01}) {
    const int n = 4000;
    long double K = 0, D = 0, B = 0;  // 4000 terms would round to 1e-13
    for (int i = 0; i < n; ++i) {
      const double phi = (i + 0.5) * pi / (2 * n), sine = std::sin(phi), cosine = std::cos(phi);
      const double weight = pi / (2 * n) / std::hypot(cosine, ratio * sine);
      K += weight, D += weight * sine * sine, B += weight * cosine * cosine;
    }
    const EllipticIntegrals e = elliptic_integrals(ratio);
    const auto relative = [](double value, long double exact) { return static_cast<double>(value / exact - 1); };
    EXPECT_NEAR(relative(e.K, K), 0, 1e-15) << ratio;
    EXPECT_NEAR(relative(e.D, D), 0, 4e-15) << ratio;
    EXPECT_NEAR(relative(e.B, B), 0, 4e-15) << ratio;  // K - D, where K is larger
    EXPECT_NEAR(relative(e.E, K - (1 - ratio) * (1 + ratio) * D), 0, 1e-14) << ratio;
  }
}

// Abramowitz & Stegun 1964, table 17.1, m = 1/2; and Legendre's relation E K' + E' K - K K' = pi/2.
TEST(HertzVerification, EllipticIntegralsOfTables) {
  const EllipticIntegrals half = elliptic_integrals(std::sqrt(0.5));
  EXPECT_NEAR(half.K, 1.854074677301372, 1e-15);
  EXPECT_NEAR(half.E, 1.350643881047675, 1e-15);
  double worst = 0;
  for (const double ratio : {1e-9, 1e-4, 0.03, 0.4, 0.8}) {
    const EllipticIntegrals e = elliptic_integrals(ratio), c = elliptic_integrals(std::sqrt((1 - ratio) * (1 + ratio)));
    const double legendre = e.E * c.K + e.K * (c.E - c.K);
    EXPECT_NEAR(legendre, pi / 2, 1e-13) << ratio;
    worst = std::max(std::abs(legendre - pi / 2), worst);
    EXPECT_GE(e.B, ratio * e.D) << ratio;  // the bracket of the axis ratio
    EXPECT_LE(e.B, e.D) << ratio;
  }
  // m -> 1: K ~ ln(4 a/b), E ~ 1, beyond the squares that tiny axes would underflow in
  const EllipticIntegrals thin = elliptic_integrals(1e-200);
  EXPECT_NEAR(thin.K, std::log(4.0) + 200 * std::log(10.0), 1e-12);
  EXPECT_NEAR(thin.E, 1, 1e-12);
  testing::expect_verified({.quantity = "complete elliptic integral K at m = 1/2",
                            .reference = "published",
                            .source = "Abramowitz and Stegun 1964, table 17.1",
                            .uncertainty = "5e-16, the digits printed",
                            .tolerance = 1e-15,
                            .why = "Half of the last digit and two roundings."},
                           half.K - 1.854074677301372);
  testing::expect_verified({.quantity = "E K' + E' K - K K' - pi/2 of axis ratios 1e-9 to 0.8",
                            .reference = "property",
                            .source = "Legendre's relation (DLMF 19.7.1)",
                            .uncertainty = "rounding",
                            .tolerance = 1e-13,
                            .why = "K reaches 22 and multiplies a difference of two rounded integrals: some 1e-14."},
                           worst);
}

TEST(HertzTest, CircularEllipseIsTheSphere) {
  const HertzSphere sphere{0.04, 3e10};
  const HertzState s = hertz_under(sphere, 21);
  for (const double excess : {0.0, 1e-15, 1e-12, 1e-8}) {  // k_2/k_1 - 1 is met to first order: 1/R = sqrt(k_1 k_2)
    const EllipticContact e = elliptic_contact({25, 25 * (1 + excess), 3e10}, 21);
    const double tolerance = 1e-14 + 2 * excess;
    EXPECT_NEAR(e.stiffness, hertz_stiffness(sphere), tolerance * e.stiffness) << excess;
    EXPECT_NEAR(e.approach, s.approach, tolerance * e.approach) << excess;
    EXPECT_NEAR(e.peak_pressure, s.peak_pressure, tolerance * e.peak_pressure) << excess;
    EXPECT_NEAR(std::sqrt(e.a * e.b), s.contact_radius, tolerance * e.a) << excess;
    EXPECT_LE(e.b, e.a);
    EXPECT_NEAR(1 - e.b / e.a, 2.0 / 3 * excess, 2e-15 + excess * excess);  // (k_1/k_2)^(2/3)
  }
}

// Displacement of the half-space under the semi-ellipsoid of pressure, by quadrature in polar coordinates about the
// point, int p/r r dr dtheta / (pi E*): inside it must be delta - k_1 x^2/2 - k_2 y^2/2.
double displacement(const EllipticContact& e, double modulus, double x, double y) {
  double sum = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i) {
    const double theta = 2 * pi * (i + 0.5) / n, cx = std::cos(theta) / e.a, cy = std::sin(theta) / e.b;
    const double A = cx * cx + cy * cy, B = x / e.a * cx + y / e.b * cy,
                 C = 1 - x * x / (e.a * e.a) - y * y / (e.b * e.b);
    const double root = std::sqrt(B * B + A * C);  // 1 - rho^2 along the ray: C - 2 B r - A r^2
    // int_0^r1 sqrt(C - 2 B r - A r^2) dr = ((C + B^2/A) acos(B/root) - B sqrt(C)) / (2 sqrt(A)) scaled
    sum += (root * root / A * std::acos(B / root) / std::sqrt(A) - B * std::sqrt(C) / A) / 2;
  }
  return e.peak_pressure * sum * 2 * pi / n / (pi * modulus);
}

TEST(HertzVerification, EllipseFlattensTheGap) {
  double worst = 0;
  for (const double ratio : {1.0, 1.3, 4.0, 60.0}) {
    const EllipticGap gap{1.7, 1.7 * ratio, 5e9};
    const EllipticContact e = elliptic_contact(gap, 33);
    EXPECT_NEAR(2 * pi / 3 * e.peak_pressure * e.a * e.b, 33, 1e-13 * 33);
    EXPECT_NEAR(e.stiffness * std::pow(e.approach, 1.5), 33, 1e-13 * 33);
    for (const double r : {0.0, 0.4, 0.9})
      for (const double theta : {0.0, 0.7, pi / 2}) {
        const double x = r * e.a * std::cos(theta), y = r * e.b * std::sin(theta);
        const double expected = e.approach - gap.k_1 * x * x / 2 - gap.k_2 * y * y / 2;
        const double found = displacement(e, gap.modulus, x, y);
        EXPECT_NEAR(found, expected, 1e-12 * e.approach) << ratio << " " << r;
        worst = std::max(std::abs(found - expected) / e.approach, worst);
      }
  }
  testing::expect_verified(
      {.quantity = "displacement under Hertz's pressure on ellipses, curvature ratios 1 to 60, over the approach",
       .reference = "second route",
       .source = "Boussinesq's integral over the ellipse (Johnson 1985, sect. 3.5) by quadrature in polar coordinates",
       .uncertainty = "1e-13: 400 angles at b/a = 0.074 leave exp(-400 b/a)",
       .tolerance = 1e-12,
       .why = "Ten times what the quadrature leaves on the slenderest ellipse."},
      worst);
}

// Slender contacts keep their equation, and k_2 > k_1 makes b < a steadily.
TEST(HertzTest, SlenderEllipses) {
  double previous = 1;
  for (const double ratio : {1 + 1e-6, 1.1, 3.0, 1e2, 1e5, 1e9, 1e12}) {
    const EllipticContact e = elliptic_contact({0.3, 0.3 * ratio, 1e9}, 5);
    const double axes = e.b / e.a;
    const EllipticIntegrals integrals = elliptic_integrals(axes);
    EXPECT_NEAR(integrals.B / (axes * axes * integrals.D), ratio, 4e-14 * ratio);
    EXPECT_LT(axes, previous);
    previous = axes;
  }
  const EllipticContact none = elliptic_contact({0.3, 0.9, 1e9}, 0);
  EXPECT_EQ(none.approach + none.a + none.b + none.peak_pressure, 0);
  EXPECT_GT(none.stiffness, 0);
}

TEST(HertzTest, RefusesBadInput) {
  for (const double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_THROW(contact_modulus({bad, 0.3, 1}), std::invalid_argument);
    EXPECT_THROW(hertz_stiffness({bad, 1}), std::invalid_argument);
    EXPECT_THROW(hertz_stiffness({1, bad}), std::invalid_argument);
    EXPECT_THROW(elliptic_contact({bad, 2, 1}, 1), std::invalid_argument);
    EXPECT_THROW(elliptic_contact({1, bad, 1}, 1), std::invalid_argument);
    EXPECT_THROW(elliptic_contact({1, 2, bad}, 1), std::invalid_argument);
  }
  for (const double nu : {-1.0, 0.51, nan}) EXPECT_THROW(contact_modulus({1, nu, 1}), std::invalid_argument);
  EXPECT_NEAR(contact_modulus({1, 0.5, 1}), 4.0 / 3, 1e-15);
  Material wood = spruce;
  wood.orthotropy = {Vector3d(1, 2, 3), Vector3d::Zero(), Vector3d(1, 1, 1)};
  EXPECT_THROW(contact_modulus(wood), std::invalid_argument);
  EXPECT_THROW(contact_modulus(steel, wood), std::invalid_argument);
  EXPECT_THROW(hertz_at({1, 1}, nan), std::invalid_argument);
  for (const double force : {-1.0, nan, inf}) {
    EXPECT_THROW(hertz_under({1, 1}, force), std::invalid_argument);
    EXPECT_THROW(elliptic_contact({1, 2, 1}, force), std::invalid_argument);
  }
  EXPECT_THROW(elliptic_contact({2, 1, 1}, 1), std::invalid_argument);
  EXPECT_THROW(elliptic_contact({1, 1e13, 1}, 1), std::invalid_argument);
  for (const double ratio : {0.0, -1.0, 1.1, nan}) EXPECT_THROW(elliptic_integrals(ratio), std::invalid_argument);
}

}  // namespace
}  // namespace mb
