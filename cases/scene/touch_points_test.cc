#include "cases/scene/touch_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"

namespace mb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;

Scene scene_of(const Shape& shape, const RigidSurface& surface, const Pose& pose, const Twist& twist = {}) {
  Scene scene = one_body(shape, {2e4, 0.3, 1000}, {1, {1, 1, 1}});
  scene.bodies[0].pose = pose;
  scene.bodies[0].twist = twist;
  scene.obstacles.push_back({"thing", surface});
  scene.contacts.push_back({"body", "thing", 0});
  return scene;
}
Vector3d touched(const Scene& scene) {
  const auto points = touch_points(scene, scene.bodies[0]);
  EXPECT_EQ(points.size(), 1u);
  return points.at(0);
}
Quaterniond turn(double angle, const Vector3d& axis) { return Quaterniond(AngleAxisd(angle, axis.normalized())); }

const Quaterniond level = Quaterniond::Identity(), tilted = turn(0.7, {1, 2, -1}), slope = turn(0.4, {1, 0.5, 0});
const RigidSurface floor_below{HalfSpace{}, 0, {{0, 0, -5}, level}}, slope_below{HalfSpace{}, 0, {{0, 0, -5}, slope}};
const double rounding = 1e-14;

TEST(TouchPoints, OfASphereLieAgainstTheNormal) {
  const Pose pose{{0.3, 0.1, 0}, tilted};
  const Vector3d X = touched(scene_of(Sphere{0.2}, slope_below, pose));
  EXPECT_LT((tilted * X + 0.2 * (slope * Vector3d::UnitZ())).norm(), rounding);
}

TEST(TouchPoints, OfABoxAreTheMiddleOfItsLowestFeature) {
  const Box box{{0.3, 0.2, 0.5}};
  const auto at = [&](const Quaterniond& q) { return touched(scene_of(box, floor_below, {{0, 0, 0}, q})); };
  EXPECT_LT((at(level) - Vector3d(0, 0, -0.25)).norm(), rounding);
  EXPECT_LT((at(turn(0.3, Vector3d::UnitX())) - Vector3d(0, -0.1, -0.25)).norm(), rounding);  // an edge along x
  EXPECT_LT((at(turn(pi / 2, Vector3d::UnitX())) - Vector3d(0, -0.1, 0)).norm(), rounding);   // a face, to rounding
  EXPECT_LT(
      (at(tilted) - Vector3d(-0.15, -0.1, -0.25).cwiseProduct((tilted.conjugate() * Vector3d::UnitZ()).cwiseSign()))
          .norm(),
      rounding);
}

TEST(TouchPoints, OfACylinderAreOnItsEndRimOrSide) {
  const Cylinder cylinder{0.05, 0.2};
  const auto at = [&](const Quaterniond& q) { return touched(scene_of(cylinder, floor_below, {{0, 0, 0}, q})); };
  EXPECT_LT((at(level) - Vector3d(0, 0, -0.1)).norm(), rounding);
  EXPECT_LT((at(turn(0.3, Vector3d::UnitX())) - Vector3d(0, -0.05, -0.1)).norm(), rounding);
  EXPECT_LT((at(turn(pi / 2, Vector3d::UnitX())) - Vector3d(0, -0.05, 0)).norm(), rounding);
}

// Closed form and search agree: a half-space, and a box of a mile in its place.
TEST(TouchPoints, BySearchAreThoseInClosedForm) {
  for (const Shape& shape : {Shape(Box{{0.3, 0.2, 0.5}}), Shape(Cylinder{0.05, 0.2}), Shape(Sphere{0.2})})
    for (const Quaterniond& q : {level, tilted, turn(0.3, Vector3d::UnitX()), turn(0.7, {1, -0.2, 0.1})}) {
      const Pose pose{{0, 0, -4}, q};
      const RigidSurface slab{Shape(Box{{1600, 1600, 100}}), 0, {slope * Vector3d(0, 0, -55), slope}},
          half{HalfSpace{}, 0, {slope * Vector3d(0, 0, -5), slope}};
      const Vector3d X = touched(scene_of(shape, slab, pose, {{0, 0, -3}, {0, 0, 0}})),
                     expected = touched(scene_of(shape, half, pose));
      // A search ends at steps of 1e-6 and gaps of 1e-12 of the extent, of which smooth minima give the root.
      EXPECT_LT((X - expected).norm(), 1e-5 * extent(shape)) << shape.index() << " " << q.coeffs().transpose();
    }
}

