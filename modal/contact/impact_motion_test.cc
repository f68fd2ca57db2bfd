#include "modal/contact/impact_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
using testing::swelling;
using testing::wall;

constexpr double R = 0.05, g = 9.81, k_n = 1e11;  // [m], [m/s^2], [Pa/m]
const Shape ball = Sphere{R};
const Vector3d down(0, 0, -g);

// Its surface, fine where it comes down.
SurfaceSamples samples(const PolynomialBasis& modes) {
  return samples_of(ball, modes, {R / 60, R / 4, 0.2, 2}, {{0, 0, -R}});
}

// A rigid ball above walls.
ImpactPlan ball_above(const std::vector<RigidSurface>& walls, const Vector3d& c, const Vector3d& v, double step,
                      const Vector3d& gravity = down, ContactScheme scheme = ContactScheme::exact, double damping = 0) {
  FloatingBody body = floating(ball, {}, gravity);
  for (const RigidSurface& surface : walls)
    body.contacts.push_back({samples(no_modes(ball)), surface, {k_n, damping, {}}});
  return plan_of(body, ball, no_modes(ball), at_rest(body, c, v), scheme, step);
}

// Depth [m] >= 0 of the lowest point and its rate; the samples of the ball against the plane z = 0, no more.
struct Bounce {
  const FloatingBody& body;
  double force(double height) const {
    const SurfaceSamples& s = body.contacts[0].samples;
    double f = 0;
    for (Index i = 0; i < s.w.size(); ++i) f += s.w[i] * k_n * std::max(0.0, -(height + s.X(2, i)));
    return f;
  }
  // Classical Runge-Kutta of order 4: height and its rate after a time.
  Eigen::Vector2d after(Eigen::Vector2d y, double time, int n) const {
    const auto rate = [&](const Eigen::Vector2d& x) {
      return Eigen::Vector2d(x[1], body.gravity.z() + force(x[0]) / body.mass);
    };
    const double h = time / n;
    for (int i = 0; i < n; ++i) {
      const Eigen::Vector2d a = rate(y), b = rate(y + h / 2 * a), c = rate(y + h / 2 * b), d = rate(y + h * c);
      y += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return y;
  }
};

// What stands in closed form is exact for ever: 200 s of flight as well as 1 s.
TEST(ImpactMotion, FliesInClosedForm) {
  for (const double v : {0.5, 30.0, 1000.0}) {
    const double start = R + 0.3, T = (v + std::sqrt(v * v + 2 * g * 0.3)) / g;  // of the touch
    const VectorXd times = VectorXd::LinSpaced(41, 0, 0.999 * T);
    const ImpactMotion motion = impact_motion(ball_above({ground}, {1, 2, start}, {3, -1, v}, 1e-5), times);
    ASSERT_EQ(motion.states.size(), 41u);
    EXPECT_EQ(motion.work.steps, 0);
    for (Index k = 0; k < times.size(); ++k) {
      const double t = times[k], size = start + v * t + g * t * t / 2;  // of what is added up
      const BodyState& at = motion.states[static_cast<size_t>(k)];
      EXPECT_NEAR((at.c - Vector3d(1 + 3 * t, 2 - t, start + v * t - g * t * t / 2)).norm(), 0, 1e-14 * size + 1e-14);
      EXPECT_NEAR(at.v.z(), v - g * t, 1e-14 * (v + g * t));
      EXPECT_NEAR(motion.energy[k], motion.energy[0], 1e-12 * motion.energy[0]);
      EXPECT_EQ(motion.contact.force.col(k), Vector3d::Zero());
    }
    EXPECT_TRUE(motion.contact.touches.empty());
    const double end = T + 1e-4;
    const ImpactMotion touched = impact_motion(ball_above({ground}, {1, 2, start}, {3, -1, v}, 1e-5), VectorXd{{end}});
    ASSERT_EQ(touched.contact.touches.size(), 1u);
    EXPECT_NEAR(touched.contact.touches[0].start, T, 1e-12 * std::max(T, 1.0));
  }
}

// By Archimedes a sphere's band of height dz has the area 2 pi R dz: F = int_0^d k_n (d - z) 2 pi R dz = pi R k_n d^2,
// and without weight m v^2/2 = pi R k_n d^3/3 at the deepest. Samples carry this to the square of their distance.
TEST(ImpactMotionVerification, ABallPressesWithTheSquareOfItsDepth) {
  const double v = 2;
  ImpactPlan plan = ball_above({ground}, {0, 0, R}, {0, 0, -v}, 1e-6, Vector3d::Zero());
  plan.body.contacts[0].samples = samples_of(ball, no_modes(ball), {R / 200, R / 6, 0.1, 3}, {{0, 0, -R}});
  const double m = plan.body.mass, deepest = std::cbrt(1.5 * m * v * v / (pi * R * k_n));
  // int_0^1 dx / sqrt(1 - x^3), B(1/3, 1/2)/3
  const double T = 2 * deepest / v * std::beta(1.0 / 3, 0.5) / 3;
  const ImpactMotion motion = impact_motion(plan, VectorXd{{T / 2, 2 * T}});
  ASSERT_EQ(motion.contact.touches.size(), 1u);
  const Touch& touch = motion.contact.touches[0];
  const double peak = pi * R * k_n * deepest * deepest;
  EXPECT_NEAR(touch.peak_force, peak, 1e-4 * touch.peak_force);
  EXPECT_NEAR(touch.end - touch.start, T, 2e-4 * T);
  EXPECT_NEAR(touch.peak_time, T / 2, 2e-4 * T);
  EXPECT_NEAR(R - motion.states[0].c.z(), deepest, 2e-4 * deepest);
  EXPECT_NEAR(touch.impulse.z(), 2 * m * v, 1e-6 * m * v);
  EXPECT_NEAR(motion.contact.stored[0], m * v * v / 2, 1e-4 * m * v * v);
  testing::expect_verified(
      {.quantity = "greatest force of a rigid ball on a penalty layer, relative",
       .reference = "exact solution",
       .source = "Archimedes's zones of a sphere and the energy integral, in closed form",
       .uncertainty = "rounding",
       .tolerance = 1e-4,
       .why = "Sums over samples err where the rim of the contact, 0.15 R in radius, cuts between them: R/200 apart "
              "there, and to the square of that."},
      touch.peak_force / peak - 1);
}

// The same samples in an integrator of our own, with steps so small that nothing but the scheme's error is left.
TEST(ImpactMotion, ConvergesToTheBounceWithTheOrderOfItsScheme) {
  const double v = 2, T = 5e-4;
  const auto motion = [&](ContactScheme scheme, int n) {
    const ImpactPlan plan = ball_above({ground}, {0, 0, R + 1e-3}, {0, 0, -v}, T / n, down, scheme);
    const double t1 = (std::sqrt(v * v + 2 * g * 1e-3) - v) / g;
    return impact_motion(plan, VectorXd{{t1 + T}}).states[0];
  };
  const ImpactPlan plan = ball_above({ground}, {0, 0, R + 1e-3}, {0, 0, -v}, T);
  const Eigen::Vector2d truth = Bounce{plan.body}.after({R, -std::sqrt(v * v + 2 * g * 1e-3)}, T, 20000);
  ASSERT_GT(truth[1], 0);  // it is on its way back
  for (const auto& [scheme, order] : {std::pair{ContactScheme::exact, 2.0},
                                      {ContactScheme::newmark, 2.0},
                                      {ContactScheme::central_difference, 2.0},
                                      {ContactScheme::symplectic_euler, 1.0}}) {
    const auto error = [&](int n) {
      const BodyState end = motion(scheme, n);
      EXPECT_LT(end.c.head(2).norm() + end.L.norm(), 1e-9);
      return std::abs(end.v.z() - truth[1]) / v;
    };
    const double coarse = error(100), fine = error(400);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(4), order, 0.2);  // samples that begin to press are kinks
    EXPECT_LT(fine, order == 2 ? 1e-4 : 1e-2);
  }
}

