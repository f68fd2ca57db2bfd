#include "mechanics/geometry/superquadric.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "mechanics/geometry/superquadric_test_bodies.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using testing::bodies;
using testing::Random;

TEST(Gauge, IsBarrsFormula) {
  const Superquadric body{{0.3, 0.2, 0.5}, 0.6, 1.3};
  const Vector3d x(-0.1, 0.15, 0.2);
  const double across = std::pow(0.1 / 0.3, 2 / 1.3) + std::pow(0.15 / 0.2, 2 / 1.3);
  const double D = std::pow(std::pow(across, 1.3 / 0.6) + std::pow(0.2 / 0.5, 2 / 0.6), 0.6);
  EXPECT_NEAR(inside_outside(body, x), D, 1e-14);  // a few roundings of terms of order 1
  EXPECT_NEAR(gauge(body, x), std::sqrt(D), 1e-14);
}

// Norms have convex unit balls: all these bodies are convex.
TEST(Gauge, IsANormForAllExponents) {
  Random random(1);
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 200; ++k) {
      const Vector3d x = random.vector(), y = random.vector();
      const double c = random.number(-5, 5), N = gauge(body, x);
      EXPECT_NEAR(gauge(body, c * x), std::abs(c) * N, 1e-14 * std::abs(c) * N);
      EXPECT_LE(gauge(body, x + y), (N + gauge(body, y)) * (1 + 1e-14));
      EXPECT_GT(N, 0);
    }
}

TEST(Gauge, NeitherOverflowsNorUnderflows) {
  for (const Superquadric& body : bodies()) {
    const Vector3d x(0.4, -0.7, 1.1);
    for (const double size : {1e-300, 1e-150, 1e150, 1e300}) {
      const double N = gauge(body, x);
      EXPECT_NEAR(gauge(body, size * x) / size, N, 1e-13 * N);
      EXPECT_LT((outward_normal(body, size * x) - outward_normal(body, x)).norm(), 1e-13);
    }
  }
  EXPECT_EQ(inside_outside(Superquadric{{1, 1, 1}, 1, 1}, {1e200, 0, 0}), std::numeric_limits<double>::infinity());
}

TEST(GaugeDerivatives, SatisfyEulersRelations) {
  Random random(2);
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 50; ++k) {
      const Vector3d x = random.vector();
      const GaugeDerivatives N = gauge_derivatives(body, x);
      EXPECT_DOUBLE_EQ(N.value, gauge(body, x));
      EXPECT_NEAR(N.gradient.dot(x), N.value, 1e-13 * N.value);
      EXPECT_LE((N.hessian * x).norm(), 1e-12 * N.hessian.norm() * x.norm());
      EXPECT_EQ(N.hessian, N.hessian.transpose());
      const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(N.hessian).eigenvalues()[0];
      EXPECT_GE(least, -1e-12 * N.hessian.norm());
    }
}

// Where no coordinate is small, derivatives of N vary over lengths of e^2/4 |x| or more.
TEST(GaugeDerivatives, AreTheLimitsOfDifferences) {
  Random random(3);
  const double h = 1e-6;
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 20; ++k) {
      const Vector3d x = (random.positive_vector() + Vector3d::Constant(0.2)).cwiseProduct(body.semi_axes);
      const GaugeDerivatives N = gauge_derivatives(body, x);
      for (int i = 0; i < 3; ++i) {
        const Vector3d step = h * body.semi_axes[i] * Vector3d::Unit(i);
        const GaugeDerivatives after = gauge_derivatives(body, x + step), before = gauge_derivatives(body, x - step);
        const double length = 2 * step[i];
        // error: h^2 third derivative of up to 20^2, rounding eps/h
        EXPECT_NEAR((after.value - before.value) / length, N.gradient[i], 2e-9 / body.semi_axes[i]);
        EXPECT_LT(((after.gradient - before.gradient) / length - N.hessian.col(i)).cwiseProduct(body.semi_axes).norm(),
                  2e-7 / body.semi_axes[i]);
      }
    }
}

TEST(GaugeDerivatives, OfAnEllipsoidAreThoseOfANorm) {
  Random random(4);
  const Superquadric body{{0.3, 0.2, 0.5}, 1, 1};
  const Eigen::Matrix3d Q = body.semi_axes.cwiseAbs2().cwiseInverse().asDiagonal();
  for (Vector3d x : {random.vector(), random.vector(), Vector3d(0, 0, 0.2), Vector3d(0.1, 0, 0), Vector3d(0, -1, 2)}) {
    const double N = std::sqrt(x.dot(Q * x));
    const GaugeDerivatives computed = gauge_derivatives(body, x);
    EXPECT_NEAR(computed.value, N, 1e-14 * N);
    EXPECT_LT((computed.gradient - Q * x / N).norm(), 1e-13);
    EXPECT_LT((computed.hessian - (Q - Q * x * x.transpose() * Q / (N * N)) / N).norm(), 1e-12 / N);
  }
}

