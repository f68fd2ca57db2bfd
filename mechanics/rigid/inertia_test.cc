#include "mechanics/rigid/inertia.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/superquadric.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
const std::vector<Shape> shapes = {Box{{0.3, 0.2, 0.7}}, Cylinder{0.05, 0.2}, Sphere{0.07},
                                   TaperedSuperquadric{{{0.1, 0.08, 0.12}, 1, 1}, 0.4}};

TEST(MassProperties, AreTheTextbooks) {
  const MassProperties box = mass_properties(Box{{0.3, 0.2, 0.7}}, 1000);
  EXPECT_DOUBLE_EQ(box.mass, 42);
  EXPECT_TRUE(box.inertia.diagonal().isApprox(42.0 / 12 * Vector3d(0.53, 0.58, 0.13), 1e-15));
  const double m = 1000 * pi * 0.05 * 0.05 * 0.2, across = m * (3 * 0.05 * 0.05 + 0.2 * 0.2) / 12;
  const MassProperties cylinder = mass_properties(Cylinder{0.05, 0.2}, 1000);
  EXPECT_TRUE(cylinder.inertia.diagonal().isApprox(Vector3d(across, across, m * 0.05 * 0.05 / 2), 1e-15));
  const MassProperties sphere = mass_properties(Sphere{0.07}, 2);
  EXPECT_TRUE(sphere.inertia.isApprox(0.4 * sphere.mass * 0.07 * 0.07 * Matrix3d::Identity(), 1e-15));
  EXPECT_EQ(box.centroid, Vector3d(Vector3d::Zero()));
}

TEST(MassPropertiesVerification, AgreeWithQuadrature) {
  for (const Shape& shape : shapes) {
    const Quadrature q = volume_quadrature(shape);
    Matrix3d inertia = Matrix3d::Zero();
    for (Index i = 0; i < q.weights.size(); ++i) {
      const Vector3d x = q.points.col(i);
      inertia += 7800 * q.weights[i] * (x.squaredNorm() * Matrix3d::Identity() - x * x.transpose());
    }
    // Exact for quadratics in boxes and cylinders; the radial rule of balls leaves 1e-3 (shape_test.cc).
    const double tolerance = std::holds_alternative<Sphere>(shape) ? 1e-3 : 1e-13;
    EXPECT_LE((inertia - mass_properties(shape, 7800).inertia).norm(), tolerance * inertia.norm());
  }
}

// Cones from the centre to the three faces of an octant's box, of volume a1 a2 a3 dt dr / (3 N^3), in which the mean of
// x^2 is 3/5 of the base's. t = s^4 takes the edge out of N at t = 0; 40 points leave below 1e-12.
TEST(MassPropertiesVerification, OfSuperquadricsAgreeWithCones) {
  const Rule gauss = gauss_legendre(40);
  double worst = 0;
  for (const Superquadric& body : {Superquadric{{0.2, 0.3, 0.25}, 0.6, 1.2}, Superquadric{{0.5, 0.1, 0.2}, 1.6, 0.9}}) {
    double volume = 0;
    Vector3d second = Vector3d::Zero();  // int x_i^2
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
          const double s = gauss.x[i], r = gauss.x[j];
          Vector3d u = Vector3d::Ones();
          u[(axis + 1) % 3] = std::pow(s, 4);
          u[(axis + 2) % 3] = std::pow(r, 4);
          const Vector3d y = body.semi_axes.cwiseProduct(u);
          const double N = gauge(body, y), jacobian = 16 * std::pow(s * r, 3);
          const double cone = 8 * body.semi_axes.prod() * gauss.w[i] * gauss.w[j] * jacobian / (3 * N * N * N);
          volume += cone;
          second += 0.6 * cone / (N * N) * y.cwiseAbs2();
        }
    const MassProperties found = mass_properties(body, 3);
    EXPECT_NEAR(found.mass, 3 * volume, 1e-11 * found.mass);
    const Vector3d inertia = 3 * (second.sum() * Vector3d::Ones() - second);
    EXPECT_LE((found.inertia.diagonal() - inertia).norm(), 1e-11 * inertia.norm());
    worst = std::max({std::abs(found.mass - 3 * volume) / found.mass,
                      (found.inertia.diagonal() - inertia).norm() / inertia.norm(), worst});
  }
  testing::expect_verified(
      {.quantity = "mass and moments of inertia of two superquadrics, relative, these in norm",
       .reference = "second route",
       .source = "Cones from the centre to an octant's box, by 40 x 40 Gauss points in fourth roots",
       .uncertainty = "1e-12, what the Gauss points leave",
       .tolerance = 1e-11,
       .why = "Ten times what the quadrature leaves; the closed form by gamma functions is good to rounding."},
      worst);
}