// A ball that vibrates, spins and is hit off its middle.
ImpactPlan vibrating_ball(double step, ContactScheme scheme, double damping = 0, double loss = 0) {
  const PolynomialBasis modes = testing::random_modes(ball, 2, 3, 0.8, 5);
  FloatingBody body = floating(ball, {roots({4e6, loss * 80}), roots({9e6, loss * 100}), roots({2.5e7, 0})}, down);
  body.contacts.push_back({samples(modes), ground, {k_n, damping, {}}});
  BodyState start = at_rest(body, {0, 0, R + 2e-3}, {0.4, 0, -2});
  start.L = {2e-3, 5e-3, -1e-3};
  start.p = VectorXd{{0.03, -0.02, 0.01}};
  return plan_of(body, ball, modes, start, scheme, step);
}

// Momentum at every time asked for, in flight and in contact: m v = m v0 + m g t + impulse. The floor without friction
// has no torque along its normal, whatever deforms.
TEST(ImpactMotion, ImpulsesAreWhatMomentumChangesBy) {
  for (const auto scheme : {ContactScheme::exact, ContactScheme::newmark, ContactScheme::symplectic_euler,
                            ContactScheme::central_difference}) {
    const ImpactPlan plan = vibrating_ball(5e-7, scheme, 0.05, 1);
    const VectorXd times = VectorXd::LinSpaced(257, 0, 3e-3);
    const ImpactMotion motion = impact_motion(plan, times);
    ASSERT_EQ(motion.status, Status::ok);
    ASSERT_GE(motion.contact.touches.size(), 1u);
    const double J = motion.contact.impulse.col(256).norm(), m = plan.body.mass;
    ASSERT_GT(J, 2 * m);                                            // it is thrown back
    ASSERT_GT((motion.states[256].L - plan.start.L).norm(), 1e-5);  // and turned
    for (Index k = 0; k < times.size(); ++k) {
      const BodyState& at = motion.states[static_cast<size_t>(k)];
      const Vector3d change = m * (at.v - plan.start.v - times[k] * down);
      EXPECT_LT((change - motion.contact.impulse.col(k)).norm(), 1e-10 * J) << times[k];
      EXPECT_NEAR(at.L.z(), plan.start.L.z(), 1e-12 * plan.start.L.norm());
    }
    Vector3d all = Vector3d::Zero();
    for (const Touch& touch : motion.contact.touches) all += touch.impulse;
    EXPECT_LT((all - motion.contact.impulse.col(256)).norm(), 1e-12 * J);
  }
}

