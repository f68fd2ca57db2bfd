#include "modal/contact/next_touch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/geometry/surface_patches.h"
#include "modal/contact/floating_bodies_test.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::floating;
using testing::ground;
using testing::no_modes;
using testing::plan_of;
using testing::random_modes;
using testing::swelling;
using testing::wall;

constexpr double g = 9.81;
const Vector3d down(0, 0, -g);
const Shape ball = Sphere{0.05};

// Only where surfaces are counts: samples and law are not looked at.
ImpactPlan among(const std::vector<RigidSurface>& surfaces, const Shape& shape, const PolynomialBasis& modes,
                 const std::vector<Roots>& frequencies, const BodyState& start, const Vector3d& gravity = down) {
  FloatingBody body = floating(shape, frequencies, gravity);
  for (const RigidSurface& surface : surfaces) body.contacts.push_back({{}, surface, {1e9, 0, {}}});
  return plan_of(body, shape, modes, start, ContactScheme::exact, 1e-5);
}
std::optional<double> touch_of(const ImpactPlan& plan, double end, bool leaving = false, double t0 = 0) {
  const BodyFlight flight(plan.body, plan.start, t0);
  const auto touch = next_touch(plan, flight, end, leaving);
  if (!touch) return std::nullopt;
  EXPECT_TRUE(touch->decided);
  return touch->t;
}
ImpactPlan rigid_ball(const std::vector<RigidSurface>& surfaces, const Vector3d& c, const Vector3d& v,
                      const Vector3d& gravity = down) {
  const FloatingBody body = floating(ball, {}, gravity);
  return among(surfaces, ball, no_modes(ball), {}, at_rest(body, c, v), gravity);
}

// Points all over a surface, edges and corners among them.
std::vector<Vector3d> points_of(const Shape& shape, int n) {
  std::vector<Vector3d> X;
  for (const SurfacePatch& patch : surface_patches(shape))
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) X.push_back(patch.at(i / double(n), j / double(n)).x);
  return X;
}
double least_gap(const ImpactPlan& plan, const BodyFlight& flight, const std::vector<Vector3d>& X, double t) {
  const BodyState at = flight.at(t);
  const PolynomialMap map = plan.geometry.map(at.q);
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3d& x : X)
    for (const SampledContact& contact : plan.body.contacts)
      least = std::min(least, gap_value(contact.surface, at.c + at.Q * map.position(x)));
  return least;
}

// Where it is exact: the root of h + v t - g t^2/2 = R, from 1e-6 s to an hour, with and without weight.
TEST(NextTouch, ComesWhenTheParabolaSays) {
  for (const double h : {1e-6, 1e-3, 0.2, 50.0})
    for (const double v : {-30.0, -1.0, 0.0, 2.0, 400.0}) {
      const double t = v > 0 ? (v + std::sqrt(v * v + 2 * g * h)) / g : 2 * h / (-v + std::sqrt(v * v + 2 * g * h));
      const auto found = touch_of(rigid_ball({ground}, {3, 0, 0.05 + h}, {1, 2, v}), 2 * t);
      ASSERT_TRUE(found) << h << ' ' << v;
      EXPECT_NEAR(*found, t, 1e-12 * std::max(1.0, t)) << h << ' ' << v;
      EXPECT_FALSE(touch_of(rigid_ball({ground}, {3, 0, 0.05 + h}, {1, 2, v}), 0.999 * t));
      if (v >= 0) continue;
      const auto straight = touch_of(rigid_ball({ground}, {3, 0, 0.05 + h}, {1, 2, v}, {0, 0, 0}), 1e3);
      ASSERT_TRUE(straight);
      EXPECT_NEAR(*straight, h / -v, 1e-12 * std::max(1.0, h / -v));
    }
  // The flight need not begin at 0.
  EXPECT_NEAR(touch_of(rigid_ball({ground}, {0, 0, 0.15}, {0, 0, -2}, {0, 0, 0}), 20, false, 7).value(), 7.05, 1e-12);
}