// Two spheres, one standing: |p(t) - c| = R + r at the touch, which lies between them.
TEST(TouchPoints, LieOnTheWayOfFlight) {
  const double R = 0.2, r = 0.3;
  const Vector3d c(2, 0.1, -0.4), v(3, 0.2, 1);
  Scene scene = scene_of(Sphere{R}, {Shape(Sphere{r}), 0, {c, level}}, {{0, 0, 0}, tilted}, {v, {0, 0, 0}});
  scene.gravity = {0, 0, -4};
  const auto place = [&](double t) -> Vector3d { return t * v + 0.5 * t * t * scene.gravity; };
  double before = 0, after = 0.65;  // they overlap then
  ASSERT_LT((place(after) - c).norm(), R + r);
  for (int i = 0; i < 60; ++i)
    ((place(0.5 * (before + after)) - c).norm() > R + r ? before : after) = 0.5 * (before + after);
  const Vector3d expected = R * (c - place(after)).normalized();
  EXPECT_LT((tilted * touched(scene) - expected).norm(), 1e-5 * R);
  // Held, it stays where it is.
  scene.bodies[0].supports.push_back({Support::Kind::fixed, {"surface", {}}, {}});
  EXPECT_LT((tilted * touched(scene) - R * c.normalized()).norm(), 1e-5 * R);
}

// What passes by comes nearest half-way, and what stays nearest at once.
TEST(TouchPoints, OfWhatPassesByAreThoseOfTheNearestApproach) {
  const RigidSurface ball{Shape(Sphere{0.3}), 0, {{2, 1, 0}, level}};
  Scene scene = scene_of(Sphere{0.2}, ball, {{0, 0, 0}, level}, {{4, 0, 0}, {0, 0, 0}});
  EXPECT_LT((touched(scene) - Vector3d(0, 0.2, 0)).norm(), 1e-5);  // at half the duration, one of the looks
  scene.bodies[0].twist.velocity *= -1;
  EXPECT_LT((touched(scene) - 0.2 * Vector3d(2, 1, 0).normalized()).norm(), 1e-5);
}

TEST(TouchPoints, OfFaceOnFaceAreTheMiddle) {
  const RigidSurface table{Shape(Box{{3, 3, 1}}), 0.05, {{0.2, 0.1, -2}, level}};
  const Vector3d X = touched(scene_of(Box{{0.3, 0.2, 0.5}}, table, {}, {{0, 0, -3}, {0, 0, 0}}));
  EXPECT_LT((X - Vector3d(0, 0, -0.25)).norm(), 1e-9);
}

TEST(TouchPoints, StandInTheOrderOfContactsAndOfTheBodyAlone) {
  Scene scene = scene_of(Sphere{0.2}, floor_below, {});
  scene.obstacles.push_back({"wall", {HalfSpace{}, 0, {{-3, 0, 0}, turn(pi / 2, Vector3d::UnitY())}}});
  scene.contacts = {{"other", "thing", 0}, {"body", "wall", 0}, {"body", "thing", 0}};
  const auto points = touch_points(scene, scene.bodies[0]);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT((points[0] - Vector3d(-0.2, 0, 0)).norm(), rounding);
  EXPECT_LT((points[1] - Vector3d(0, 0, -0.2)).norm(), rounding);
  scene.contacts.clear();
  EXPECT_TRUE(touch_points(scene, scene.bodies[0]).empty());
}

TEST(TouchPoints, RefuseUnknownObstaclesAndNumbersThatAreNone) {
  const Scene good = scene_of(Sphere{0.2}, floor_below, {});
  const auto refused = [&](const auto& change) {
    Scene scene = good;
    change(scene);
    EXPECT_THROW(touch_points(scene, scene.bodies[0]), std::invalid_argument);
  };
  refused([](Scene& s) { s.contacts[0].obstacle = "nothing"; });
  refused([](Scene& s) { s.bodies[0].twist.velocity[1] = std::nan(""); });
  refused([](Scene& s) { s.bodies[0].pose.position[0] = INFINITY; });
  refused([](Scene& s) { s.bodies[0].pose.orientation.coeffs() *= 1.1; });
  refused([](Scene& s) { s.gravity[2] = INFINITY; });
  refused([](Scene& s) { s.duration = std::nan(""); });
}

}  // namespace
}  // namespace mb