// Energy, with what the layer holds and has lost, is kept but for h^2, in contact and after it, with losses and
// without.
TEST(ImpactMotion, EnergyErrorFallsWithTheSquareOfTheStep) {
  const VectorXd times = VectorXd::LinSpaced(101, 0, 2.5e-3);
  for (const double damping : {0.0, 0.05})
    for (const auto scheme : {ContactScheme::exact, ContactScheme::newmark, ContactScheme::central_difference}) {
      const auto error = [&](double h) {
        const ImpactMotion motion = impact_motion(vibrating_ball(h, scheme, damping), times);
        EXPECT_EQ(motion.status, Status::ok);
        const double start = motion.energy[0], lost = motion.contact.dissipated[100];
        EXPECT_TRUE(damping == 0 ? lost == 0 : lost > 0.01 * start);
        return ((motion.energy + motion.contact.dissipated).array() - start).abs().maxCoeff() / start;
      };
      const double coarse = error(1.6e-5), fine = error(2e-6), order = std::log(coarse / fine) / std::log(8);
      if (damping > 0 && scheme != ContactScheme::newmark) {
        EXPECT_GT(order, 0.9);  // the layer's losses are found with the rates before the second kick
        EXPECT_LT(fine, 1e-3);
      } else {
        EXPECT_NEAR(order, 2, 0.3) << damping;  // samples that begin to press are kinks
        EXPECT_LT(fine, 1e-4);
      }
    }
}

