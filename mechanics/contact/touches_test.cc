#include "mechanics/contact/touches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mb {
namespace {

// Gap sin(t) from t = 0 on, force its depth squared: touches in (pi, 2 pi), (3 pi, 4 pi), ...
ContactMoment wave(double t) {
  const double gap = std::sin(t), f = gap < 0 ? gap * gap : 0;
  return {t, gap, {0, 0, f}, {0, 0, t}};
}

TEST(TouchLog, FindsStartEndAndPeak) {
  TouchLog log;
  const double h = 0.01;
  for (int i = 0; i <= 1000; ++i) log.add(wave(i * h));
  const auto touches = log.touches();
  ASSERT_EQ(touches.size(), 2u);
  EXPECT_NEAR(touches[0].start, pi, 1e-6);  // a line through a sine: h^3/8 times its third derivative
  EXPECT_NEAR(touches[0].end, 2 * pi, 1e-6);
  EXPECT_NEAR(touches[0].peak_time, 1.5 * pi, 1e-6);
  EXPECT_NEAR(touches[0].peak_force, 1, 1e-8);
  EXPECT_NEAR(touches[0].impulse.z(), pi, 2 * h);  // of whole steps
  EXPECT_NEAR(touches[1].start, 3 * pi, 1e-6);
  EXPECT_EQ(touches[1].end, std::numeric_limits<double>::infinity());  // it lasts
}

TEST(TouchLog, ShortSeparationsBelongToTheTouch) {
  TouchLog log;
  const auto at = [&](double t, double gap) { log.add({t, gap, {0, 0, gap < 0 ? 1.0 : 0.0}, {0, 0, t}}); };
  at(0, 1), at(1, -1), at(10, -1), at(10.2, 0.1), at(10.4, -1), at(20, -1), at(21, 1), at(30, -1), at(31, 1);
  const auto touches = log.touches();
  ASSERT_EQ(touches.size(), 2u);
  EXPECT_DOUBLE_EQ(touches[0].start, 0.5);
  EXPECT_DOUBLE_EQ(touches[0].end, 20.5);
  EXPECT_DOUBLE_EQ(touches[0].impulse.z(), 21);
}

TEST(TouchLog, StartsWhereSurfacesMet) {
  TouchLog log;
  log.meet(0.25);
  log.add({0.25, 0.1, {}, Vector3d::Zero()});
  log.add({1, -0.1, {0, 0, 2}, {0, 0, 1}});
  ASSERT_EQ(log.touches().size(), 1u);
  EXPECT_EQ(log.touches()[0].start, 0.25);
  EXPECT_EQ(log.touches()[0].peak_force, 2);
}

// A touch that is foretold counts from then on once: the next one starts at its own crossing.
TEST(TouchLog, WhereSurfacesMetIsForOneTouchAlone) {
  TouchLog log;
  const auto at = [&](double t, double gap) { log.add({t, gap, {0, 0, gap < 0 ? 1.0 : 0.0}, {0, 0, t}}); };
  at(0, 1);
  log.meet(0.75);  // between two moments
  at(1, -1), at(2, 1), at(9, 1), at(10, -1), at(12, 1);
  ASSERT_EQ(log.touches().size(), 2u);
  EXPECT_EQ(log.touches()[0].start, 0.75);
  EXPECT_EQ(log.touches()[0].end, 1.5);
  EXPECT_EQ(log.touches()[1].start, 9.5);
  EXPECT_EQ(log.touches()[1].end, 11);
  // Told again before anything presses, the last word counts.
  TouchLog twice;
  twice.meet(1), twice.meet(2);
  twice.add({2, 0.1, Vector3d::Zero(), Vector3d::Zero()});
  twice.add({3, -0.1, {0, 0, 1}, {0, 0, 1}});
  EXPECT_EQ(twice.touches()[0].start, 2);
}

// A surface that quivers before it is pressed in earnest: one touch.
TEST(TouchLog, AShortTouchBelongsToTheLongOneSoonAfter) {
  TouchLog log;
  const auto at = [&](double t, double gap) { log.add({t, gap, {0, 0, gap < 0 ? 1.0 : 0.0}, {0, 0, t}}); };
  at(0, 1), at(0.2, -1), at(0.4, 1), at(1.0, 1), at(1.2, -1), at(20, -1), at(21, 1);  // apart from 0.3 to 1.1
  const auto touches = log.touches();
  ASSERT_EQ(touches.size(), 1u);
  EXPECT_DOUBLE_EQ(touches[0].start, 0.1);
  EXPECT_DOUBLE_EQ(touches[0].end, 20.5);
  EXPECT_EQ(touches[0].peak_force, 1);
  EXPECT_DOUBLE_EQ(touches[0].impulse.z(), 0.4 + 20);
}

// Whether a separation is short is judged by the longer touch beside it, all that was merged into it included.
TEST(TouchLog, MergedTouchesGrowTogether) {
  TouchLog log;
  const auto at = [&](double t, double gap, double f) { log.add({t, gap, {0, 0, f}, {0, 0, t}}); };
  at(0, -1, 1), at(10, -1, 1), at(10.5, 1, 0), at(11.5, -1, 1);  // apart from 10.25 to 11: 0.075 of 10.25
  EXPECT_EQ(log.touches().size(), 1u);
  EXPECT_EQ(log.touches()[0].end, std::numeric_limits<double>::infinity());
  at(20, -1, 1), at(21, 1, 0), at(23, -1, 9),
      at(25, -1, 0);  // from 20.5 to 22, which is 0.073 of all 20.5, but more of the last 9.5
  at(30, -1, 1), at(31, 1, 0), at(36, -1, 4), at(37, 1, 0);  // from 30.5 to 33.5: 0.098 of 30.5
  const auto one = log.touches();
  ASSERT_EQ(one.size(), 1u);
  EXPECT_DOUBLE_EQ(one[0].end, 36.5);
  EXPECT_EQ(one[0].peak_force, 9);  // the largest of all
  EXPECT_EQ(one[0].peak_time, 23);
  EXPECT_EQ(one[0].impulse.z(), 37);
  at(45, 1, 0), at(46, -1, 1), at(47, 1, 0);  // from 36.5 to 45.5: 0.25 of 36.5
  const auto two = log.touches();
  ASSERT_EQ(two.size(), 2u);
  EXPECT_DOUBLE_EQ(two[1].start, 45.5);
  EXPECT_EQ(two[1].impulse.z(), 2);  // of the steps that it is in
}

TEST(TouchLog, BeginsInTouch) {
  TouchLog log;
  log.add({0.5, -0.1, {0, 0, 2}, Vector3d::Zero()});
  log.add({1, 0.1, Vector3d::Zero(), {0, 0, 1}});
  ASSERT_EQ(log.touches().size(), 1u);
  EXPECT_EQ(log.touches()[0].start, 0.5);
  EXPECT_EQ(log.touches()[0].end, 0.75);
  EXPECT_EQ(log.touches()[0].peak_force, 2);
  EXPECT_EQ(log.touches()[0].peak_time, 0.5);
}

TEST(TouchLog, NeverTouchingIsNoTouch) {
  TouchLog log;
  for (int i = 0; i < 5; ++i) log.add({0.1 * i, 1e-9, Vector3d::Zero(), Vector3d::Zero()});
  EXPECT_TRUE(log.touches().empty());
}

}  // namespace
}  // namespace mb
