#include "cases/contract/touchdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "mechanics/geometry/pose.h"
#include "mechanics/geometry/signed_distance.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double g = 9.81;
const Material rubber{1e6, 0.3, 1100, {}};

Scene above_floor(const Shape& shape, const Vector3d& c, const Vector3d& v = Vector3d::Zero()) {
  Scene scene = one_body(shape, rubber, {1, {1, 1, 1}});
  scene.bodies[0].pose.position = c;
  scene.bodies[0].twist.velocity = v;
  scene.gravity = {0, 0, -g};
  scene.duration = 1;
  scene.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({.body = scene.bodies[0].name, .obstacle = "floor", .stiffness = 0});
  return scene;
}
Touchdown of(const Scene& scene) { return touchdown(scene, scene.bodies[0]); }

TEST(Touchdown, OfADroppedBallIsTheParabolas) {
  const double R = 0.05;
  for (const double v : {0.0, -3.0, 2.0}) {
    const Touchdown down = of(above_floor(Sphere{R}, {0.2, 0, R + 0.3}, {1, 0, v}));
    const double t = (v + std::sqrt(v * v + 2 * g * 0.3)) / g;
    ASSERT_EQ(down.meetings.size(), 1u);
    EXPECT_NEAR(down.t, t, 1e-12);
    EXPECT_EQ(down.meetings[0].t, down.t);
    EXPECT_EQ(down.meetings[0].contact, 0u);
    EXPECT_LT((down.meetings[0].X - Vector3d(0, 0, -R)).norm(), 1e-6);  // middle of all that is nearly as low
    EXPECT_NEAR(down.meetings[0].size.speed, std::sqrt(v * v + 2 * g * 0.3), 1e-9);
  }
}

// What spins touches with the point that is lowest then: its speed is that of the point, along the normal.
TEST(Touchdown, OfASpinningBlockIsAtACorner) {
  const Vector3d size(0.1, 0.06, 0.2);
  Scene scene = above_floor(Box{size}, {0, 0, 0.5});
  scene.bodies[0].pose.orientation = Eigen::Quaterniond(0.9, 0.2, 0.3, -0.1).normalized();
  scene.bodies[0].twist.angular_velocity = {5, -3, 2};
  const Touchdown down = of(scene);
  ASSERT_TRUE(std::isfinite(down.t));
  EXPECT_LT((down.meetings[0].X.cwiseAbs() - size / 2).norm(), 0.05 * 0.2);
  const double lowest = down.meetings[0].size.speed, falling = g * down.t;
  EXPECT_GT(std::abs(lowest - falling), 1e-3);                   // the spin has its part
  EXPECT_LT(std::abs(lowest - falling), std::sqrt(38.) * 0.12);  // |w| |X|
}

// Faces and edges touch with all of their points: the middle stands for them.
TEST(Touchdown, OfAFaceOrAnEdgeIsItsMiddle) {
  const Touchdown flat = of(above_floor(Box{{0.1, 0.06, 0.2}}, {0, 0, 0.4}));
  EXPECT_LT((flat.meetings[0].X - Vector3d(0, 0, -0.1)).norm(), 1e-9);
  Scene lying = above_floor(Cylinder{0.03, 0.2}, {0, 0, 0.4});
  lying.bodies[0].pose.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(pi / 2, Vector3d::UnitY()));
  const Touchdown edge = of(lying);
  EXPECT_NEAR(std::abs(edge.meetings[0].X.z()), 0, 1e-3);
  EXPECT_NEAR(edge.meetings[0].X.head(2).norm(), 0.03, 1e-9);  // on the surface
  EXPECT_NEAR(edge.t, std::sqrt(2 * 0.37 / g), 1e-12);
}

TEST(Touchdown, OfSeveralObstaclesEachAlone) {
  Scene scene = above_floor(Sphere{0.05}, {0, 0, 1}, {4, 0, 0});
  scene.obstacles.push_back(
      {"wall", {HalfSpace{}, 0, {{1.05, 0, 0}, shortest_turn(Vector3d::UnitZ(), -Vector3d::UnitX())}}});
  scene.obstacles.push_back({"far", {Sphere{0.1}, 0, {{0, 5, 1}, {1, 0, 0, 0}}}});
  for (const char* name : {"wall", "far"})
    scene.contacts.push_back({.body = scene.bodies[0].name, .obstacle = name, .stiffness = 0});
  scene.contacts.push_back({.body = "another", .obstacle = "floor", .stiffness = 0});
  const Touchdown down = of(scene);
  ASSERT_EQ(down.meetings.size(), 3u);  // only of this body
  EXPECT_NEAR(down.meetings[0].t, std::sqrt(2 * 0.95 / g), 1e-12);
  EXPECT_NEAR(down.meetings[1].t, 0.25, 1e-12);
  EXPECT_EQ(down.t, down.meetings[1].t);
  EXPECT_EQ(down.meetings[2].t, std::numeric_limits<double>::infinity());  // never
  // Where it comes nearest: that side looks at the obstacle.
  EXPECT_GT(down.meetings[2].X.y(), 0.03);
  EXPECT_GT(down.meetings[2].size.stiffness, 0);
}

