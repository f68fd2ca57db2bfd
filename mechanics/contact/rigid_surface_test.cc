#include "mechanics/contact/rigid_surface.h"

#include <gtest/gtest.h>

#include <limits>

#include "mechanics/geometry/signed_distance.h"
#include "mechanics/geometry/superquadric_test_bodies.h"

namespace mb {
namespace {

using testing::Random;

const Pose tilted{{0.3, -0.2, 0.5}, Eigen::Quaterniond(0.8, 0.2, -0.4, 0.4).normalized()};

std::vector<RigidSurface> surfaces(const Pose& pose) {
  return {{HalfSpace{}, 0, pose},
          {Box{{1, 0.4, 0.7}}, 0, pose},
          {Box{{1, 0.4, 0.7}}, 0.05, pose},
          {Cylinder{0.3, 0.8}, 0, pose},
          {Cylinder{0.3, 0.8}, 0.1, pose},
          {Sphere{0.4}, 0, pose},
          {Superquadric{{0.5, 0.2, 0.35}, 0.6, 1.4}, 0, pose}};
}

TEST(RigidSurface, AHalfSpaceIsItsPlane) {
  const RigidSurface floor{HalfSpace{}, 0, {}};
  EXPECT_EQ(gap_value(floor, {3, -4, 0.25}), 0.25);
  const RigidSurface slope{HalfSpace{}, 0, tilted};
  const Vector3d n = tilted.orientation * Vector3d::UnitZ(), x(1, 2, 3);
  const Gap at = gap(slope, x);
  EXPECT_NEAR(at.value, n.dot(x - tilted.position), 1e-15);
  EXPECT_LT((at.normal - n).norm(), 1e-15);
  EXPECT_EQ(at.hessian, Eigen::Matrix3d::Zero());
}

TEST(RigidSurface, GapsMoveWithThePose) {
  Random random(1);
  const auto standing = surfaces({}), moved = surfaces(tilted);
  for (size_t s = 0; s < standing.size(); ++s)
    for (int k = 0; k < 50; ++k) {
      const Vector3d X = 0.8 * random.vector();
      const Eigen::Matrix3d R = tilted.orientation.toRotationMatrix();
      const Gap there = gap(standing[s], X), here = gap(moved[s], tilted.to_world(X));
      EXPECT_NEAR(here.value, there.value, 1e-15);
      if (there.value < 0) continue;  // in the middle another face may be nearest after rounding
      EXPECT_LT((here.normal - R * there.normal).norm(), 1e-13);
      EXPECT_LT((here.hessian - R * there.hessian * R.transpose()).norm(), 1e-11 * (1 + there.hessian.squaredNorm()));
    }
}

TEST(RigidSurface, DerivativesAreTheLimitsOfDifferences) {
  Random random(2);
  const double h = 1e-6;
  for (const RigidSurface& surface : surfaces(tilted))
    for (int k = 0; k < 100; ++k) {
      const Vector3d x = 1.5 * random.vector();
      const Gap at = gap(surface, x);
      EXPECT_NEAR(at.value, gap_value(surface, x), 1e-15);  // rounding: compilers fuse products and sums as they like
      EXPECT_NEAR(at.normal.norm(), 1, 1e-14);
      EXPECT_LT((at.hessian * at.normal).norm(), 1e-13 * (1 + at.hessian.norm()));
      if (at.value < 0.05) continue;  // inside, normals jump
      for (int i = 0; i < 3; ++i) {
        const Gap after = gap(surface, x + h * Vector3d::Unit(i)), before = gap(surface, x - h * Vector3d::Unit(i));
        EXPECT_NEAR((after.value - before.value) / (2 * h), at.normal[i], 1e-9);
        const double jump = (after.hessian - before.hessian).norm();  // from a face's region to an edge's
        EXPECT_LT(((after.normal - before.normal) / (2 * h) - at.hessian.col(i)).norm(), 1e-7 + jump);
      }
    }
}

// Faces stay where they are, edges and rims move inwards by (sqrt 2 - 1) r along the diagonal, corners by (sqrt 3 - 1)
// r.
TEST(RigidSurfaceVerification, RoundedEdgesRimsAndCorners) {
  const double r = 0.05, root2 = std::sqrt(2), root3 = std::sqrt(3);
  const RigidSurface box{Box{{1, 0.4, 0.6}}, r, {}}, can{Cylinder{0.3, 0.8}, r, {}};
  EXPECT_NEAR(gap_value(box, {0.1, 0.2, -0.1}), 0, 1e-16);
  EXPECT_NEAR(gap_value(box, {0.7, 0.1, -0.1}), 0.2, 1e-15);
  EXPECT_NEAR(gap_value(box, {0.5, 0.2, -0.1}), (root2 - 1) * r, 1e-15);
  EXPECT_NEAR(gap_value(box, {0.5, -0.2, 0.3}), (root3 - 1) * r, 1e-15);
  EXPECT_NEAR(gap_value(box, {0.1, 0.15, 0.1}), -0.05, 1e-15);
  EXPECT_NEAR(gap_value(can, {0.3, 0, 0.1}), 0, 1e-16);
  EXPECT_NEAR(gap_value(can, {0, -0.3, 0.4}), (root2 - 1) * r, 1e-15);
  // On the round surface curvatures are those of a cylinder, a ball and a torus of radius r.
  const Vector3d diagonal = Vector3d(1, 1, 0) / root2;
  const Gap edge = gap(box, Vector3d(0.45, 0.15, 0.1) + r * diagonal);
  EXPECT_NEAR(edge.value, 0, 1e-16);
  EXPECT_LT((edge.normal - diagonal).norm(), 1e-14);
  EXPECT_NEAR(edge.hessian.trace(), 1 / r, 1e-11);
  const Gap corner = gap(box, Vector3d(0.45, 0.15, 0.25) + r / root3 * Vector3d::Ones());
  EXPECT_NEAR(corner.hessian.trace(), 2 / r, 1e-11);
  const Gap rim = gap(can, Vector3d(0.25 + r / root2, 0, 0.35 + r / root2));
  EXPECT_NEAR(rim.hessian.trace(), 1 / r + 1 / root2 / (0.25 + r / root2), 1e-11);
}

TEST(RigidSurface, SmallRoundingIsNone) {
  Random random(3);
  for (const Shape& shape : {Shape(Box{{1, 0.4, 0.7}}), Shape(Cylinder{0.3, 0.8})})
    for (int k = 0; k < 100; ++k) {
      const Vector3d x = random.vector();
      EXPECT_NEAR(gap_value({shape, 1e-9, {}}, x), signed_distance_value(shape, x), 1e-9);
    }
}

TEST(RigidSurface, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3d x(1, 1, 1);
  const Pose stretched{{0, 0, 0}, Eigen::Quaterniond(2, 0, 0, 0)};
  for (const RigidSurface& surface :
       {RigidSurface{HalfSpace{}, 0.1, {}}, RigidSurface{Sphere{1}, 0.1, {}}, RigidSurface{Box{{1, 2, 3}}, 0.5, {}},
        RigidSurface{Cylinder{1, 0.4}, 0.2, {}}, RigidSurface{Superquadric{{1, 1, 1}, 1, 1}, 0.1, {}},
        RigidSurface{Box{{1, 2, 3}}, -0.1, {}}, RigidSurface{Box{{1, 2, 3}}, nan, {}}, RigidSurface{Sphere{-1}, 0, {}},
        RigidSurface{HalfSpace{}, 0, stretched}}) {
    EXPECT_THROW(gap(surface, x), std::invalid_argument);
    EXPECT_THROW(gap_value(surface, x), std::invalid_argument);
  }
  for (const RigidSurface& surface : surfaces(tilted)) EXPECT_TRUE(std::isnan(gap_value(surface, {nan, 0, 0})));
}

}  // namespace
}  // namespace mb
