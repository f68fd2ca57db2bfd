#include "mechanics/geometry/tapered.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/geometry/superquadric_test_bodies.h"
#include "mechanics/geometry/tapered_distance.h"
#include "mechanics/rigid/inertia.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using testing::Random;

const std::vector<TaperedSuperquadric> pears = {
    {{{0.1, 0.08, 0.12}, 1, 1}, 0.5},     {{{0.1, 0.1, 0.1}, 1, 1}, -largest_taper(1)},
    {{{0.1, 0.07, 0.15}, 0.6, 0.8}, 0.7}, {{{0.3, 0.1, 0.2}, 1.3, 0.5}, -0.4},
    {{{0.05, 0.1, 0.1}, 0.4, 1.4}, 0.3},  {{{0.1, 0.1, 0.3}, 0.1, 1}, 0.9},
    {{{0.1, 0.08, 0.12}, 1.4, 1.4}, 0.2}};

double level(const TaperedSuperquadric& body, const Vector3d& x) {
  return gauge(body.straight, Taper(body).inverse(x)) - 1;
}

Matrix3Xd surface_points(const TaperedSuperquadric& body, double size) {
  return graded_rule(body, {}, {size, size, 0, 2}).points;
}

// The body's profile f at Z/a3 [-].
double radius(const TaperedSuperquadric& body, double z) {
  const double q = 2 / body.straight.e1;
  return (1 + body.taper * z) * std::pow(1 - std::pow(std::abs(z), q), 1 / q);
}

