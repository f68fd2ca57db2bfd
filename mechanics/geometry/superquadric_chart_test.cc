#include "mechanics/geometry/superquadric_chart.h"

#include <gtest/gtest.h>

#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/superquadric_projection.h"
#include "mechanics/geometry/superquadric_test_bodies.h"

namespace mb {
namespace {

TEST(Ratios, AreAPairOfUnitNormAndItsDual) {
  for (const double power : {1e-15, 0.05, 0.6, 1.0, 3.0, 19.0})
    for (const double l : {-1e17, -700.0, -40.0, -1.0, -1e-3, 0.0, 0.3, 5.0, 300.0, 1e16}) {
      const Ratios r = ratios(l, power);
      EXPECT_NEAR(r.share_first + r.share_second, 1, 1e-15);
      EXPECT_NEAR(r.first * r.dual_first, r.share_first, 1e-15);
      EXPECT_NEAR(r.second * r.dual_second, r.share_second, 1e-15);
      const Ratios swapped = ratios(-l, power);
      EXPECT_EQ(r.first, swapped.second);
      EXPECT_EQ(r.dual_second, swapped.dual_first);
      if (std::abs(l) < 30) {
        EXPECT_NEAR(r.first / r.second, std::exp(l), 1e-14 * std::exp(l));
        EXPECT_NEAR(std::pow(r.first, power), r.dual_first, 1e-13);
        EXPECT_NEAR(std::pow(r.first, 1 + power) + std::pow(r.second, 1 + power), 1, 1e-13);
      }
    }
  // On an edge the point stands still and the normal turns.
  const Ratios edge = ratios(-7e14, 1e-15);
  EXPECT_EQ(edge.first, 0);
  EXPECT_NEAR(edge.dual_first, std::exp(-0.7), 1e-14);
}

TEST(OctantChart, PointsAndNormalsAreThoseOfTheGauge) {
  testing::Random random(1);
  for (const Superquadric& body : testing::bodies()) {
    const OctantChart chart(body);
    const Superquadric scaled{chart.a, body.e1, body.e2};
    for (int k = 0; k < 50; ++k) {
      const Vector3d x = random.positive_vector();
      const ChartPoint at = chart.on_ray(x);
      EXPECT_LT((at.x - x / gauge(scaled, x)).norm(), 1e-14);
      EXPECT_LT((at.normal - outward_normal(scaled, x)).norm(), 1e-12);
      EXPECT_NEAR(at.slope, gauge_derivatives(scaled, x).gradient.norm(), 1e-12 * at.slope);
    }
  }
}

TEST(OctantChart, TangentsAreTheLimitsOfDifferences) {
  testing::Random random(2);
  const double h = 1e-5;  // third derivatives by the logarithms are up to 20^2: h^2 400 = 4e-8
  for (const Superquadric& body : testing::bodies()) {
    const OctantChart chart(body);
    for (int k = 0; k < 20; ++k) {
      const double sigma = random.number(-2, 2), tau = random.number(-2, 2);
      const ChartPoint at = chart.at(sigma, tau);
      for (const bool along : {false, true}) {
        const ChartPoint after = along ? chart.at(sigma, tau + h) : chart.at(sigma + h, tau);
        const ChartPoint before = along ? chart.at(sigma, tau - h) : chart.at(sigma - h, tau);
        const ChartTangent t = along ? chart.by_tau(at) : chart.by_sigma(at);
        EXPECT_LT(((after.x - before.x) / (2 * h) - t.point_weight * t.point).norm(), 1e-7);
        const Vector3d turned = (after.slope * after.normal - before.slope * before.normal) / (2 * h);
        EXPECT_LT((turned - t.gradient_weight * t.gradient).norm(), 1e-7 * at.slope);
        EXPECT_NEAR(t.point.dot(at.normal), 0, 1e-14);
        EXPECT_NEAR(t.point_part * t.gradient_weight, t.gradient_part * t.point_weight, 1e-14);
        EXPECT_NEAR(t.point_part + t.gradient_part, 1, 1e-15);
      }
    }
  }
}

TEST(OctantChart, PartsAreKnownWhereWeightsUnderflow) {
  for (const Superquadric& body : testing::bodies()) {
    const OctantChart chart(body);
    for (const double sigma : {-1e17, -1e4, 0.0, 1e5})
      for (const double tau : {-1e16, -3e3, 0.0, 2e4}) {
        const ChartPoint at = chart.at(sigma, tau);
        EXPECT_TRUE(at.x.allFinite());
        EXPECT_NEAR(at.normal.norm(), 1, 1e-15);
        for (const ChartTangent& t : {chart.by_sigma(at), chart.by_tau(at)}) {
          EXPECT_NEAR(t.point_part + t.gradient_part, 1, 1e-15);
          EXPECT_TRUE(t.point.allFinite() && t.gradient.allFinite());
        }
      }
  }
}

TEST(LogRoot, SolvesItsEquation) {
  testing::Random random(3);
  for (int k = 0; k < 1000; ++k) {
    const double power = std::exp(random.number(-34, 3));
    const double a = random.number(-50, 50), b = random.number(-50, 50), total = random.number(-50, 50);
    const double l = log_root(a, b, power, total), first = a + l - total, second = b + power * l - total;
    EXPECT_NEAR(std::exp(first) + std::exp(second), 1, 2e-14 * std::max(1.0, std::abs(l)) * std::max(1.0, power));
  }
}

// x = y + mu grad N(y) with mu > 0 is what makes y the nearest point.
TEST(Projection, SatisfiesItsEquation) {
  testing::Random random(4);
  for (const Superquadric& body : testing::bodies()) {
    const OctantChart chart(body);
    const Superquadric scaled{chart.a, body.e1, body.e2};
    for (int k = 0; k < 3; ++k) {
      Vector3d x = random.positive_vector();
      x *= random.number(1.01, 4) / gauge(scaled, x);
      const ChartPoint y = projection(chart, x);
      const Vector3d r = x - y.x;
      EXPECT_GT(r.dot(y.normal), 0);
      EXPECT_LT(r.cross(y.normal).norm(), 1e-12 * (1 + x.norm())) << body.e1 << " " << body.e2 << " " << x.transpose();
    }
  }
}

}  // namespace
}  // namespace mb