TEST(NextTouch, IsTheEarliestOfAllObstacles) {
  const RigidSurface post{Sphere{0.02}, 0, {{0.3, 0, 0.5}, {1, 0, 0, 0}}}, right = wall({1, 0, 0}, -Vector3d::UnitX());
  const double of_post = (0.3 - 0.07) / 4, of_wall = 0.95 / 4;
  const Vector3d c(0, 0, 0.5), v(4, 0, 0), no_weight = Vector3d::Zero();
  for (const auto& all : {std::vector{post, right, ground}, std::vector{ground, right, post}})
    EXPECT_NEAR(touch_of(rigid_ball(all, c, v, no_weight), 1).value(), of_post, 1e-12);
  EXPECT_NEAR(touch_of(rigid_ball({ground, right}, c, v, no_weight), 1).value(), of_wall, 1e-12);
  EXPECT_FALSE(touch_of(rigid_ball({ground, right, post}, c, v, no_weight), 0.99 * of_post));
  EXPECT_FALSE(touch_of(rigid_ball({}, c, v), 1e6));
  EXPECT_FALSE(touch_of(rigid_ball({ground}, {0, 0, 0.05}, {0, 0, -1}), 0));  // no time for it
}

// A ball that breathes: it touches where c(t) = R + q(t) cos-like, by bisection of that very equation.
TEST(NextTouch, OfABreathingBallIsTheRootOfItsEquation) {
  for (const double omega : {30.0, 900.0, 2e4})
    for (const double v : {-0.2, -3.0, 1.5}) {
      const FloatingBody body = floating(ball, {roots({omega * omega, 0.02 * omega})}, down);
      BodyState start = at_rest(body, {0, 0, 0.08}, {0, 0, v});
      start.q << 0.004, start.p << 0.002 * omega;
      const ImpactPlan plan = among({ground}, ball, swelling(0.05, 1), body.modes, start);
      const auto gap = [&](double t) {
        const double w = omega * std::sqrt(1 - 1e-4), a = 0.01 * omega;
        const double q =
            std::exp(-a * t) * (0.004 * std::cos(w * t) + (0.002 * omega + a * 0.004) / w * std::sin(w * t));
        return 0.08 + v * t - g * t * t / 2 - 0.05 - q;
      };
      double low = 0, high = 0;
      while (gap(high) > 0) low = high, high += 1e-3 / omega;  // thousands a period
      while (low < (low + high) / 2 && (low + high) / 2 < high)
        (gap((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
      const auto found = touch_of(plan, 1);
      ASSERT_TRUE(found) << omega << ' ' << v;
      EXPECT_NEAR(*found, high, 1e-12) << omega << ' ' << v;
    }
}

// Thrown at a ceiling: an apex a nanometre above it, or below. tolerance: 1e-12 of the extent 0.1 m.
TEST(NextTouch, GrazesWithinTheTolerance) {
  const double v = 3, apex = v * v / (2 * g);
  const auto ball_below = [&](double missing) {
    return rigid_ball({wall({0, 0, apex + 0.05 + missing}, -Vector3d::UnitZ())}, {0, 0, 0}, {0.3, 0, v});
  };
  EXPECT_FALSE(touch_of(ball_below(1e-9), 10));
  const double overlap = 1e-9, t = v / g - std::sqrt(2 * overlap / g);
  // m' = 1.4e-4 m/s: the tolerance and 4 roundings of 0.5 m take it that much
  EXPECT_NEAR(touch_of(ball_below(-overlap), 10).value(), t, 6e-13 / std::sqrt(2 * g * overlap));
  const auto at_apex = touch_of(ball_below(0), 10);
  EXPECT_NEAR(at_apex.value_or(v / g), v / g, std::sqrt(2 * 1e-12 / g));  // within rounding of touching or of not
}

// What has just let go touches again when it comes back, not at once; what goes on moving in does at once.
TEST(NextTouch, LeavingIsNoTouch) {
  for (const double overlap : {0.0, 1e-9, 1e-5, 2e-3}) {
    const double v = 2, back = (v + std::sqrt(v * v - 2 * g * overlap)) / g;
    const ImpactPlan up = rigid_ball({ground}, {0, 0, 0.05 - overlap}, {1, 0, v});
    EXPECT_NEAR(touch_of(up, 3, true, 1).value_or(-1), 1 + back, 1e-11) << overlap;
    EXPECT_FALSE(touch_of(up, 1 + 0.99 * back, true, 1)) << overlap;
    const ImpactPlan in = rigid_ball({ground}, {0, 0, 0.05 - overlap}, {1, 0, -v});
    EXPECT_NEAR(touch_of(in, 3, true, 1).value_or(-1), 1, 1e-9) << overlap;
  }
}

TEST(NextTouch, NotANumberIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(touch_of(rigid_ball({ground}, {0, 0, nan}, {0, 0, -1}), 1), std::invalid_argument);
  EXPECT_THROW(touch_of(rigid_ball({ground}, {0, 0, 1}, {0, 0, nan}), 1), std::invalid_argument);
  EXPECT_THROW(touch_of(rigid_ball({ground}, {0, 0, 1}, {0, 0, -1}, {0, 0, nan}), 1), std::invalid_argument);
}

// Any shape in any motion, against brute force in time and over the surface.
class RandomTouches : public ::testing::TestWithParam<int> {
 protected:
  std::mt19937 random{static_cast<unsigned>(100 + GetParam())};
  std::normal_distribution<double> normal;
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
  Vector3d vector() { return {normal(random), normal(random), normal(random)}; }
  Eigen::Quaterniond turn() {
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
  }
  Shape shape() const {
    switch (GetParam() % 4) {
      case 0:
        return Box{{0.1, 0.06, 0.14}};
      case 1:
        return Cylinder{0.04, 0.1};
      case 2:
        return Sphere{0.06};
      default:
        return Superquadric{{0.06, 0.05, 0.08}, 0.7, 1.3};
    }
  }
};

TEST_P(RandomTouches, NoneIsMissedAndAllAreTouches) {
  const Shape body_shape = shape();
  const std::vector<Vector3d> X = points_of(body_shape, 8);
  int n_touches = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const double omega = std::exp(uniform(2, 7));
    const std::vector<Roots> frequencies{roots({omega * omega, uniform(0, 0.1) * omega}), roots({4 * omega * omega, 0}),
                                         roots({30 * omega * omega, 0.5 * omega})};
    const PolynomialBasis modes = random_modes(body_shape, 1 + trial % 3, 3, 1, static_cast<unsigned>(trial));
    const FloatingBody body = floating(body_shape, frequencies, down);
    BodyState start = at_rest(body, {0, 0, uniform(0.15, 0.4)}, {uniform(-1, 1), 0, uniform(-2, 1)});
    start.Q = turn();
    start.L = body.inertia * (5 * vector());
    for (Index i = 0; i < 3; ++i)
      start.q[i] = 1e-3 * normal(random), start.p[i] = 1e-3 * std::sqrt(frequencies[static_cast<size_t>(i)].k);
    std::vector<RigidSurface> obstacles{ground};
    if (trial % 2 == 0) obstacles.push_back({Box{{0.1, 0.1, 0.1}}, 0.01, {{0.15, 0, 0.1}, turn()}});
    const ImpactPlan plan = among(obstacles, body_shape, modes, frequencies, start);
    const BodyFlight flight(plan.body, plan.start, 0);
    if (least_gap(plan, flight, X, 0) < 1e-3) continue;
    const double end = 0.5;
    const auto found = touch_of(plan, end);
    const int n = 300;
    for (int k = 0; k < n; ++k) {
      const double t = found.value_or(end) * k / n;
      EXPECT_GT(least_gap(plan, flight, X, t), 0) << trial << ' ' << t << ' ' << found.value_or(-1);
    }
    if (!found) continue;
    ++n_touches;
    // Neighbouring points of the grid stand at most a sixth of the extent apart, and the nearest of the surface within
    // half of that: on a smooth surface less by its square.
    const double at = least_gap(plan, flight, X, *found);
    EXPECT_GT(at, -1e-10);
    EXPECT_LT(at, 0.03 * extent(body_shape)) << trial;
  }
  EXPECT_GE(n_touches, 4);
}
INSTANTIATE_TEST_SUITE_P(Shapes, RandomTouches, ::testing::Range(0, 8));

}  // namespace
}  // namespace mb
