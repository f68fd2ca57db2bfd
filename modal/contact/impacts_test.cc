// Impacts of more than one touch, one obstacle or one motion.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/rigid/flight.h"
#include "modal/contact/floating_bodies_test.h"
#include "modal/frame/body_flight.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::floating;
using testing::ground;
using testing::no_modes;
using testing::plan_of;
using testing::samples_of;
using testing::wall;

constexpr double R = 0.05, k_n = 1e11;  // [m], [Pa/m]
const Shape ball = Sphere{R};

// Where a ball about c has its point next to a surface.
Vector3d towards(const RigidSurface& surface, const Vector3d& c) { return -R * gap(surface, c).normal; }

ImpactPlan ball_among(const std::vector<RigidSurface>& walls, const Vector3d& c, const Vector3d& v) {
  FloatingBody body = floating(ball, {}, Vector3d::Zero());
  for (const RigidSurface& surface : walls)
    body.contacts.push_back(
        {samples_of(ball, no_modes(ball), {R / 60, R / 4, 0.2, 2}, {towards(surface, c)}), surface, {k_n, 0, {}}});
  return plan_of(body, ball, no_modes(ball), at_rest(body, c, v), ContactScheme::exact, 1e-6);
}

TEST(Impacts, BetweenTwoWalls) {
  const double v = 5, gap = 0.02;
  const RigidSurface ceiling = wall({0, 0, 2 * R + gap}, -Vector3d::UnitZ());
  const ImpactPlan plan = ball_among({ground, ceiling}, {0, 0, R + gap / 2}, {0, 0, v});
  const double m = plan.body.mass, deepest = std::cbrt(1.5 * m * v * v / (pi * R * k_n));
  const double contact = 2 * deepest / v * std::beta(1.0 / 3, 0.5) / 3;  // see impact_motion_test.cc
  const ImpactMotion motion = impact_motion(plan, VectorXd{{4.8 * gap / v + 5 * contact}});
  const auto& touches = motion.contact.touches;
  ASSERT_EQ(touches.size(), 5u);
  EXPECT_NEAR(touches[0].start, gap / 2 / v, 1e-15);
  for (size_t i = 0; i < touches.size(); ++i) {
    const double to = i % 2 == 0 ? -1 : 1;  // the ceiling pushes down
    EXPECT_NEAR(touches[i].impulse.z(), to * 2 * m * v, 1e-5 * m * v);
    EXPECT_LT(touches[i].impulse.head(2).norm(), 1e-9 * m * v);
    // It flies on from where it let go, not quite where it came to touch: samples let go a little early.
    if (i > 0) {
      EXPECT_NEAR(touches[i].start - touches[i - 1].end, gap / v, 2e-3 * gap / v);
    }
  }
}

// Both faces of a corner at once: all of the velocity is turned round, each wall having its own part of the impulse.
TEST(Impacts, IntoACorner) {
  const double v = 4;
  const ImpactPlan plan = ball_among({wall({-R, 0, 0}, Vector3d::UnitX()), ground}, {1e-3, 0, R + 1e-3}, {-v, 0.1, -v});
  const ImpactMotion motion = impact_motion(plan, VectorXd{{2e-3}});
  ASSERT_EQ(motion.contact.touches.size(), 1u);
  EXPECT_NEAR(motion.contact.touches[0].start, 1e-3 / v, 1e-15);
  EXPECT_LT((motion.states[0].v - Vector3d(v, 0.1, v)).norm(), 1e-5 * v);
  EXPECT_LT((motion.contact.touches[0].impulse - 2 * v * plan.body.mass * Vector3d(1, 0, 1)).norm(),
            1e-5 * v * plan.body.mass);
}

// Off a ball that stands still, a third of the radius off the line of centres: the impulse is along the normal.
TEST(Impacts, OffABallIsReflectedAtItsNormal) {
  const double v = 6, beside = 2 * R / 3;
  const RigidSurface other{Sphere{R}, 0, {{0.2, 0, 0}, {1, 0, 0, 0}}};
  const ImpactPlan plan = ball_among({other}, {0, beside, 0}, {v, 0, 0});
  const double along = std::sqrt(4 * R * R - beside * beside), t1 = (0.2 - along) / v;
  const ImpactMotion motion = impact_motion(plan, VectorXd{{t1 + 2e-3}});
  ASSERT_EQ(motion.contact.touches.size(), 1u);
  EXPECT_NEAR(motion.contact.touches[0].start, t1, 1e-14);
  const Vector3d n = Vector3d(-along, beside, 0).normalized();
  const Vector3d expected = Vector3d(v, 0, 0) - 2 * v * n.x() * n;
  EXPECT_LT((motion.states[0].v - expected).norm(), 0.03 * v);  // it slides along a little while it is pressed
  EXPECT_NEAR(motion.states[0].v.norm(), v, 1e-4 * v);
}

