// First touch against closed forms and against roots of equations that are found here by themselves, in long double.
// Tolerances in seconds: 1e-14, some ten roundings of times below a second and of gaps below a metre at metres a
// second.
#include "mechanics/contact/first_touch.h"

#include <gtest/gtest.h>

#include <functional>

#include "mechanics/contact/first_touch_test_motions.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using Real = long double;
using RealMatrix = Eigen::Matrix<Real, 3, 3>;
using RealVector = Eigen::Matrix<Real, 3, 1>;

const RigidSurface table{HalfSpace{}, 0, {}};
const Vector3d down(0, 0, -9.81);

// The first root of f, positive at 0, by small steps (halved where f comes close) and bisection to rounding.
double first_root(const std::function<Real(Real)>& f, Real end, int n_steps = 200000) {
  Real a = 0, b = 0;
  while (b < end && f(b) > 0) a = b, b += end / n_steps;
  if (b >= end) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 200 && a < (a + b) / 2 && (a + b) / 2 < b; ++i) (f((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
  return static_cast<double>(a);
}

// Of TestMotion in long double (Rodrigues).
RealMatrix rotation(const TestMotion& m, Real t) {
  const RealVector spin = m.spin.cast<Real>();
  const Real rate = spin.norm();
  const RealMatrix Q0 = m.orientation.cast<Real>().toRotationMatrix();
  if (rate == 0) return Q0;
  const RealVector e = spin / rate;
  RealMatrix K;
  K << 0, -e[2], e[1], e[2], 0, -e[0], -e[1], e[0], 0;
  return (RealMatrix::Identity() + std::sin(rate * t) * K + (1 - std::cos(rate * t)) * K * K) * Q0;
}
RealVector centre(const TestMotion& m, Real t) {
  return m.position.cast<Real>() + t * m.velocity.cast<Real>() + t * t / 2 * m.gravity.cast<Real>();
}

void expect_hit(const Shape& shape, const TestMotion& motion, const RigidSurface& obstacle, double expected,
                double tolerance = 1e-14, double t1 = 1, double* worst = nullptr) {
  const auto touch = first_touch(shape, motion, obstacle, {0, t1});
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->kind, FirstTouch::hit);
  EXPECT_NEAR(touch->t, expected, tolerance);
  if (worst) *worst = std::max(std::abs(touch->t - expected), *worst);
  EXPECT_NEAR(touch->gap, 0, 1e-14);
  EXPECT_NEAR(gap_value(obstacle, touch->x), touch->gap, 1e-16);
  EXPECT_EQ((motion.place(touch->X, touch->t) - touch->x).norm(), 0);
  EXPECT_LT(touch->bracket, 1e-11);
}

TEST(FirstTouchVerification, ADroppedSphereTakesTheRootOfTwiceTheHeightOverG) {
  const Shape ball = Sphere{0.05};
  TestMotion m(ball);
  m.position = {0.3, -0.2, 1.05}, m.gravity = down;
  expect_hit(ball, m, table, std::sqrt(2 / 9.81), 1e-15);
  m.spin = {30, 20, 10};
  expect_hit(ball, m, table, std::sqrt(2 / 9.81), 1e-15);
}

// The lowest point of a turning body by its support function.
TEST(FirstTouchVerification, TurningBodiesMeetTheTableWhereTheirLowestPointDoes) {
  struct Case {
    Shape shape;
    std::function<Real(const RealVector&)> reach;  // of the unit vector e_z in the body's axes
  };
  const auto box = [](const RealVector& n) {
    return 0.05L * std::abs(n[0]) + 0.1L * std::abs(n[1]) + 0.15L * std::abs(n[2]);
  };
  const auto rod = [](const RealVector& n) { return 0.05L * std::hypot(n[0], n[1]) + 0.1L * std::abs(n[2]); };
  const auto egg = [](const RealVector& n) {
    return std::sqrt(0.01L * n[0] * n[0] + 0.0025L * n[1] * n[1] + 0.04L * n[2] * n[2]);
  };
  for (const Case& c : {Case{Box{{0.1, 0.2, 0.3}}, box}, Case{Cylinder{0.05, 0.2}, rod},
                        Case{Superquadric{{0.1, 0.05, 0.2}, 1, 1}, egg}})
    for (const double rate : {0.5, 7.0, 60.0, 500.0}) {
      TestMotion m(c.shape);
      m.position = {0, 0, 1}, m.velocity = {0.2, 0.1, 0.3}, m.gravity = down;
      m.orientation = Eigen::Quaterniond(0.9, 0.2, -0.3, 0.1).normalized();
      m.spin = rate * Vector3d(0.6, -0.7, 0.3).normalized();
      const auto height = [&](Real t) { return centre(m, t)[2] - c.reach(rotation(m, t).transpose().col(2)); };
      expect_hit(c.shape, m, table, first_root(height, 1));
    }
}

// (R1 + R2)^2 = |c(t)|^2, a quartic in t.
TEST(FirstTouchVerification, SpheresMeetAtTheRootOfAQuartic) {
  const Shape ball = Sphere{0.05};
  const RigidSurface obstacle{Shape(Sphere{0.1}), 0, {}};
  for (const double x : {0.0, 0.03, 0.1, 0.149}) {
    TestMotion m(ball);
    m.position = {x, 0, 1}, m.velocity = {0, 0, 1}, m.gravity = down, m.spin = {5, 3, 1};
    const auto excess = [&](Real t) { return centre(m, t).squaredNorm() - 0.0225L; };
    expect_hit(ball, m, obstacle, first_root(excess, 1), 1e-14);
  }
}

// Distances of a sphere's centre from sharp and rounded obstacles, each by its own formula.
TEST(FirstTouchVerification, SpheresMeetFacesEdgesCornersAndRims) {
  struct Case {
    RigidSurface obstacle;
    Vector3d above;
    std::function<Real(const RealVector&)> distance;
  };
  const auto to_rim = [](Real R, Real h) {
    return [=](const RealVector& c) { return std::hypot(std::hypot(c[0], c[1]) - R, c[2] - h); };
  };
  const RigidSurface box{Shape(Box{{0.2, 0.2, 0.2}}), 0, {}}, disc{Shape(Cylinder{0.1, 0.04}), 0, {}};
  const RigidSurface worn{Shape(Box{{0.2, 0.2, 0.2}}), 0.02, {}}, wheel{Shape(Cylinder{0.1, 0.04}), 0.01, {}};
  const RigidSurface roller{
      Shape(Cylinder{0.1, 1}), 0, {{0, 0, 0}, Eigen::Quaterniond(std::sqrt(0.5), std::sqrt(0.5), 0, 0)}};
  const std::vector<Case> cases = {
      {box, {0.03, 0.02, 1}, [](const RealVector& c) { return c[2] - 0.1L; }},
      {box, {0.12, 0.02, 1}, [](const RealVector& c) { return std::hypot(c[0] - 0.1L, c[2] - 0.1L); }},
      {box, {0.12, 0.11, 1}, [](const RealVector& c) { return (c - RealVector(0.1L, 0.1L, 0.1L)).norm(); }},
      {worn, {0.12, 0.02, 1}, [](const RealVector& c) { return std::hypot(c[0] - 0.08L, c[2] - 0.08L) - 0.02L; }},
      {worn, {0.12, 0.11, 1}, [](const RealVector& c) { return (c - RealVector(0.08L, 0.08L, 0.08L)).norm() - 0.02L; }},
      {disc, {0.09, 0.08, 1}, to_rim(0.1L, 0.02L)},
      {wheel, {0.09, 0.08, 1}, [&](const RealVector& c) { return to_rim(0.09L, 0.01L)(c) - 0.01L; }},
      {roller, {0.06, 0.02, 1}, [](const RealVector& c) { return std::hypot(c[0], c[2]) - 0.1L; }}};
  const Shape ball = Sphere{0.05};
  for (const Case& c : cases) {
    TestMotion m(ball);
    m.position = c.above, m.gravity = down;
    expect_hit(ball, m, c.obstacle, first_root([&](Real t) { return c.distance(centre(m, t)) - 0.05L; }, 1));
  }
}

// Boxes that turn about the y axis only, both long along it: rectangles in the x-z plane, of which a corner of the one
// meets the other.
TEST(FirstTouchVerification, SpinningBoxesClipCorners) {
  const auto to_rectangle = [](Real x, Real z, Real a, Real b) {
    const Real u = std::abs(x) - a, v = std::abs(z) - b;
    return u > 0 && v > 0 ? std::hypot(u, v) : std::max(u, v);
  };
  const Shape body = Box{{0.1, 1, 0.3}};
  const RigidSurface obstacle{Shape(Box{{0.2, 1, 0.1}}), 0, {}};
  for (const double rate : {-80.0, 3.0, 80.0, 400.0})
    for (const double x : {-0.2, 0.1, 0.22}) {
      TestMotion m(body);
      m.position = {x, 0.01, 1}, m.velocity = {0.1, 0, -2}, m.gravity = down, m.spin = {0, rate, 0};
      const auto gap = [&](Real t) {
        const RealMatrix Q = rotation(m, t);
        const RealVector c = centre(m, t);
        Real least = 1;
        for (const Real s : {-1.0L, 1.0L})
          for (const Real u : {-1.0L, 1.0L}) {
            const RealVector corner = c + Q * RealVector(0.05L * s, 0, 0.15L * u);
            const RealVector other = Q.transpose() * (RealVector(0.1L * s, c[1], 0.05L * u) - c);
            least = std::min({least, to_rectangle(corner[0], corner[2], 0.1L, 0.05L),
                              to_rectangle(other[0], other[2], 0.05L, 0.15L)});
          }
        return least;
      };
      const double expected = first_root(gap, 0.5L);
      if (std::isfinite(expected)) {
        expect_hit(body, m, obstacle, expected, 3e-14);  // normals between edges come from rounded points
      } else {
        EXPECT_FALSE(first_touch(body, m, obstacle, {0, 0.5}));
      }
    }
}

// Two boxes are apart as long as one of 15 axes separates them: the normals of their faces, and the products of their
// edges (Gottschalk, Lin & Manocha 1996, SIGGRAPH). The greatest separation is 0 when they touch, also edge on edge.
TEST(FirstTouchVerification, BoxesMeetWhenNoAxisSeparatesThem) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> size(0.02, 0.2);
  const auto vector = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
  const auto turn = [&] {
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
  };
  int hits = 0, edges = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Vector3d a(size(random), size(random), size(random)), b(size(random), size(random), size(random));
    const RigidSurface obstacle{Shape(Box{b}), 0, {0.1 * vector(), turn()}};
    TestMotion m(Box{a});
    m.orientation = turn(), m.spin = 5 * vector(), m.velocity = 2 * vector(), m.gravity = down;
    m.position = obstacle.pose.position - 0.5 * m.velocity - 0.125 * down + 0.04 * vector();
    const RealMatrix B = obstacle.pose.orientation.cast<Real>().normalized().toRotationMatrix();
    int axis_of_touch = 0;
    const auto separation = [&](Real t) {
      const RealMatrix A = rotation(m, t);
      const RealVector between = centre(m, t) - obstacle.pose.position.cast<Real>();
      Real greatest = -1;
      const auto look = [&](const RealVector& axis, int number) {
        const Real length = axis.norm();
        if (length < 1e-6L) return;
        const Real reach = (A.transpose() * axis).cwiseAbs().dot(a.cast<Real>()) / 2 +
                           (B.transpose() * axis).cwiseAbs().dot(b.cast<Real>()) / 2;
        const Real apart = (std::abs(axis.dot(between)) - reach) / length;
        if (apart > greatest) greatest = apart, axis_of_touch = number;
      };
      for (int i = 0; i < 3; ++i) look(A.col(i), i), look(B.col(i), 3 + i);
      for (int i = 0; i < 9; ++i) look(A.col(i / 3).cross(B.col(i % 3)), 6 + i);
      return greatest;
    };
    if (separation(0) <= 0) continue;
    const double expected = first_root(separation, 1, 3000);
    if (!std::isfinite(expected)) continue;
    ++hits;
    separation(expected);
    edges += axis_of_touch >= 6;
    expect_hit(Box{a}, m, obstacle, expected, 3e-14);
  }
  EXPECT_GT(hits, 30);
  EXPECT_GT(edges, 10);
}

