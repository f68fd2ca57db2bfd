#include <gtest/gtest.h>

#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/superquadric_test_bodies.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double a = 0.3, b = 0.2, c = 0.5;

TEST(MomentVerification, ClosedForms) {
  const Superquadric ellipsoid{{a, b, c}, 1, 1}, octahedron{{a, b, c}, 2, 2}, cone{{a, a, c}, 2, 1};
  const double V = 4 * pi / 3 * a * b * c;
  EXPECT_NEAR(moment(ellipsoid, 0, 0, 0), V, 1e-14 * V);
  EXPECT_NEAR(moment(ellipsoid, 0, 2, 0), V * b * b / 5, 1e-14 * V * b * b);
  EXPECT_NEAR(moment(ellipsoid, 2, 0, 2), V * a * a * c * c / 35, 1e-14 * V * a * a);
  // Simplex: int x^i y^j z^k = i! j! k! / (i + j + k + 3)!, eight of them.
  EXPECT_NEAR(moment(octahedron, 0, 0, 0), 8 * a * b * c / 6, 1e-15);
  EXPECT_NEAR(moment(octahedron, 2, 0, 0), 8 * a * b * c * a * a * 2 / 120, 1e-16);
  EXPECT_NEAR(moment(octahedron, 2, 2, 4), 8 * std::pow(a * b, 3) * std::pow(c, 5) * 96 / 39916800, 1e-20);
  // Double cone: int z^2 = 2 pi a^2 c^3 int_0^1 (1 - t)^2 t^2.
  EXPECT_NEAR(moment(cone, 0, 0, 0), 2 * pi / 3 * a * a * c, 1e-15);
  EXPECT_NEAR(moment(cone, 0, 0, 2), 2 * pi * a * a * c * c * c / 30, 1e-16);
  EXPECT_NEAR(moment(cone, 2, 0, 0), 2 * pi / 4 * std::pow(a, 4) * c / 5, 1e-16);
}

TEST(Moment, OddOnesVanishAndSemiAxesScale) {
  for (const Superquadric& body : testing::bodies()) {
    EXPECT_EQ(moment(body, 1, 0, 0), 0);
    EXPECT_EQ(moment(body, 2, 2, 3), 0);
    const Superquadric unit{Vector3d::Ones(), body.e1, body.e2};
    const double expected =
        moment(unit, 2, 0, 4) * body.semi_axes.prod() * std::pow(body.semi_axes[0], 2) * std::pow(body.semi_axes[2], 4);
    EXPECT_NEAR(moment(body, 2, 0, 4), expected, 1e-14 * expected);
    EXPECT_DOUBLE_EQ(volume(Shape{body}), moment(body, 0, 0, 0));
    EXPECT_LT(moment(body, 0, 0, 0), 8 * body.semi_axes.prod());
  }
}

// Slices: area 4 a1 a2 Gamma(1 + 1/p)^2 / Gamma(1 + 2/p) (1 - t^q)^(2/q), by the substitution t = sin^2: the trapezium
// rule, whose ends are smooth enough for 1e-9 from e = 0.37 to 2.
TEST(Moment, IsTheIntegralOfSlices) {
  for (const Superquadric& body : testing::bodies()) {
    if (body.e1 < 0.3) continue;
    const double p = 2 / body.e2, q = 2 / body.e1;
    const double slice =
        4 * body.semi_axes[0] * body.semi_axes[1] * std::pow(std::tgamma(1 + 1 / p), 2) / std::tgamma(1 + 2 / p);
    double volume = 0, second = 0;
    const int n = 20000;
    for (int k = 1; k < n; ++k) {
      const double angle = 0.5 * pi * k / n, t = std::pow(std::sin(angle), 2);
      const double weight =
          2 * slice * std::pow(-std::expm1(q * std::log(t)), 2 / q) * std::sin(2 * angle) * 0.5 * pi / n;
      volume += weight;
      second += weight * t * t;
    }
    const double z = body.semi_axes[2];
    EXPECT_NEAR(moment(body, 0, 0, 0), volume * z, 1e-7 * volume * z) << body.e1 << " " << body.e2;
    EXPECT_NEAR(moment(body, 0, 0, 2), second * z * z * z, 1e-7 * second * z * z * z) << body.e1 << " " << body.e2;
  }
}