TEST(Superquadric, FiniteInputMakesNoNaN) {
  for (const Superquadric& body : bodies())
    for (const Vector3d& x : testing::awkward_points()) {
      EXPECT_TRUE(std::isfinite(gauge(body, x)));
      EXPECT_NEAR(outward_normal(body, x).norm(), 1, 1e-14);
      const GaugeDerivatives N = gauge_derivatives(body, x);
      EXPECT_TRUE(N.gradient.allFinite() && !N.hessian.hasNaN()) << x.transpose();
      const PrincipalCurvatures k = principal_curvatures(body, x);
      EXPECT_TRUE(!k.values.hasNaN() && k.directions.allFinite()) << x.transpose();
      EXPECT_GE(k.values[0], 0);
      EXPECT_LE(k.values[0], k.values[1]);
    }
}

TEST(Superquadric, CentreEdgesAndPoles) {
  const Superquadric octahedron{{1, 1, 1}, 2, 2}, cushion{{1, 1, 1}, 0.5, 0.5};
  EXPECT_EQ(outward_normal(octahedron, Vector3d::Zero()), Vector3d::UnitZ());
  EXPECT_EQ(gauge_derivatives(octahedron, Vector3d::Zero()).gradient, Vector3d::Zero());
  // On an edge the mean of both faces' normals.
  EXPECT_LT((outward_normal(octahedron, {0, 0.4, 0.6}) - Vector3d(0, 1, 1) / std::sqrt(2)).norm(), 1e-15);
  EXPECT_EQ(outward_normal(octahedron, {0, 0, -1}), Vector3d(0, 0, -1));
  // e < 1 is flat on the axes: D = x^4 + ..., curvature 3 x^2.
  EXPECT_EQ(principal_curvatures(cushion, {0, 0, 1}).values, Eigen::Vector2d::Zero());
  EXPECT_EQ(principal_curvatures(cushion, {1, 0, 0}).values, Eigen::Vector2d::Zero());
}

TEST(PrincipalCurvaturesVerification, OfAnEllipsoid) {
  Random random(5);
  double worst = 0;
  const double a = 0.3, b = 0.2, c = 0.5;
  const Superquadric body{{a, b, c}, 1, 1};
  const auto at_pole = principal_curvatures(body, {a, 0, 0});
  EXPECT_NEAR(at_pole.values[0], a / (c * c), 1e-14);
  EXPECT_NEAR(at_pole.values[1], a / (b * b), 1e-14);
  EXPECT_NEAR(std::abs(at_pole.directions(1, 1)), 1, 1e-14);
  for (int k = 0; k < 50; ++k) {
    Vector3d x = random.vector();
    x /= gauge(body, x);
    const auto principal = principal_curvatures(body, x);
    // Gaussian and mean curvature (do Carmo 1976, Differential Geometry of Curves and Surfaces, sect. 3.3).
    const double s = x.cwiseQuotient(body.semi_axes.cwiseAbs2()).squaredNorm();
    const double K = 1 / (a * a * b * b * c * c * s * s);
    const double H = (a * a + b * b + c * c - x.squaredNorm()) / (2 * a * a * b * b * c * c * std::pow(s, 1.5));
    EXPECT_NEAR(principal.values.prod(), K, 1e-12 * K);
    EXPECT_NEAR(0.5 * principal.values.sum(), H, 1e-12 * H);
    worst =
        std::max({std::abs(principal.values.prod() / K - 1), std::abs(0.5 * principal.values.sum() / H - 1), worst});
    Eigen::Matrix3d frame;
    frame << principal.directions, outward_normal(body, x);
    EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
  testing::expect_verified(
      {.quantity = "Gaussian and mean curvature at 50 points of an ellipsoid, relative",
       .reference = "exact solution",
       .source = "do Carmo 1976, Differential Geometry of Curves and Surfaces, sect. 3.3",
       .uncertainty = "rounding",
       .tolerance = 1e-12,
       .why = "Rounding, some 1e-15, of which the smaller curvature loses a digit to the larger; the rest is margin."},
      worst);
}

TEST(Superquadric, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3d x(1, 1, 1), one(1, 1, 1);
  for (const Superquadric& body :
       {Superquadric{one, 0.09, 1}, Superquadric{one, 1, 2.1}, Superquadric{one, nan, 1}, Superquadric{{1, 0, 1}, 1, 1},
        Superquadric{{1, -1, 1}, 1, 1}, Superquadric{{1, nan, 1}, 1, 1}, Superquadric{{1, 1, 1e200}, 1, 1}}) {
    EXPECT_THROW(gauge(body, x), std::invalid_argument);
    EXPECT_THROW(gauge_derivatives(body, x), std::invalid_argument);
    EXPECT_THROW(principal_curvatures(body, x), std::invalid_argument);
    EXPECT_THROW(outward_normal(body, x), std::invalid_argument);
    EXPECT_THROW(moment(body, 0, 0, 0), std::invalid_argument);
    EXPECT_THROW(surface_moments(body), std::invalid_argument);
  }
  const Superquadric good{one, 1, 1};
  EXPECT_THROW(moment(good, -1, 0, 0), std::invalid_argument);
  EXPECT_THROW(moment(good, 0, 42, 0), std::invalid_argument);
  for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(gauge(good, {bad, 0, 0})));
    EXPECT_TRUE(gauge_derivatives(good, {0, bad, 0}).hessian.array().isNaN().all());
    EXPECT_TRUE(principal_curvatures(good, {0, 0, bad}).values.array().isNaN().all());
  }
}

}  // namespace
}  // namespace mb