// 100 m/s through a plate of a millimetre: in any step of more than 10 us it would be on the other side.
TEST(FirstTouchVerification, BulletsDoNotPassThinPlates) {
  const Shape bullet = Cylinder{0.005, 0.02};
  const RigidSurface plate{Shape(Box{{2, 2, 0.001}}), 0, {}};
  TestMotion m(bullet);
  m.position = {0, 0, 1}, m.velocity = {0, 0, -100};
  expect_hit(bullet, m, plate, (1 - 0.0105) / 100, 1e-16);
  m.spin = {100, 2000, 300}, m.velocity = {20, 0, -100};
  const auto height = [&](Real t) {
    const RealVector n = rotation(m, t).transpose().col(2);
    return centre(m, t)[2] - 0.0005L - 0.005L * std::hypot(n[0], n[1]) - 0.01L * std::abs(n[2]);
  };
  expect_hit(bullet, m, plate, first_root(height, 0.02L));
}

// u = a sin(w t) X: a sphere of the radius R (1 + a sin w t). Some 0.1 ms off the stiff one's time.
TEST(FirstTouchVerification, ABreathingSphereTouchesAtItsOwnTime) {
  const Shape ball = Sphere{0.05};
  for (const double frequency : {30.0, 1e3, 2e4}) {
    TestMotion m(ball);
    m.position = {0, 0, 0.2}, m.gravity = down;
    m.vibrations = {{frequency, 0.3, 0.02 * Eigen::Matrix3d::Identity(), {}}};
    const Real w = frequency;
    const auto height = [&](Real t) {
      return centre(m, t)[2] - 0.05L * (1 + static_cast<Real>(0.02) * std::sin(w * t + static_cast<Real>(0.3)));
    };
    const double expected = first_root(height, 1, 2'000'000);
    EXPECT_GT(std::abs(expected - std::sqrt(2 * 0.15 / 9.81)), 1e-5);
    expect_hit(ball, m, table, expected);
  }
}

