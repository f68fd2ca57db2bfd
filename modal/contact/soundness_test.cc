#include "modal/contact/soundness.h"

#include <gtest/gtest.h>

#include <limits>

#include "modal/contact/floating_bodies_test.h"

namespace mb {
namespace {

using Eigen::Vector3d;

constexpr double R = 0.05;
const Shape ball = Sphere{R};

// A free ball that falls at 2 m/s, nothing strained: m v^2 / 2 = 2 m at hand, and m g R of weight.
struct Falling : ::testing::Test {
  FloatingBody body = testing::floating(ball, {roots({1e4, 0})}, {0, 0, -10});
  ContactState state{testing::at_rest(body, {0, 0, R}, {0, 0, -2}), {}, Vector3d::Zero(), 0};
  Soundness soundness{{&body}, {R}};
  double at_hand = body.mass * (2 + 10 * R);
};

TEST_F(Falling, MayTurnItsEnergyIntoAnyOther) {
  soundness.begin({&state, 1});
  EXPECT_EQ(soundness({&state, 1}), Status::ok);
  state.body.v.setZero();
  state.load.stored = 2 * body.mass;
  EXPECT_EQ(soundness({&state, 1}), Status::ok);
  state.load.stored = 0;
  state.body.c.z() += 0.2;  // 2 m of energy turned into height
  EXPECT_EQ(soundness({&state, 1}), Status::ok);
}

TEST_F(Falling, IsUnstableOnceAsMuchAsItHadWasGained) {
  soundness.begin({&state, 1});
  state.dissipated = 0.999 * at_hand;
  EXPECT_EQ(soundness({&state, 1}), Status::ok);
  state.dissipated = 1.001 * at_hand;
  EXPECT_EQ(soundness({&state, 1}), Status::unstable);
  state.dissipated = 0;
  state.body.v.z() = 1e200;  // whose square is no number
  EXPECT_EQ(soundness({&state, 1}), Status::not_finite);
  state.body.v.z() = 1e100;
  EXPECT_EQ(soundness({&state, 1}), Status::unstable);
}

// Of height and of a weight that has done its work nothing is at hand: a far away origin changes nothing.
TEST_F(Falling, ThePlaceOfTheOriginDoesNotMatter) {
  state.body.c.z() = 1e4;
  soundness.begin({&state, 1});
  state.dissipated = 0.99 * at_hand;
  EXPECT_EQ(soundness({&state, 1}), Status::ok);
  state.dissipated = 1.01 * at_hand;
  EXPECT_EQ(soundness({&state, 1}), Status::unstable);
}

TEST_F(Falling, NotANumberIsNamed) {
  soundness.begin({&state, 1});
  state.body.q[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(soundness({&state, 1}), Status::not_finite);
}

}  // namespace
}  // namespace mb
