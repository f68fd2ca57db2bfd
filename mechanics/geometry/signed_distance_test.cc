#include "mechanics/geometry/signed_distance.h"

#include <gtest/gtest.h>

#include <limits>

#include "mechanics/geometry/superquadric_test_bodies.h"

namespace mb {
namespace {

using testing::Random;

const std::vector<Shape> shapes = {Box{{1, 0.4, 0.7}}, Cylinder{0.3, 0.8}, Cylinder{0.5, 0.1}, Sphere{0.4},
                                   Superquadric{{0.5, 0.2, 0.35}, 0.6, 1.4}};

// max n . y over the shape.
double support(const Shape& shape, const Vector3d& n) {
  if (const auto* b = std::get_if<Box>(&shape)) return 0.5 * b->size.dot(n.cwiseAbs());
  if (const auto* c = std::get_if<Cylinder>(&shape))
    return c->radius * n.head<2>().norm() + 0.5 * c->length * std::abs(n[2]);
  return std::get<Sphere>(shape).radius;
}

// Of a convex shape the signed distance is the greatest over all half-spaces about it: attained, and not exceeded.
TEST(SignedDistanceVerification, IsTheGreatestDistanceFromSupportingPlanes) {
  Random random(1);
  for (size_t s = 0; s < 4; ++s)
    for (int k = 0; k < 300; ++k) {
      const Vector3d x = 1.2 * random.vector();
      const Distance d = signed_distance(shapes[s], x);
      EXPECT_NEAR(d.value, d.gradient.dot(x) - support(shapes[s], d.gradient), 1e-15);
      EXPECT_NEAR(d.gradient.norm(), 1, 1e-15);
      for (int l = 0; l < 20; ++l) {
        const Vector3d n = random.vector().normalized();
        EXPECT_LE(n.dot(x) - support(shapes[s], n), d.value + 1e-15);
      }
    }
}

TEST(SignedDistanceVerification, ClosedForms) {
  const Shape box = Box{{2, 4, 6}}, can = Cylinder{1, 4}, ball = Sphere{2};
  EXPECT_DOUBLE_EQ(signed_distance_value(box, {4, 0, -1}), 3);
  EXPECT_DOUBLE_EQ(signed_distance_value(box, {4, -6, 1}), 5);
  EXPECT_DOUBLE_EQ(signed_distance_value(box, {3, 5, 9}), 7);
  EXPECT_DOUBLE_EQ(signed_distance_value(box, {0.5, 1.75, -2.9}), -0.10000000000000009);
  EXPECT_DOUBLE_EQ(signed_distance_value(can, {3, 4, 1}), 4);
  EXPECT_DOUBLE_EQ(signed_distance_value(can, {0, 4, -6}), 5);
  EXPECT_DOUBLE_EQ(signed_distance_value(can, {0.3, 0.4, 1.75}), -0.25);
  EXPECT_DOUBLE_EQ(signed_distance_value(ball, {2, -3, 6}), 5);
  // Curvatures: of a parallel cylinder 1 / rho; about an edge 1 / d; about a rim 1 / d and n_rho / rho.
  const Distance side = signed_distance(can, {0, 3, 1}), edge = signed_distance(box, {4, -6, 1});
  EXPECT_LT((side.hessian - Eigen::Matrix3d(Vector3d(1.0 / 3, 0, 0).asDiagonal())).norm(), 1e-16);
  const Vector3d around = Vector3d(4, 3, 0) / 5;
  EXPECT_LT((edge.hessian - around * around.transpose() / 5).norm(), 1e-15);
  const Distance rim = signed_distance(can, {4, 0, 6});
  const Vector3d along = Vector3d(-4, 0, 3) / 5;
  EXPECT_LT((rim.hessian - along * along.transpose() / 5 - 0.6 / 4 * Vector3d::UnitY() * Vector3d::UnitY().transpose())
                .norm(),
            1e-15);
}

TEST(SignedDistance, DerivativesAreTheLimitsOfDifferences) {
  Random random(2);
  const double h = 1e-6;
  for (const Shape& shape : shapes)
    for (int k = 0; k < 200; ++k) {
      const Vector3d x = 1.5 * random.vector();
      const Distance at = signed_distance(shape, x);
      EXPECT_EQ(at.value, signed_distance_value(shape, x));
      EXPECT_LT((at.hessian * at.gradient).norm(), 1e-14 * (1 + at.hessian.norm()));
      EXPECT_LT((at.hessian - at.hessian.transpose()).norm(), 1e-15 * (1 + at.hessian.norm()));
      if (at.value < 0.05) continue;  // inside, gradients jump
      for (int i = 0; i < 3; ++i) {
        const Distance after = signed_distance(shape, x + h * Vector3d::Unit(i));
        const Distance before = signed_distance(shape, x - h * Vector3d::Unit(i));
        EXPECT_NEAR((after.value - before.value) / (2 * h), at.gradient[i], 1e-9);  // h^2 / d^2, eps / h
        const double jump = (after.hessian - before.hessian).norm();                // from a face's region to an edge's
        EXPECT_LT(((after.gradient - before.gradient) / (2 * h) - at.hessian.col(i)).norm(), 1e-7 + jump);
      }
    }
}

TEST(SignedDistance, TiesAreDecidedAlwaysTheSame) {
  const Shape cube = Box{{2, 2, 2}}, can = Cylinder{1, 2}, ball = Sphere{1};
  EXPECT_EQ(signed_distance(cube, {0, 0, 0}).gradient, Vector3d::UnitX());
  EXPECT_EQ(signed_distance(cube, {-0.5, 0.5, -0.5}).gradient, Vector3d(-1, 0, 0));
  EXPECT_EQ(signed_distance(cube, {0, -0.5, 0.5}).gradient, Vector3d(0, -1, 0));
  EXPECT_EQ(signed_distance(cube, {1, 1, 1}).gradient, Vector3d::UnitX());
  EXPECT_EQ(signed_distance(cube, {1, 1, 1}).value, 0);
  EXPECT_EQ(signed_distance(can, {0, 0, 0}).gradient, Vector3d::UnitX());
  EXPECT_EQ(signed_distance(can, {0, -0.5, -0.5}).gradient, Vector3d(0, -1, 0));
  EXPECT_EQ(signed_distance(ball, {0, 0, 0}).gradient, Vector3d::UnitZ());
  EXPECT_EQ(signed_distance(ball, {0, 0, 0}).value, -1);
}

TEST(SignedDistance, FiniteInputMakesFiniteOutput) {
  for (const Shape& shape : shapes) {
    std::vector<Vector3d> points = testing::awkward_points();
    for (const double x : {0.4, 0.5})
      for (const double y : {0.2, 0.3})
        for (const double z : {0.05, 0.35, 0.4})
          for (const double beyond : {0.0, 1e-300, 1e-17, 1e-12}) points.emplace_back(x + beyond, y, -z - beyond);
    for (const Vector3d& x : points) {
      const Distance d = signed_distance(shape, x);
      ASSERT_TRUE(std::isfinite(d.value) && d.hessian.allFinite()) << x.transpose();
      ASSERT_NEAR(d.gradient.norm(), 1, 1e-14) << x.transpose();
      ASSERT_LE(d.hessian.norm(), 2e9 / extent(shape)) << x.transpose();
    }
  }
}

TEST(SignedDistance, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3d x(1, 1, 1);
  for (const Shape& shape : {Shape(Box{{1, 0, 1}}), Shape(Box{{1, nan, 1}}), Shape(Cylinder{-1, 1}),
                             Shape(Cylinder{1, 0}), Shape(Sphere{nan}), Shape(Superquadric{{1, 1, 1}, 1, 3})}) {
    EXPECT_THROW(signed_distance(shape, x), std::invalid_argument);
    EXPECT_THROW(signed_distance_value(shape, x), std::invalid_argument);
  }
  for (const Shape& shape : shapes)
    for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
      EXPECT_TRUE(std::isnan(signed_distance_value(shape, {0, bad, 0})));
      EXPECT_TRUE(signed_distance(shape, {0, 0, bad}).gradient.array().isNaN().all());
    }
}

}  // namespace
}  // namespace mb