// Held bodies stand still: gravity does not take them down, what they touch they touch at once.
TEST(Touchdown, OfABodyThatIsHeldIsNowOrNever) {
  Scene scene = above_floor(Box{{0.1, 0.1, 0.1}}, {0, 0, 0.2});
  scene.bodies[0].supports.push_back({Support::Kind::fixed, {"z-max", {}}});
  EXPECT_EQ(of(scene).t, std::numeric_limits<double>::infinity());
  scene.bodies[0].pose.position.z() = 0.05;
  EXPECT_EQ(of(scene).t, 0);
}

TEST(Touchdown, OverlapIsRefusedWithItsDepth) {
  const double R = 0.05;
  EXPECT_NO_THROW(of(above_floor(Sphere{R}, {0, 0, R})));
  EXPECT_NO_THROW(of(above_floor(Sphere{R}, {0, 0, R - 0.9e-10})));  // rounding: 1e-9 of 0.1 m
  EXPECT_THROW(of(above_floor(Sphere{R}, {0, 0, R - 1.1e-10})), std::invalid_argument);
  const Scene deep = above_floor(Sphere{R}, {0, 0, R - 0.0123});
  EXPECT_THAT([&] { of(deep); },
              ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("body '" + deep.bodies[0].name + "'"),
                                                         HasSubstr("0.0123 m"), HasSubstr("obstacle 'floor'"))));
}

TEST(Touchdown, NamesWhatIsMissing) {
  Scene scene = above_floor(Sphere{0.05}, {0, 0, 1});
  scene.contacts[0].obstacle = "ceiling";
  EXPECT_THAT([&] { of(scene); }, ThrowsMessage<std::out_of_range>(HasSubstr("ceiling")));
}

TEST(Touchdown, OfWhatStrikesIsTheTopFaceAtOnce) {
  Scene scene = above_floor(Box{{0.1, 0.08, 0.02}}, {1, 2, 3});
  scene.obstacles[0] = {"floor", {Sphere{0.01}, 0, {{1, 2, 3.02}, {1, 0, 0, 0}}}, Striker{0.03, 2, 2e11, 0.3}};
  scene.contacts[0].law = ContactLaw::hertz;
  const Touchdown down = of(scene);
  EXPECT_EQ(down.t, 0);
  EXPECT_EQ(down.meetings[0].X, Vector3d(0, 0, 0.01));
  const RigidSurface plane = surface_met(scene, scene.bodies[0], down.meetings[0]);
  EXPECT_TRUE(std::holds_alternative<HalfSpace>(plane.shape));
  EXPECT_NEAR(gap_value(plane, {1.3, 2.2, 3.01}), 0, 1e-15);
  EXPECT_NEAR(gap_value(plane, {1, 2, 3}), 0.01, 1e-15);  // the body is outside
  const PenaltyLaw law = law_of(scene.contacts[0], down.meetings[0].size);
  EXPECT_EQ(law.exponent, 1.5);
  EXPECT_EQ(law.stiffness, down.meetings[0].size.stiffness);
  scene.bodies[0].shape = Sphere{0.05};
  EXPECT_THROW(of(scene), std::invalid_argument);
}

TEST(Touchdown, LawsAndFramesArePassedOn) {
  ContactPair pair{.body = "b", .obstacle = "o", .stiffness = 3e9, .damping = 0.2, .friction = 0.4, .slip_speed = 0.01};
  ContactSize size{};
  size.stiffness = 3e9;
  const PenaltyLaw law = law_of(pair, size);
  EXPECT_EQ(law.stiffness, 3e9);
  EXPECT_EQ(law.damping, 0.2);
  EXPECT_EQ(law.exponent, 1);
  ASSERT_TRUE(law.friction);
  EXPECT_EQ(law.friction->coefficient, 0.4);
  EXPECT_EQ(law.friction->slip_speed, 0.01);
  pair.friction = 0;
  EXPECT_FALSE(law_of(pair, size).friction);
  const Pose frame{{0.3, -0.2, 0.5}, Eigen::Quaterniond(0.5, 0.1, -0.7, 0.3).normalized()};
  const RigidSurface box{Box{{0.1, 0.2, 0.3}}, 0.01, {{1, 0, 0}, Eigen::Quaterniond(1, 2, 3, 4).normalized()}};
  const RigidSurface seen = seen_from(frame, box);
  for (const Vector3d& X : {Vector3d(0, 0, 0), Vector3d(0.5, -0.3, 0.2), Vector3d(-1, 2, 0.7)})
    EXPECT_NEAR(gap_value(seen, X), gap_value(box, frame.to_world(X)), 1e-14);
}

}  // namespace
}  // namespace mb
