#include "mechanics/contact/first_touch_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/surface_patches.h"

namespace mb {
namespace {

const std::vector<Shape> shapes = {Box{{0.3, 0.2, 0.7}},
                                   Cylinder{0.05, 0.2},
                                   Sphere{0.07},
                                   Superquadric{{0.3, 0.1, 0.2}, 1, 1},
                                   Superquadric{{0.3, 0.1, 0.2}, 0.4, 1.5},
                                   Superquadric{{0.1, 0.1, 0.3}, 0.1, 0.1},
                                   Superquadric{{0.2, 0.1, 0.1}, 2, 2},
                                   Superquadric{{0.2, 0.1, 0.1}, 1, 1.999}};

struct Directions {
  std::mt19937 random{1};
  std::normal_distribution<double> normal;
  Vector3d operator()() {
    return Vector3d::NullaryExpr([&] { return normal(random); });
  }
};

double level(const Shape& shape, const Vector3d& X) {
  if (const auto* body = std::get_if<Superquadric>(&shape)) return gauge(*body, X) - 1;
  if (const auto* box = std::get_if<Box>(&shape)) return (2 * X.cwiseQuotient(box->size)).cwiseAbs().maxCoeff() - 1;
  if (const auto* c = std::get_if<Cylinder>(&shape))
    return std::max(X.head<2>().norm() / c->radius, 2 * std::abs(X[2]) / c->length) - 1;
  return X.norm() / std::get<Sphere>(shape).radius - 1;
}

TEST(FirstTouchSupport, LiesOnTheSurfaceAndNothingLiesFarther) {
  Directions direction;
  for (const Shape& shape : shapes) {
    std::vector<Vector3d> samples;
    for (const SurfacePatch& patch : surface_patches(shape))
      for (int i = 0; i <= 12; ++i)
        for (int j = 0; j <= 12; ++j) samples.push_back(patch.at(i / 12.0, j / 12.0).x);
    for (int trial = 0; trial < 60; ++trial) {
      const Vector3d w = direction(), X = support_point(shape, w);
      EXPECT_NEAR(level(shape, X), 0, 1e-14);  // powers lose a few digits
      double farthest = -1;
      for (const Vector3d& Y : samples) farthest = std::max(farthest, w.dot(Y));
      EXPECT_LE(farthest, w.dot(X) * (1 + 1e-14));
      EXPECT_LE(X.norm(), circumradius(shape) * (1 + 1e-15));
    }
  }
}

// h(grad N) = 1: gauge and support are polar to each other (Rockafellar 1970, sect. 15); exact but for rounding.
TEST(FirstTouchSupportVerification, IsPolarToTheGauge) {
  Directions direction;
  for (const Shape& shape : shapes)
    if (const auto* body = std::get_if<Superquadric>(&shape))
      for (int trial = 0; trial < 200; ++trial) {
        const Vector3d n = gauge_derivatives(*body, direction()).gradient;
        EXPECT_NEAR(n.dot(support_point(shape, n)), 1, 1e-14);
      }
}

TEST(FirstTouchSupport, IsFiniteInEveryDirection) {
  for (const Shape& shape : shapes)
    for (const double x : {0.0, -0.0, 1e-300, 1.0, -1e300})
      for (const double y : {0.0, 1e-300, -1.0})
        for (const double z : {0.0, -1e-200, 1.0}) {
          const Vector3d X = support_point(shape, {x, y, z});
          ASSERT_TRUE(X.allFinite()) << x << ' ' << y << ' ' << z;
          EXPECT_NEAR(level(shape, X), 0, 1e-14);
        }
}

// Rounded ones, too: the plane through the support point bears on the obstacle, gap >= n . (x - p), and reaches it.
TEST(FirstTouchSupport, PlanesBearOnObstacles) {
  Directions direction;
  const Pose pose{{0.1, -0.2, 0.3}, Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized()};
  for (const RigidSurface& obstacle :
       {RigidSurface{Shape(Box{{0.3, 0.2, 0.7}}), 0.03, pose}, RigidSurface{Shape(Cylinder{0.1, 0.3}), 0.02, pose},
        RigidSurface{Shape(Cylinder{0.1, 0.3}), 0, pose}, RigidSurface{Shape(Sphere{0.2}), 0, pose}})
    for (int trial = 0; trial < 100; ++trial) {
      const Vector3d n = direction().normalized(), p = *support_point(obstacle, n);
      EXPECT_NEAR(gap_value(obstacle, p), 0, 1e-15);
      const Vector3d x = pose.position + direction();
      EXPECT_GE(gap_value(obstacle, x), n.dot(x - p) - 1e-15);
    }
  EXPECT_FALSE(support_point(RigidSurface{HalfSpace{}, 0, {}}, Vector3d::UnitZ()));
}

}  // namespace
}  // namespace mb