// f is concave up to the largest taper, and no longer a hundredth beyond it.
TEST(Tapered, IsConvexUpToTheLargestTaper) {
  for (const double e1 : {0.1, 0.4, 1.0, 1.4, 1.9}) {
    const auto most_bend = [&](double taper) {
      const TaperedSuperquadric body{{{1, 1, 1}, e1, 1}, taper};
      double most = -1e9;
      const double h = 1e-3;
      for (double z = -0.99; z < 0.99; z += 1e-3)
        if (std::abs(z) > 2 * h)  // curvature may be infinite at the middle
          most = std::max(most, (radius(body, z - h) - 2 * radius(body, z) + radius(body, z + h)) / (h * h));
      return most;
    };
    EXPECT_LE(most_bend(largest_taper(e1)), 1e-6) << e1;  // rounding by h^2
    EXPECT_GT(most_bend(1.01 * largest_taper(e1) + 1e-3), 1e-5) << e1;
  }
  EXPECT_NEAR(largest_taper(1), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(largest_taper(2), 0);
}

TEST(Tapered, WhatIsNotConvexIsRefused) {
  const Superquadric straight{{0.1, 0.1, 0.1}, 1, 1};
  EXPECT_NO_THROW(require_valid(TaperedSuperquadric{straight, -largest_taper(1)}));
  for (const double taper : {0.71, -0.71, 1e9, std::nan("")}) {
    const TaperedSuperquadric body{straight, taper};
    EXPECT_THROW(require_valid(body), std::invalid_argument) << taper;
    EXPECT_THROW(volume(body), std::invalid_argument) << taper;
    EXPECT_THROW(signed_distance(body, {1, 0, 0}), std::invalid_argument) << taper;
    EXPECT_THROW(support_point(body, {1, 0, 0}), std::invalid_argument) << taper;
    EXPECT_THROW(graded_rule(body, {}, {0.1, 0.1, 0, 1}), std::invalid_argument) << taper;
  }
  EXPECT_THROW(volume(TaperedSuperquadric{{{0.1, 0.1, 0}, 1, 1}, 0.1}), std::invalid_argument);
  EXPECT_THROW(moment(TaperedSuperquadric{straight, 0.1}, -1, 0, 0), std::invalid_argument);
}

TEST(Tapered, WithoutTaperIsTheStraightBody) {
  const Superquadric straight{{0.3, 0.1, 0.2}, 0.6, 1.2};
  const TaperedSuperquadric body{straight, 0};
  Random random(2);
  EXPECT_EQ(volume(body), volume(straight));
  EXPECT_NEAR(extent(body), extent(straight), 1e-15);
  for (int i = 0; i < 50; ++i) {
    const Vector3d x = 0.5 * random.vector();
    EXPECT_NEAR((support_point(body, x) - support_point(straight, x)).norm(), 0, 1e-13);
    const Distance d = signed_distance(body, x), e = signed_distance(straight, x);
    EXPECT_NEAR(d.value, e.value, 1e-14);
    EXPECT_NEAR((d.gradient - e.gradient).norm(), 0, 1e-7);
  }
}

void expect_moments_verified(double worst) {
  testing::expect_verified(
      {.quantity =
           "volume and moments along and across the axis of 7 pears, relative; odd ones over the second and the size",
       .reference = "second route",
       .source = "Gauss's rule along the axis, 40 pieces of 60 points, over sections with the straight body's moments",
       .uncertainty = "below 1e-9, the rule's error at the widest section and the poles",
       .tolerance = 1e-9,
       .why = "What the rule leaves where slopes or curvatures are infinite; closed forms are good to rounding."},
      worst);
}

// Moments by Gauss's rule along z, where sections are c f times a superellipse: volume, centroid, second and third.
TEST(TaperedVerification, MomentsAreThoseOfItsSections) {
  const Rule rule = gauss_legendre(60);
  double worst = 0;
  for (const TaperedSuperquadric& body : pears) {
    const Superquadric& s = body.straight;
    const Taper taper(body);
    // Of the unit superellipse: area and mean square of x, from the straight body's moments.
    const Superquadric plate{{1, 1, 1}, 0.1, s.e2};
    const auto column = [&](double power) {  // int f^power over Z/a3 of that plate
      const double q = 20;
      return 2 / q * std::tgamma(1 / q) * std::tgamma(1 + power / q) / std::tgamma(1 + (1 + power) / q);
    };
    const double area = moment(plate, 0, 0, 0) / column(2), square = moment(plate, 2, 0, 0) / column(4);
    double V = 0, z1 = 0, z2 = 0, xx = 0, z3 = 0;
    // Z = sin^3-like ends take the root out of f: Z = a3 g(t), g = (3 t - t^3)/2 twice over.
    for (Index i = 0; i < rule.x.size(); ++i)
      for (int piece = 0; piece < 40; ++piece) {
        const double t = -1 + (piece + rule.x[i]) / 20, w = rule.w[i] / 20;
        const auto g = [](double u) { return (3 * u - u * u * u) / 2; };
        const auto slope = [](double u) { return 1.5 * (1 - u * u); };
        const double z = g(g(g(t))), dz = slope(g(g(t))) * slope(g(t)) * slope(t) * w * s.semi_axes[2];
        const double f = std::isfinite(radius(body, z)) ? radius(body, z) : 0, Z = s.semi_axes[2] * z - taper.shift();
        const double dV = area * s.semi_axes[0] * s.semi_axes[1] * f * f * dz;
        V += dV, z1 += Z * dV, z2 += Z * Z * dV, z3 += Z * Z * Z * dV;
        xx += square * std::pow(s.semi_axes[0], 3) * s.semi_axes[1] * std::pow(f, 4) * dz;
      }
    const double a = extent(body);
    for (const double error : {moment(body, 0, 0, 0) / V - 1, z1 / (V * a), moment(body, 0, 0, 2) / z2 - 1,
                               (moment(body, 0, 0, 3) - z3) / (z2 * a), moment(body, 2, 0, 0) / xx - 1}) {
      EXPECT_NEAR(error, 0, 1e-9);  // of the rule at the widest section and the poles
      worst = std::max(std::abs(error), worst);
    }
    EXPECT_NEAR(moment(body, 0, 0, 1), 0, 1e-15 * V * a);
    EXPECT_GT(std::abs(z3), 1e-3 * z2 * a);
  }
  expect_moments_verified(worst);
}

TEST(Tapered, QuadraturesHaveItsMoments) {
  for (const TaperedSuperquadric& body : pears) {
    const Quadrature inside = volume_quadrature(body), on = surface_quadrature(body);
    EXPECT_GT(inside.weights.minCoeff(), 0);
    EXPECT_GT(on.weights.minCoeff(), 0);
    const double V = volume(body), a = extent(body);
    EXPECT_NEAR(inside.weights.sum(), V, 1e-13 * V);
    EXPECT_NEAR((inside.points * inside.weights).norm(), 0, 1e-12 * V * a);  // fitted: rounding of the fit
    for (const auto& [i, j, k] :
         {std::array{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, 3}, {2, 0, 1}, {2, 2, 1}, {0, 0, 5}}) {
      if (i + j + k > 3 && &body != &pears[0]) continue;  // large tapers are fitted to degree 3
      const double found = (inside.points.row(0).array().pow(i) * inside.points.row(1).array().pow(j) *
                            inside.points.row(2).array().pow(k))
                               .matrix()
                               .dot(inside.weights);
      EXPECT_NEAR(found, moment(body, i, j, k), 1e-11 * V * std::pow(a, i + j + k)) << i << j << k;
    }
    for (Index i = 0; i < inside.points.cols(); ++i) EXPECT_LT(level(body, inside.points.col(i)), 0);
    for (Index i = 0; i < on.points.cols(); ++i) EXPECT_NEAR(level(body, on.points.col(i)), 0, 1e-13);
    const GradedRule fine = graded_rule(body, {}, {a / 20, a / 20, 0, 3});
    EXPECT_NEAR(on.weights.sum(), fine.weights.sum(), 1e-3 * fine.weights.sum());  // of order 2/e where e > 1
    EXPECT_NEAR(fine.points.cwiseProduct(fine.normals).colwise().sum().dot(fine.weights) / 3, V, 1e-3 * V);
    EXPECT_LT((fine.normals * fine.weights).norm(), 1e-3 * fine.weights.sum());
  }
}

TEST(Tapered, MassPropertiesAreThoseOfItsMoments) {
  for (const TaperedSuperquadric& body : pears) {
    const MassProperties of = mass_properties(body, 1000);
    EXPECT_NEAR(of.mass, 1000 * volume(body), 1e-12 * of.mass);
    EXPECT_EQ(of.centroid, Vector3d::Zero());
    EXPECT_NEAR(of.inertia(0, 0), 1000 * (moment(body, 0, 2, 0) + moment(body, 0, 0, 2)), 1e-12 * of.inertia(0, 0));
    EXPECT_NEAR(of.inertia(2, 2), 1000 * (moment(body, 0, 2, 0) + moment(body, 2, 0, 0)), 1e-12 * of.inertia(2, 2));
  }
}

TEST(Tapered, SupportPointsLieFarthestAndOnTheSurface) {
  Random random(3);
  for (const TaperedSuperquadric& body : pears) {
    const Matrix3Xd on = surface_points(body, extent(body) / 15);
    for (int trial = 0; trial < 100; ++trial) {
      const Vector3d w = random.vector(), x = support_point(body, w);
      EXPECT_NEAR(level(body, x), 0, 1e-13);  // powers lose a few digits
      EXPECT_LE((w.transpose() * on).maxCoeff(), w.dot(x) + 1e-14);
      EXPECT_LE(x.norm(), circumradius(body) * (1 + 1e-15));
      EXPECT_TRUE(bounds(body).contains(x * (1 - 1e-14)));
    }
    for (const double x : {0.0, -0.0, 1e-300, 1.0, -1e300})
      for (const double y : {0.0, 1e-300, -1.0})
        for (const double z : {0.0, -1e-200, 1.0}) {
          const Vector3d X = support_point(body, {x, y, z});
          ASSERT_TRUE(X.allFinite()) << x << ' ' << y << ' ' << z;
          EXPECT_NEAR(level(body, X), 0, 1e-13);
        }
    EXPECT_NEAR(extent(body), bounds(body).sizes().maxCoeff(), 1e-15);
  }
}

// Of the signed distance of a convex body: gradients of unit length, the foot on the surface, d above every plane that
// bears on it and reached by that of the foot, and nothing nearer among samples.
TEST(TaperedDistance, IsToTheNearestPoint) {
  Random random(4);
  for (const TaperedSuperquadric& body : pears) {
    const double a = extent(body);
    const Matrix3Xd on = surface_points(body, a / 20);
    for (int trial = 0; trial < 60; ++trial) {
      const Vector3d x = (trial % 2 ? 1.0 : 0.4) * bounds(body).max().cwiseProduct(1.5 * random.vector());
      const Distance d = signed_distance(body, x);
      const Vector3d foot = x - d.value * d.gradient;
      EXPECT_NEAR(d.gradient.norm(), 1, 1e-9);
      EXPECT_NEAR(level(body, foot), 0, 1e-7) << trial;
      EXPECT_EQ(d.value > 0, level(body, x) > 0);
      EXPECT_EQ(contains(body, x, 0), d.value <= 0);
      EXPECT_LE(std::abs(d.value), std::sqrt((on.colwise() - x).colwise().squaredNorm().minCoeff()) + 1e-12 * a);
      EXPECT_NEAR(d.value, d.gradient.dot(x - support_point(body, d.gradient)), 1e-9 * a);
    }
  }
}

// Gradient and Hessian are derivatives: differences over h, whose error is of order h^2 where the body is smooth.
TEST(TaperedDistance, HasItsDerivatives) {
  Random random(5);
  for (const TaperedSuperquadric& body : {pears[0], pears[1]}) {
    const double a = extent(body), h = 1e-4 * a;
    for (int trial = 0; trial < 40; ++trial) {
      const Vector3d x = support_point(body, random.vector()) * (trial % 2 ? 1.3 : 0.9);
      const Distance d = signed_distance(body, x);
      EXPECT_LT((d.hessian * d.gradient).norm(), 1e-7 / a);
      for (int i = 0; i < 3; ++i) {
        const Vector3d e = h * Vector3d::Unit(i);
        const Distance up = signed_distance(body, x + e), down = signed_distance(body, x - e);
        EXPECT_NEAR((up.value - down.value) / (2 * h), d.gradient[i], 1e-5);
        EXPECT_LT(((up.gradient - down.gradient) / (2 * h) - d.hessian.col(i)).norm(),
                  1e-3 * (1 / a + d.hessian.norm()));
      }
    }
  }
}

// At points of the surface, from either side of rounding.
TEST(TaperedDistance, IsZeroOnTheSurface) {
  for (const TaperedSuperquadric& body : pears) {
    const Matrix3Xd on = surface_points(body, extent(body) / 4);
    for (Index i = 0; i < on.cols(); i += 7)
      EXPECT_NEAR(signed_distance_value(body, on.col(i)), 0, 1e-14 * extent(body)) << i;
  }
  EXPECT_TRUE(std::isnan(signed_distance_value(pears[0], Vector3d::Constant(std::nan("")))));
}

}  // namespace
}  // namespace mb