// A block spins freely, comes down on a corner, and is turned by the impulse there.
TEST(Impacts, SpinsFreelyUntilACornerTouches) {
  const Shape block = Box{{0.12, 0.08, 0.2}};
  FloatingBody body = floating(block, {}, {0, 0, -9.81});
  body.contacts.push_back({samples_of(block, no_modes(block), {2e-3, 2e-3, 0, 1}), ground, {5e10, 0, {}}});
  ImpactPlan plan =
      plan_of(body, block, no_modes(block), at_rest(body, {0, 0, 0.5}, {0.2, 0, -1}), ContactScheme::exact, 1e-6);
  plan.start.Q = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.33).normalized();
  const Vector3d spin(7, -4, 11);
  plan.start.L = plan.start.Q * (body.inertia * (plan.start.Q.conjugate() * spin));
  const Flight flight({body.mass, Vector3d::Zero(), body.inertia}, {plan.start.c, plan.start.Q}, {plan.start.v, spin},
                      body.gravity);
  const auto height = [&](double t) {
    const Pose pose = flight.at(t);
    const Vector3d low = pose.orientation.conjugate() * Vector3d(0, 0, -1);
    return pose.to_world(support_point(block, low)).z();
  };
  double low = 0, high = 0;
  while (height(high) > 0) low = high, high += 1e-4;
  while (low < (low + high) / 2 && (low + high) / 2 < high)
    (height((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const ImpactMotion motion = impact_motion(plan, VectorXd{{0.9 * high, high, high + 2e-3}});
  ASSERT_EQ(motion.contact.touches.size(), 1u);
  EXPECT_NEAR(motion.contact.touches[0].start, high, 1e-12);
  for (const int k : {0, 1}) {
    const double t = k == 0 ? 0.9 * high : high;
    EXPECT_LT(motion.states[static_cast<size_t>(k)].Q.angularDistance(flight.at(t).orientation), 1e-12);
    EXPECT_EQ(motion.states[static_cast<size_t>(k)].L, plan.start.L);
  }
  const Vector3d J = motion.contact.touches[0].impulse, turned = motion.states[2].L - plan.start.L;
  const Pose pose = flight.at(high);
  const Vector3d corner = pose.orientation * support_point(block, pose.orientation.conjugate() * Vector3d(0, 0, -1));
  ASSERT_GT(J.z(), 0.5 * body.mass);
  EXPECT_LT((turned - corner.cross(J)).norm(), 0.05 * turned.norm());  // pressed and turned meanwhile by some percent
  EXPECT_NEAR(motion.energy[2], motion.energy[0], 1e-3 * body.mass);
}

// Without flight: steps from t = 0 to the end, exact between contacts whatever the step. One that is held stands.
TEST(Impacts, WhereNoSurfaceTellsAllIsStepped) {
  FloatingBody body = floating(ball, {roots({1e4, 3}), roots({4e4, 0})}, {0, 0, -9.81});
  body.free = false;
  body.weight = VectorXd{{0.5, -0.2}};
  ImpactPlan plan = plan_of(body, ball, testing::random_modes(ball, 1, 2, 1, 3), at_rest(body, {0, 0, 0}),
                            ContactScheme::exact, 1e-3);
  plan.start.p = VectorXd{{0.1, 0.2}};
  plan.flies = false;
  const VectorXd times = VectorXd::LinSpaced(5, 0, 0.4);
  const ImpactMotion motion = impact_motion(plan, times);
  EXPECT_NEAR(static_cast<double>(motion.work.steps), 400, 1);
  ASSERT_EQ(motion.states.size(), 5u);
  const BodyFlight exact(plan.body, plan.start, 0);
  for (Index k = 0; k < 5; ++k) {
    const BodyState& at = motion.states[static_cast<size_t>(k)];
    EXPECT_LT((at.q - exact.at(times[k]).q).norm(), 1e-12 * 2e-3);  // 400 steps of rounding
    EXPECT_EQ(at.c, Vector3d::Zero());
  }
}

TEST(Impacts, WhatIsNoMotionIsRefusedOrReported) {
  ImpactPlan plan = ball_among({ground}, {0, 0, 2 * R}, {0, 0, -1});
  EXPECT_TRUE(impact_motion(plan, VectorXd(0)).states.empty());
  const VectorXd times{{0.1}};
  plan.step = 0;
  EXPECT_THROW(impact_motion(plan, times), std::invalid_argument);
  plan.step = 1e-6;
  plan.body.gravity = {0, 0, -9.81};
  plan.start.v.z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(impact_motion(plan, times), std::invalid_argument);
  plan.start.v.z() = -1;
  plan.body.contacts[0].law.stiffness = 1e300;  // blows up at the first step that presses
  const ImpactMotion blown = impact_motion(plan, times);
  EXPECT_TRUE(blown.status == Status::unstable || blown.status == Status::not_finite) << to_string(blown.status);
  EXPECT_TRUE(blown.states.empty());
}

}  // namespace
}  // namespace mb
