// Grazing, leaving, overlap and bad input.
#include <gtest/gtest.h>

#include <limits>

#include "mechanics/contact/first_touch_test_motions.h"

namespace mb {
namespace {

const RigidSurface table{HalfSpace{}, 0, {}};
const Shape ball = Sphere{0.05};

TestMotion thrown(double height, double speed) {
  TestMotion m(ball);
  m.position = {0, 0, 0.05 + height}, m.velocity = {0.3, 0, speed}, m.gravity = {0, 0, -9.81};
  return m;
}

// A sphere on a straight path past another, nearest at t = 0.4 where the gap is d - (R1 + R2).
TEST(FirstTouchVerification, SpheresThatPassGrazeOrHit) {
  const RigidSurface obstacle{Shape(Sphere{0.1}), 0, {}};
  for (const double gap : {1e-9, -1e-9}) {
    TestMotion m(ball);
    const double d = 0.15 + gap, v = 2;
    m.velocity = {v, 0, 0}, m.spin = {0.1, 0.2, -0.1};
    m.position = Vector3d(-0.4 * v, 0, d);
    const auto wide = first_touch(ball, m, obstacle, {0, 1, 1e-8}),
               narrow = first_touch(ball, m, obstacle, {0, 1, 1e-10});
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->kind, FirstTouch::grazing);
    EXPECT_NEAR(wide->t, 0.4, 1e-13);
    EXPECT_NEAR(wide->gap, gap, 1e-16);
    ASSERT_EQ(narrow.has_value(), gap < 0);
    if (!narrow) continue;
    EXPECT_EQ(narrow->kind, FirstTouch::hit);
    EXPECT_NEAR(narrow->t, 0.4 - std::sqrt(0.15 * 0.15 - d * d) / v, 1e-12);  // a rounding of d by the rate, 2e-4 m/s
  }
}

// A vibration that dips to the table between two turns of a rising ball.
TEST(FirstTouch, GrazesInTheMiddleOfAFlight) {
  for (const double gap : {-1e-9, 1e-9}) {
    TestMotion m = thrown(0, 0);
    m.gravity.setZero(), m.velocity.setZero();
    m.position[2] = 0.05 * 1.01 + gap;  // least at sin = 1
    m.vibrations = {{100, 0, 0.01 * Eigen::Matrix3d::Identity(), {}}};
    const auto touch = first_touch(ball, m, table, {0, 1, 1e-8});
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->kind, FirstTouch::grazing);
    EXPECT_NEAR(touch->t, 0.5 * pi / 100, 1e-12);
    EXPECT_NEAR(touch->gap, gap, 1e-16);
    const auto strict = first_touch(ball, m, table, {0, 0.05, 1e-10});
    ASSERT_EQ(strict.has_value(), gap < 0);
    if (strict) {
      EXPECT_EQ(strict->kind, FirstTouch::hit);
      const double s = (m.position[2] / 0.05 - 1) / 0.01;
      EXPECT_NEAR(strict->t, std::asin(s) / 100, 1e-11);  // a rounding of 0.05 m by the rate, 3e-4 m/s and of 1 - s
    }
  }
}

TEST(FirstTouch, WhatLeavesIsNotTouching) {
  TouchSearch search{0, 1, 1e-12, true, 1e-9};
  for (const double start : {0.0, 1e-13, -1e-12, -9e-10})
    for (const double speed : {1e-3, 0.1, 3.0}) {
      const auto touch = first_touch(ball, thrown(start, speed), table, search);
      ASSERT_TRUE(touch);
      EXPECT_EQ(touch->kind, FirstTouch::hit);
      const double back = (speed + std::sqrt(speed * speed + 2 * 9.81 * start)) / 9.81;
      EXPECT_NEAR(touch->t, back, 1e-13);  // 1e-16 m by 1e-3 m/s
    }
  for (const double speed : {-1e-3, -3.0, 0.0}) EXPECT_EQ(first_touch(ball, thrown(0, speed), table, search)->t, 0);
  EXPECT_EQ(first_touch(ball, thrown(-2e-9, 3), table, search)->kind, FirstTouch::overlap);
  search.t1 = 0.5;
  EXPECT_FALSE(first_touch(ball, thrown(0, 3), table, search));
  TestMotion sliding = thrown(0, 0);
  sliding.gravity.setZero();
  EXPECT_FALSE(first_touch(ball, sliding, table, search));
}

