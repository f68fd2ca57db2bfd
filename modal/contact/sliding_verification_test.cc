// A rigid block slides on a plane, against closed forms of Coulomb's friction as mechanics/contact/law.h regularises
// it, v' = g_t - mu g_n v/sqrt(|v|^2 + v_eps^2), g_t and g_n the parts of gravity along the plane and on to it.
//
// It starts in balance, so that nothing bounces: pressed by d, k_n A d = m g_n, and against the couple of friction,
// which acts h below the centroid, tilted by theta, to the first order of its 4e-7,
//
//   k_n I theta = mu s k_n A d h,   s = |v|/sqrt(|v|^2 + v_eps^2),   I = A l^2/12
//
// All of the face presses while mu h < l/6. Where s changes, the block rocks by about theta: that is what is left of
// the differences below, and falls as 1/k_n.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/verified_test.h"
#include "modal/contact/floating_bodies_test.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::floating;
using testing::ground;
using testing::no_modes;
using testing::plan_of;
using testing::samples_of;

constexpr double g = 9.81, k_n = 1e9, mu = 0.3;  // [m/s^2], [Pa/m], [-]
constexpr double l = 0.12, h = 0.01;             // [m] edges of the square face; the centroid above it
constexpr double sharp = 1e-5;                   // [m/s] v_eps that hardly counts
constexpr double step = 1e-4;                    // [s] 0.7 of a radian of bouncing on the layer
const Shape block = Box{Vector3d(l, l, 2 * h)};

// On the plane z = 0, which falls along x at an angle a [rad]. v [m/s] lies in it.
ImpactPlan on_slope(double a, const Vector3d& v, double slip_speed, ContactScheme scheme) {
  FloatingBody body = floating(block, {}, g * Vector3d(std::sin(a), 0, -std::cos(a)));
  body.contacts.push_back(
      {samples_of(block, no_modes(block), {0.02, 0.02, 0, 2}), ground, {k_n, 0, Friction{mu, slip_speed}}});
  const double depth = body.mass * g * std::cos(a) / (k_n * l * l);
  const Vector3d sliding = v / std::sqrt(v.squaredNorm() + slip_speed * slip_speed);
  const Vector3d tilt = 12 * mu * depth * h / (l * l) * Vector3d::UnitZ().cross(sliding);
  BodyState start = at_rest(body, {0, 0, h - depth}, v);
  if (tilt.norm() > 0) start.Q = Eigen::AngleAxisd(tilt.norm(), tilt.normalized());
  return plan_of(body, block, no_modes(block), start, scheme, step);
}

class SlidingVerification : public ::testing::TestWithParam<ContactScheme> {};

// v' = g (sin a -+ mu cos a), down and up. Left out is (v_eps/v)^2/2 of the friction, 1e-10; both schemes are exact
// under constant forces.
TEST_P(SlidingVerification, AcceleratesByGravityLessFriction) {
  const double a = 0.5;
  for (const double v0 : {1.0, -1.0}) {
    const ImpactPlan plan = on_slope(a, {v0, 0, 0}, sharp, GetParam());
    const double friction = mu * g * std::cos(a), rate = g * std::sin(a) - std::copysign(friction, v0);
    const VectorXd times = VectorXd::LinSpaced(11, 0, 0.1);  // upwards it comes to a stop at 0.14 s
    const ImpactMotion motion = impact_motion(plan, times);
    ASSERT_EQ(motion.status, Status::ok);
    for (Index k = 0; k < times.size(); ++k) {
      const double t = times[k];
      const BodyState& at = motion.states[static_cast<size_t>(k)];
      EXPECT_NEAR(at.v.x(), v0 + rate * t, 1e-9) << t;
      EXPECT_NEAR(at.c.x(), v0 * t + rate * t * t / 2, 1e-10) << t;
      EXPECT_LT((at.c - plan.start.c).tail<2>().norm(), 1e-10) << t;  // it does not bounce: 1e-4 of the depth
      // What friction takes: of order 1 in the closed form, whose power is that of the rates before the second kick.
      const double lost = plan.body.mass * friction * std::abs(at.c.x());
      EXPECT_NEAR(motion.contact.dissipated[k], lost, 1e-3 * lost + 1e-12) << t;
    }
  }
}