// Ten and a thousand times the way make not one step more, nor one contact evaluated: what is left is one look at the
// closed form for the one time asked for.
TEST(ImpactMotion, TakesNoStepInFlight) {
  const double v = 3;
  std::vector<Work> works;
  for (const double height : {0.004, 0.04, 0.4, 4.0}) {
    const double up = v * v - 2 * g * height;  // of the speed at the start, that all arrive at v
    const double start = up > 0 ? -std::sqrt(up) : std::sqrt(v * v + 2 * g * height);
    const double H = up > 0 ? height : 1e-3 * height;
    const double thrown = up > 0 ? start : std::sqrt(v * v - 2 * g * H), flight = (thrown + v) / g;
    const ImpactPlan plan = ball_above({ground}, {0, 0, R + H}, {0, 0, thrown}, 1e-6);
    const ImpactMotion motion = impact_motion(plan, VectorXd{{flight + 1e-3}});
    ASSERT_EQ(motion.contact.touches.size(), 1u);
    EXPECT_NEAR(motion.contact.touches[0].start, flight, 1e-12);
    EXPECT_LT(motion.contact.touches[0].end, flight + 1e-3);
    works.push_back(motion.work);
  }
  ASSERT_GT(works[0].steps, 50);
  for (const Work& work : works) {
    EXPECT_NEAR(static_cast<double>(work.steps), static_cast<double>(works[0].steps), 1);  // a rounding of the touch
    EXPECT_EQ(work.load_evaluations - work.steps, 3);  // the touch, its first load, the end
  }
}

// At its equilibrium it stays: ten thousand steps move it by roundings. Let go at the surface it swings about that
// without gain, h omega being 0.02, and damped it comes to rest there.
TEST(ImpactMotion, RestsWithoutJitter) {
  const double h = 2e-5;
  ImpactPlan plan = ball_above({ground}, {0, 0, R}, Vector3d::Zero(), h);
  const Bounce bounce{plan.body};
  const double weight = plan.body.mass * g;
  double low = R - 1e-4, high = R;
  while (low < (low + high) / 2 && (low + high) / 2 < high)
    (bounce.force((low + high) / 2) > weight ? low : high) = (low + high) / 2;
  const double depth = R - high;
  ASSERT_GT(depth, 1e-6);
  const VectorXd times = VectorXd::LinSpaced(501, 0, 1e4 * h);
  for (const auto scheme : {ContactScheme::exact, ContactScheme::newmark, ContactScheme::symplectic_euler,
                            ContactScheme::central_difference}) {
    plan.scheme = scheme;
    plan.start.c.z() = high;
    const ImpactMotion still = impact_motion(plan, times);
    EXPECT_EQ(still.status, Status::ok);
    EXPECT_GE(still.work.steps, 9999);
    for (const BodyState& at : still.states) {
      EXPECT_NEAR(at.c.z(), high, 1e-10 * depth);
      EXPECT_LT(at.L.norm() + at.c.head(2).norm(), 1e-12);
    }
    plan.start.c.z() = R;
    const ImpactMotion swinging = impact_motion(plan, times);
    ASSERT_EQ(swinging.contact.touches.size(), 1u);
    EXPECT_EQ(swinging.contact.touches[0].start, 0);
    EXPECT_LT((swinging.energy.array() - swinging.energy[0]).abs().maxCoeff(), 0.02 * weight * depth);
    plan.body.contacts[0].law.damping = 20;
    const ImpactMotion damped = impact_motion(plan, times);
    plan.body.contacts[0].law.damping = 0;
    EXPECT_NEAR(damped.states.back().c.z(), high, 0.1 * depth);
    EXPECT_LT((damped.energy.array() - damped.energy[0]).maxCoeff(), 1e-4 * weight * depth);
    EXPECT_NEAR(damped.energy[500] + damped.contact.dissipated[500], damped.energy[0], 0.02 * weight * depth);
  }
}

}  // namespace
}  // namespace mb