TEST(MassProperties, OfARoundSuperquadricAreTheEllipsoids) {
  const MassProperties body = mass_properties(Superquadric{{0.2, 0.3, 0.5}, 1, 1}, 1);
  EXPECT_NEAR(body.mass, 4.0 / 3 * pi * 0.03, 1e-15);
  EXPECT_TRUE(body.inertia.diagonal().isApprox(body.mass / 5 * Vector3d(0.34, 0.29, 0.13), 1e-13));
}

TEST(PrincipalAxes, DiagonaliseAndStayNextToTheBody) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (const Vector3d& moments : {Vector3d(1, 2, 2.5), Vector3d(1, 1, 1.5), Vector3d(3, 3, 3), Vector3d(1e-6, 1, 1)})
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector4d q(normal(generator), normal(generator), normal(generator), normal(generator));
      const Matrix3d R = Quaterniond(q.normalized()).toRotationMatrix();
      const Matrix3d J = R * moments.asDiagonal() * R.transpose();
      const auto [found, axes] = principal_axes(J);
      const Matrix3d A = axes.toRotationMatrix();
      EXPECT_LE((A * found.asDiagonal() * A.transpose() - J).norm(), 1e-14 * J.norm());
      Vector3d sorted = found;
      std::sort(sorted.begin(), sorted.end());
      EXPECT_LE((sorted - moments).norm(), 1e-14 * J.norm());
      EXPECT_NEAR(axes.norm(), 1, 1e-15);
    }
  Matrix3d slightly = Vector3d(2, 1, 2.5).asDiagonal();
  EXPECT_EQ(principal_axes(slightly).axes.coeffs(), Quaterniond::Identity().coeffs());
  EXPECT_EQ(principal_axes(slightly).moments, Vector3d(2, 1, 2.5));
  slightly(0, 1) = slightly(1, 0) = 1e-5;  // angle 1e-5 / (2 - 1)
  EXPECT_NEAR(principal_axes(slightly).axes.angularDistance(Quaterniond::Identity()), 1e-5, 1e-14);
}

TEST(PrincipalAxes, RefuseWhatIsNoInertia) {
  Matrix3d J = Matrix3d::Identity();
  J(0, 1) = 0.1;
  EXPECT_THROW(principal_axes(J), std::invalid_argument);  // not symmetric
  J(1, 0) = nan;
  EXPECT_THROW(principal_axes(J), std::invalid_argument);
  EXPECT_THROW(principal_axes(inf * Matrix3d::Identity()), std::invalid_argument);
  EXPECT_THROW(principal_axes(Matrix3d::Zero()), std::invalid_argument);
  EXPECT_THROW(principal_axes(Vector3d(1, 1, 2.1).asDiagonal().toDenseMatrix()), std::invalid_argument);
  EXPECT_THROW(principal_axes(Vector3d(1, 1, -1).asDiagonal().toDenseMatrix()), std::invalid_argument);
}

TEST(MassProperties, RefuseWhatIsNoBody) {
  for (const double density : {0.0, -1.0, nan, inf})
    EXPECT_THROW(mass_properties(Sphere{1}, density), std::invalid_argument);
  for (const double size : {0.0, -1.0, nan, inf}) {
    EXPECT_THROW(mass_properties(Sphere{size}, 1), std::invalid_argument);
    EXPECT_THROW(mass_properties(Box{{1, size, size}}, 1), std::invalid_argument);
    EXPECT_THROW(mass_properties(Cylinder{size, 1}, 1), std::invalid_argument);
    EXPECT_THROW(mass_properties(Cylinder{1e-200, size}, 1), std::invalid_argument);
    EXPECT_THROW(mass_properties(Superquadric{{size, 1, size}, 1, 1}, 1), std::invalid_argument);
  }
  EXPECT_THROW(mass_properties(Box{{-1, -1, 1}}, 1), std::invalid_argument);  // of positive volume
  EXPECT_THROW(mass_properties(Sphere{1e-150}, 1), std::invalid_argument);    // whose mass underflows
}

}  // namespace
}  // namespace mb