// Thrown across a slope of tan a = mu, it loses as much of |v| as it gains of v_x: |v| + v_x = v0, until it falls
// straight at v0/2. With u = v_y/(|v| + v_x),   ln(1/u) + (1 - u^2)/2 = 2 g sin a t/v0.
TEST_P(SlidingVerification, TurnsDownTheSlope) {
  const double a = std::atan(mu), v0 = 0.2, T = 0.3;
  const VectorXd times = VectorXd::LinSpaced(11, 0, T);
  const ImpactMotion motion = impact_motion(on_slope(a, {0, v0, 0}, sharp, GetParam()), times);
  ASSERT_EQ(motion.status, Status::ok);
  for (Index k = 0; k < times.size(); ++k) {
    const Vector3d& v = motion.states[static_cast<size_t>(k)].v;
    const double u = v.y() / (v.norm() + v.x());
    EXPECT_NEAR(v.norm() + v.x(), v0, 1e-5 * v0) << times[k];  // 1e-6 at this stiffness
    EXPECT_NEAR(std::log(1 / u) + (1 - u * u) / 2, 2 * g * std::sin(a) / v0 * times[k], 3e-5) << times[k];  // 5e-6
  }
  EXPECT_NEAR(motion.states.back().v.x(), v0 / 2, 1e-5 * v0);
}

// Where the slope is not steep enough, mu g cos a s = g sin a: it sticks, which is creep at v = v_eps s/sqrt(1 - s^2),
// s = tan a/mu, whether it starts at that speed or at rest. Exact steps look at the rates before the second kick: half
// a step of the other forces above what they hand over.
TEST_P(SlidingVerification, SticksByCreeping) {
  const double a = 0.2, slip_speed = 1e-2, s = std::tan(a) / mu, v = slip_speed * s / std::sqrt(1 - s * s);
  const double seen = GetParam() == ContactScheme::exact ? v - step / 2 * g * std::sin(a) : v;
  ASSERT_LT(std::abs(seen / v - 1), 0.011);  // order 1, see contact_step.h
  const VectorXd times = VectorXd::LinSpaced(3, 0, 0.2);
  const ImpactMotion steady = impact_motion(on_slope(a, {v, 0, 0}, slip_speed, GetParam()), times);
  const ImpactMotion begun = impact_motion(on_slope(a, Vector3d::Zero(), slip_speed, GetParam()), times);
  ASSERT_EQ(steady.status, Status::ok);
  ASSERT_EQ(begun.status, Status::ok);
  EXPECT_NEAR(steady.states[2].v.x(), seen, 1e-6 * v);
  EXPECT_NEAR((steady.states[2].c - steady.states[1].c).x(), 0.1 * seen, 1e-6 * 0.1 * v);
  EXPECT_NEAR(begun.states[2].v.x(), seen, 1e-4 * v);  // it rocks; e^-23 of the start is left
  EXPECT_NEAR((begun.states[2].c - begun.states[1].c).x(), 0.1 * seen, 1e-4 * 0.1 * v);
}

// On the level through all of the law: F(v0) - F(v) = mu g t,   F = sqrt(v^2 + v_eps^2) - v_eps asinh(v_eps/v).
// dF = v_eps dv/v in the end: compared by v_eps, it is the relative error of the speed.
TEST_P(SlidingVerification, StopsOnTheLevel) {
  const double v_eps = 0.05, v0 = 0.5;
  const auto F = [&](double v) { return std::hypot(v, v_eps) - v_eps * std::asinh(v_eps / v); };
  const VectorXd times = VectorXd::LinSpaced(11, 0, 0.25);
  const ImpactMotion motion = impact_motion(on_slope(0, {v0, 0, 0}, v_eps, GetParam()), times);
  ASSERT_EQ(motion.status, Status::ok);
  ASSERT_LT(motion.states.back().v.x(), 0.01 * v_eps);
  // 3.6e-5 by rocking; exact steps of order 1: mu g/v_eps (0.25 s - 0.15 s) = 6 decays by h mu g/(2 v_eps) = 0.3 % each
  const bool exact_steps = GetParam() == ContactScheme::exact;
  const double tolerance = exact_steps ? 0.02 : 1e-4;
  double worst = 0;
  for (Index k = 0; k < times.size(); ++k) {
    const double v = motion.states[static_cast<size_t>(k)].v.x();
    EXPECT_NEAR(F(v0) - F(v), mu * g * times[k], tolerance * v_eps) << times[k];
    worst = std::max(worst, std::abs(F(v0) - F(v) - mu * g * times[k]) / v_eps);
  }
  testing::expect_verified(
      {.quantity = "speed of a block that slides to rest on the level, by the integral of its "
                   "friction law over the law's slip speed",
       .reference = "exact solution",
       .source = "separation of variables in Coulomb's law as mechanics/contact/law.h regularises it",
       .uncertainty = "rounding",
       .tolerance = tolerance,
       .why = exact_steps ? "With friction these steps are of order 1: six decays by 0.3 % each."
                          : "The block rocks on its layer as friction falls, by 3.6e-5 as seen."},
      worst);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SlidingVerification, ::testing::Values(ContactScheme::newmark, ContactScheme::exact),
                         [](const auto& scheme) {
                           return std::string(scheme.param == ContactScheme::exact ? "Exact" : "Newmark");
                         });

}  // namespace
}  // namespace mb