// A box let go on an edge, turning: the next touch is that of another edge, by the height of its corners.
TEST(FirstTouchVerification, ABoxThatLeavesOnOneEdgeComesDownOnAnother) {
  const Shape box = Box{{0.2, 1, 0.1}};
  TestMotion m(box);
  m.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Vector3d::UnitY()));
  m.spin = {0, -5, 0}, m.gravity = {0, 0, -9.81};
  const auto reach = [](double angle) { return 0.1 * std::abs(std::sin(angle)) + 0.05 * std::abs(std::cos(angle)); };
  m.position = {0, 0, reach(0.2)}, m.velocity = {0, 0, 0.1};
  const auto height = [&](double t) { return m.position[2] + t * (0.1 - 0.5 * 9.81 * t) - reach(0.2 - 5 * t); };
  double a = 0.01, b = a;  // at 0.04 s the box is level: the other edge comes down
  while (height(b) > 0) a = b, b += 1e-5;
  for (int i = 0; i < 60; ++i) (height((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
  const auto touch = first_touch(box, m, table, {0, 1, 1e-12, true});
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->t, a, 1e-14);
  EXPECT_GT(touch->t, 0.01);
}

TEST(FirstTouchVerification, AVibrationBringsTheSurfaceBack) {
  TestMotion m = thrown(0, 0.01);
  m.vibrations = {{2000, 0, -0.001 * Eigen::Matrix3d::Identity(), {}}};  // it shrinks first
  const auto height = [](double t) { return t * (0.01 - 0.5 * 9.81 * t) + 0.05 * 0.001 * std::sin(2000 * t); };
  double a = 1e-3, b = 2.3e-3;  // about half a period
  for (int i = 0; i < 60; ++i) (height((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
  const auto touch = first_touch(ball, m, table, {0, 1, 1e-12, true});
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->kind, FirstTouch::hit);
  EXPECT_NEAR(touch->t, a, 1e-14);
}

TEST(FirstTouch, StartingWithinTheToleranceIsTouching) {
  EXPECT_EQ(first_touch(ball, thrown(0, -1), table, {0, 1})->kind, FirstTouch::hit);
  EXPECT_EQ(first_touch(ball, thrown(0, -1), table, {0, 1})->t, 0);
  EXPECT_EQ(first_touch(ball, thrown(0, 1), table, {0, 1})->kind, FirstTouch::grazing);
  EXPECT_EQ(first_touch(ball, thrown(0, 1), table, {0, 1})->t, 0);
  const auto inside = first_touch(ball, thrown(-0.01, 1), table, {0, 1});
  EXPECT_EQ(inside->kind, FirstTouch::overlap);
  EXPECT_NEAR(inside->gap, -0.01, 1e-15);
  EXPECT_EQ(first_touch(ball, thrown(-0.01, 1), table, {0, 0})->kind, FirstTouch::overlap);
  EXPECT_FALSE(first_touch(ball, thrown(0.01, 1), table, {0, 0}));
}

// What only lies nearer on the far side of the first guess counts, too.
TEST(FirstTouch, FindsOverlapsFarFromTheMiddleOfPatches) {
  const Shape plate = Box{{1, 1, 0.01}};
  TestMotion m(plate);
  m.position = {0, 0, 0.01};
  EXPECT_EQ(first_touch(plate, m, {Shape(Sphere{0.1}), 0, {{0.45, 0.45, -0.08}, {1, 0, 0, 0}}}, {0, 1})->kind,
            FirstTouch::overlap);
}

// A face that comes down flat, while bounds allow for its bending: of the last tens of nanometres nothing can be proved
// with a bounded number of cells, and the bracket says it. The touch is found nevertheless.
TEST(FirstTouchVerification, AFaceThatTouchesAllAtOnce) {
  const Shape box = Box{{0.1, 0.1, 0.1}};
  TestMotion m(box);
  m.position = {0, 0, 1}, m.gravity = {0, 0, -9.81};
  Vibration shear{700, 1, Eigen::Matrix3d::Zero(), std::vector<Eigen::Matrix3d>(3, Eigen::Matrix3d::Zero())};
  shear.bends[0](0, 2) = shear.bends[0](2, 0) = 0.05;  // u_x of x z: the face stays plane
  m.vibrations = {shear};
  const auto touch = first_touch(box, m, table, {0, 1});
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->kind, FirstTouch::hit);
  EXPECT_NEAR(touch->t, std::sqrt(2 * 0.95 / 9.81), 1e-15);
  EXPECT_LT(touch->bracket, 1e-7);
  EXPECT_GT(touch->bracket, 0);
}

struct Broken : TestMotion {
  using TestMotion::TestMotion;
  MotionBounds answer;
  MotionBounds bounds(double, double) const override { return answer; }
};

TEST(FirstTouch, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const TestMotion good = thrown(1, 0);
  const auto search = [&](TouchSearch s) { return [=] { first_touch(ball, good, table, s); }; };
  EXPECT_THROW(search({1, 0})(), std::invalid_argument);
  EXPECT_THROW(search({nan, 1})(), std::invalid_argument);
  EXPECT_THROW(search({0, infinity})(), std::invalid_argument);
  EXPECT_THROW(search({0, 1, 0})(), std::invalid_argument);
  EXPECT_THROW(search({0, 1, nan})(), std::invalid_argument);
  EXPECT_THROW(search({0, 1, 1e-12, true, -1})(), std::invalid_argument);
  EXPECT_THROW(search({0, 1, 1e-12, false, 0, 0})(), std::invalid_argument);
  EXPECT_THROW(first_touch(Sphere{-1}, good, table, {0, 1}), std::invalid_argument);
  EXPECT_THROW(first_touch(ball, good, {HalfSpace{}, 0.1, {}}, {0, 1}), std::invalid_argument);
  TestMotion lost = good;
  lost.velocity[1] = nan;
  EXPECT_THROW(first_touch(ball, lost, table, {0, 1}), std::invalid_argument);
  for (const double bad : {-1.0, nan, infinity}) {
    Broken broken(ball);
    broken.position = {0, 0, 1};
    for (double MotionBounds::*bound : {&MotionBounds::spread, &MotionBounds::bend, &MotionBounds::bend_rate}) {
      broken.answer = {};
      broken.answer.*bound = bad;
      EXPECT_THROW(first_touch(ball, broken, table, {0, 1}), std::invalid_argument);
    }
  }
}

// Above the tolerance by a part of it, for ever, with bounds that would allow a touch at any moment.
TEST(FirstTouch, SaysWhereNothingCanBeProved) {
  TestMotion m = thrown(2e-12, 0);
  m.gravity.setZero(), m.spin = {0, 0, 1000};
  const auto touch = first_touch(ball, m, table, {0, 1, 1e-12, false, 0, 20000});
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->kind, FirstTouch::undecided);
  EXPECT_GE(touch->gap, 0);
}

}  // namespace
}  // namespace mb