TEST(SurfaceMomentsVerification, ClosedForms) {
  const auto area = [](const Superquadric& body) { return surface_moments(body).area; };
  const SurfaceMoments sphere = surface_moments({{a, a, a}, 1, 1});
  EXPECT_NEAR(sphere.area, 4 * pi * a * a, 1e-12 * sphere.area);
  EXPECT_LT((sphere.second - Vector3d::Constant(4 * pi * std::pow(a, 4) / 3)).norm(), 1e-12 * sphere.area * a * a);
  // Spheroids (Zwillinger 2003, CRC Standard Mathematical Tables, sect. 4.19).
  const double oblate = std::sqrt(1 - b * b / (a * a)), prolate = std::sqrt(1 - a * a / (c * c));
  const std::vector<std::pair<Superquadric, double>> exact = {
      {{{a, a, b}, 1, 1}, 2 * pi * a * a * (1 + (1 - oblate * oblate) / oblate * std::atanh(oblate))},
      {{{a, a, c}, 1, 1}, 2 * pi * a * a * (1 + c / (a * prolate) * std::asin(prolate))},
      {{{a, a, a}, 2, 2}, 4 * std::sqrt(3) * a * a},
      {{{a, b, c}, 2, 2}, 4 * std::sqrt(a * a * b * b + b * b * c * c + c * c * a * a)},
      {{{a, a, c}, 2, 1}, 2 * pi * a * std::sqrt(a * a + c * c)}};
  double worst = 0;
  for (const auto& [body, expected] : exact) {
    const double found = area(body);
    EXPECT_NEAR(found, expected, 1e-12);
    worst = std::max(std::abs(found - expected), worst);
  }
  // Almost a box, from inside.
  const double box = 8 * (a * b + b * c + c * a);
  EXPECT_LT(area({{a, b, c}, 0.1, 0.1}), box);
  EXPECT_GT(area({{a, b, c}, 0.1, 0.1}), 0.9 * box);
  testing::expect_verified(
      {.quantity = "areas of two spheroids, two octahedra and a double cone [m^2]",
       .reference = "exact solution",
       .source = "Zwillinger 2003, CRC Standard Mathematical Tables, sect. 4.19; plane triangles; the cone's slant",
       .uncertainty = "rounding",
       .tolerance = 1e-12,
       .why = "Rounding of a sum of 2e4 terms; the double exponential rule itself ends at weights of 1e-17."},
      worst);
}

// Gauss: int x . n dA = 3 V; with n = grad N / |grad N| and x . grad N = 1 this ties areas to volumes.
TEST(SurfaceQuadrature, SatisfiesGausssTheorem) {
  for (const Superquadric& body : testing::bodies()) {
    const Quadrature on = surface_quadrature(body);
    double flux = 0;
    for (Index i = 0; i < on.weights.size(); ++i)
      flux += on.weights[i] * on.points.col(i).dot(outward_normal(body, on.points.col(i)));
    const double V = volume(Shape{body});
    EXPECT_NEAR(flux, 3 * V, 0.05 * 3 * V) << body.e1 << " " << body.e2;  // 216 points across edges
  }
}

TEST(SuperquadricQuadrature, HasPositiveWeightsExactMomentsAndExactPoints) {
  for (const Superquadric& body : testing::bodies()) {
    const Quadrature in = volume_quadrature(body), on = surface_quadrature(body);
    EXPECT_EQ(in.weights.size(), 288);
    EXPECT_EQ(on.weights.size(), 216);
    EXPECT_GT(in.weights.minCoeff(), 0);
    EXPECT_GT(on.weights.minCoeff(), 0);
    const double V = volume(Shape{body});
    EXPECT_NEAR(in.weights.sum(), V, 1e-14 * V);
    const SurfaceMoments surface = surface_moments(body);
    EXPECT_NEAR(on.weights.sum(), surface.area, 1e-14 * surface.area);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(on.weights.dot(on.points.row(i).cwiseAbs2()), surface.second[i], 1e-12 * surface.second[i]);
      const double fourth = moment(body, i == 0 ? 4 : 0, i == 1 ? 4 : 0, i == 2 ? 4 : 0);
      EXPECT_NEAR(in.weights.dot(in.points.row(i).array().pow(4).matrix()), fourth, 1e-12 * fourth);
    }
    for (Index k = 0; k < on.weights.size(); ++k) EXPECT_NEAR(gauge(body, on.points.col(k)), 1, 1e-14);
    for (Index k = 0; k < in.weights.size(); ++k) EXPECT_LT(gauge(body, in.points.col(k)), 1);
  }
}

}  // namespace
}  // namespace mb