// A bar bends like u_z = a sin(w t) (x^2 - y^2) / L: the ends hit first, or the middle of the end faces' edges. The
// lowest z of its corners and of the stationary points on its edges, at y = +-b.
TEST(FirstTouchVerification, ABendingBarTouchesWhereItIsLowest) {
  const Shape bar = Box{{0.4, 0.04, 0.02}};
  double worst = 0;
  for (const double phase : {0.0, 1.0, 2.0, 4.0}) {
    TestMotion m(bar);
    m.position = {0, 0, 0.2}, m.gravity = down;
    Vibration v{700, phase, Eigen::Matrix3d::Zero(), std::vector<Eigen::Matrix3d>(3, Eigen::Matrix3d::Zero())};
    v.bends[2](0, 0) = 0.05, v.bends[2](1, 1) = -0.05;
    m.vibrations = {v};
    const auto height = [&](Real t) {
      const Real q = static_cast<Real>(0.05) * std::sin(700 * t + static_cast<Real>(phase));
      const Real lowest = q > 0 ? -q * 0.0004L : q * 0.04L;  // at y = +-0.02 of x = 0, or at x = +-0.2 of y = 0
      return centre(m, t)[2] - 0.01L + lowest;
    };
    expect_hit(bar, m, table, first_root(height, 1), 1e-14, 1, &worst);
  }
  testing::expect_verified(
      {.quantity = "time at which a falling bar that bends at four phases touches a table [s]",
       .reference = "second route",
       .source = "First root of its lowest point's height in long double, by steps of 5 us and bisection",
       .uncertainty = "3e-17 s, rounding",
       .tolerance = 1e-14,
       .why = "Some ten roundings of times below a second and of gaps below a metre at metres a second."},
      worst);
}

// The proof costs a bounded number of evaluations a digit: cells shrink with the square root of the gap that is left.
TEST(FirstTouch, WorkGrowsWithTheDigitsOnly) {
  std::mt19937 random(3);
  for (const Shape& shape : {Shape(Sphere{0.05}), Shape(Cylinder{0.05, 0.1}), Shape(Box{{0.1, 0.1, 0.1}})}) {
    TestMotion m(shape);
    m.position = {0, 0, 0.4}, m.gravity = down, m.spin = {2, 3, 1};
    m.vibrations = {random_vibration(random, m.radius, 1e-3, 1e3, true)};
    const auto rough = first_touch(shape, m, table, {0, 1, 1e-5}), fine = first_touch(shape, m, table, {0, 1, 1e-12});
    ASSERT_TRUE(rough && fine);
    EXPECT_LT(fine->n_evaluations,
              12 * rough->n_evaluations);  // 7 digits of gap: as many times 10 were it of first order
    EXPECT_LT(fine->n_evaluations, 4000);
    EXPECT_NEAR(rough->t, fine->t, 1e-14);  // the root does not depend on the tolerance
  }
}

}  // namespace
}  // namespace mb
