#include "mechanics/contact/first_touch_ballistic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "mechanics/contact/first_touch_test_motions.h"

namespace mb {
namespace {

const RigidSurface table{HalfSpace{}, 0, {}};
const Vector3d down(0, 0, -9.81);

BallisticPath from(double height, double speed) { return {{0, 0, height}, {0, 0, speed}, down}; }

TEST(FirstTouchBallisticVerification, DropsTakeTheRootOfTwiceTheHeightOverG) {
  for (const double h : {1e-6, 1e-3, 1.0, 20.0}) {
    const auto touch = first_touch(Sphere{0.05}, from(0.05 + h, 0), table, {0, 10});
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->kind, FirstTouch::hit);
    const double height = (0.05 + h) - 0.05;  // what rounding leaves of h
    EXPECT_NEAR(touch->t, std::sqrt(2 * height / 9.81), 4e-16 * std::sqrt(1 + h));
    EXPECT_NEAR((touch->X - Vector3d(0, 0, -0.05)).norm(), 0, 1e-17);
  }
}

// A rise of 1 km/s for a fall of a nanometre: b^2 and 2 a c differ by 16 digits, and the root keeps all of its own.
TEST(FirstTouchBallisticVerification, RootsDoNotCancel) {
  const double h = std::ldexp(1.0, -30), v = -1000;  // exact in binary
  const auto touch = first_touch(Box{{2, 2, 2}}, from(1 + h, v), table, {0, 1, 1e-15});
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->t / (h / 1000 * (1 - 0.5 * 9.81 * h / 1e6)), 1, 4e-16);  // two terms of the series
}

// Both ways to the answer, for all that may happen; the general one knows the motion by its bounds only.
TEST(FirstTouchBallisticVerification, AgreesWithTheGeneralSearch) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
  const std::vector<Shape> shapes = {Box{{0.1, 0.2, 0.3}}, Cylinder{0.05, 0.2}, Sphere{0.1},
                                     Superquadric{{0.1, 0.05, 0.1}, 0.5, 1.5}};
  int hits = 0, none = 0;
  for (int trial = 0; trial < 80; ++trial) {
    const Shape& shape = shapes[static_cast<size_t>(trial) % shapes.size()];
    TestMotion motion(shape);
    motion.position = Vector3d(0, 0, 0.4) + 0.02 * vector();
    motion.velocity = vector(), motion.gravity = 3 * vector();
    motion.orientation = Eigen::Quaterniond(normal(random), normal(random), normal(random), 1).normalized();
    const BallisticPath path{motion.position, motion.velocity, motion.gravity, motion.orientation};
    const auto fast = first_touch(shape, path, table, {0, 1}), general = first_touch(shape, motion, table, {0, 1});
    ASSERT_EQ(fast.has_value(), general.has_value()) << trial;
    ++(fast ? hits : none);
    if (!fast) continue;
    EXPECT_EQ(fast->kind, general->kind);
    const double rate = std::abs((path.velocity + fast->t * path.acceleration)[2]);
    EXPECT_NEAR(fast->t, general->t, 1e-15 + 4e-16 / rate);  // gaps of a metre's rounding by the rate
  }
  EXPECT_GT(hits, 20);
  EXPECT_GT(none, 20);
}

TEST(FirstTouchBallistic, SaysWhichKind) {
  const Shape ball = Sphere{0.5};
  EXPECT_EQ(first_touch(ball, from(0.4, 1), table, {0, 1})->kind, FirstTouch::overlap);
  EXPECT_FALSE(first_touch(ball, from(1, 0), table, {0, 0.1}));
  // Rising against a lift of 1 m/s^2: the least height is h - v^2/2.
  for (const double gap : {-1e-9, 1e-9}) {
    const BallisticPath dip{{0, 0, 1 + gap}, {0, 0, -1}, {0, 0, 1}};
    const auto wide = first_touch(ball, dip, table, {0, 3, 1e-8}),
               narrow = first_touch(ball, dip, table, {0, 3, 1e-10});
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->kind, FirstTouch::grazing);
    EXPECT_EQ(wide->t, 1);
    EXPECT_NEAR(wide->gap, gap, 1e-16);
    EXPECT_EQ(narrow.has_value(), gap < 0);
    if (narrow) {
      EXPECT_EQ(narrow->kind, FirstTouch::hit);
    }
  }
}

TEST(FirstTouchBallistic, LeavingIsNoTouch) {
  const Shape ball = Sphere{0.5};
  TouchSearch leaving{2, 4, 1e-12, true, 1e-9};
  for (const double start : {0.0, -1e-10}) {
    const auto up = first_touch(ball, from(0.5 + start, 3), table, leaving);
    ASSERT_TRUE(up);
    EXPECT_NEAR(up->t, 2 + 2 * 3 / 9.81, 1e-10);  // the start's overlap
  }
  EXPECT_EQ(first_touch(ball, from(0.5, -3), table, leaving)->t, 2);
  EXPECT_EQ(first_touch(ball, from(0.5, 0), table, leaving)->t, 2);
  EXPECT_EQ(first_touch(ball, from(0.5 - 1e-8, 3), table, leaving)->kind, FirstTouch::overlap);
  EXPECT_FALSE(first_touch(ball, {{0, 0, 0.5}, {0, 0, 0}, {0, 0, 1}}, table, leaving));
  EXPECT_FALSE(first_touch(ball, {{0, 0, 0.5}, {1, 0, 0}, {0, 0, 0}}, table, leaving));  // sliding on
}

TEST(FirstTouchBallistic, RefusesWhatIsNotItsBusiness) {
  const Shape ball = Sphere{0.5};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(first_touch(ball, from(1, 0), {Shape(Sphere{1}), 0, {}}, {0, 1}), std::invalid_argument);
  EXPECT_THROW(first_touch(ball, from(nan, 0), table, {0, 1}), std::invalid_argument);
  EXPECT_THROW(first_touch(ball, from(1, 0), table, {1, 0}), std::invalid_argument);
  EXPECT_THROW(first_touch(ball, from(1, 0), table, {0, nan}), std::invalid_argument);
  BallisticPath bent = from(1, 0);
  bent.orientation.w() = 2;
  EXPECT_THROW(first_touch(ball, bent, table, {0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
