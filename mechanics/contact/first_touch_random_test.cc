// First touch of random pairs against brute force in time and over the surface, and of the proof it stands on.
#include <gtest/gtest.h>

#include "mechanics/contact/first_touch_certificate.h"
#include "mechanics/contact/first_touch_test_motions.h"
#include "mechanics/geometry/surface_patches.h"

namespace mb {
namespace {

struct Pair {
  Shape body;
  RigidSurface obstacle;
};

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double uniform(double a, double b) { return a + (b - a) * (static_cast<double>(random_()) / 4294967296.0); }
  double logarithmic(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
  bool coin() { return uniform(0, 1) < 0.5; }
  Vector3d vector() { return Vector3d(normal_(random_), normal_(random_), normal_(random_)); }
  Eigen::Quaterniond turn() {
    return Eigen::Quaterniond(normal_(random_), normal_(random_), normal_(random_), normal_(random_)).normalized();
  }
  double size() { return logarithmic(0.015, 0.15); }
  Shape shape(int n_kinds) {
    switch (static_cast<int>(uniform(0, n_kinds))) {
      case 0:
        return Box{{size(), size(), size()}};
      case 1:
        return Cylinder{size() / 2, size()};
      case 2:
        return Sphere{size() / 2};
      case 3:
        return Superquadric{{size() / 2, size() / 2, size() / 2}, uniform(0.1, 2), uniform(0.1, 2)};
      default: {
        const double e1 = uniform(0.1, 1.6), most = largest_taper(e1);
        return TaperedSuperquadric{{{size() / 2, size() / 2, size() / 2}, e1, uniform(0.1, 2)}, uniform(-most, most)};
      }
    }
  }
  RigidSurface obstacle() {
    RigidSurface o{HalfSpace{}, 0, {0.1 * vector(), turn()}};
    if (uniform(0, 1) < 0.25) return o;
    o.shape = shape(3);
    if (!std::holds_alternative<Sphere>(std::get<Shape>(o.shape)) && coin()) o.rounding = uniform(0.001, 0.004);
    return o;
  }
  // Aimed at the obstacle, which it meets or passes in about half a second.
  TestMotion motion(const Pair& pair) {
    TestMotion m(pair.body);
    const auto* shape = std::get_if<Shape>(&pair.obstacle.shape);
    Vector3d from = vector().normalized();
    if (!shape && from.dot(pair.obstacle.pose.orientation * Vector3d::UnitZ()) < 0) from = -from;
    const double speed = logarithmic(0.3, 30), when = uniform(0.1, 0.9),
                 reach = m.radius + (shape ? circumradius(*shape) : 0);
    m.velocity = speed * (0.3 * vector() - from);
    m.gravity = coin() ? Vector3d(0, 0, -9.81) : Vector3d::Zero().eval();
    m.position = pair.obstacle.pose.position + 0.4 * reach * vector() - when * (m.velocity + 0.5 * when * m.gravity);
    m.orientation = turn();
    if (uniform(0, 1) < 0.7) m.spin = logarithmic(0.5, 50) * vector();
    for (int k = static_cast<int>(uniform(0, 3)); k > 0; --k)
      m.vibrations.push_back(
          random_vibration(random_, m.radius, logarithmic(1e-4, 0.03), logarithmic(10, 1e4), coin()));
    return m;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

std::vector<Vector3d> samples(const Shape& shape, int n) {
  std::vector<Vector3d> X;
  for (const SurfacePatch& patch : surface_patches(shape))
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) X.push_back(patch.at(i / double(n), j / double(n)).x);
  return X;
}

double least_gap(const TestMotion& motion, const RigidSurface& obstacle, const std::vector<Vector3d>& X, double t) {
  std::vector<PointMotion> points(X.size());
  motion.at(t, X, points);
  double least = std::numeric_limits<double>::infinity();
  for (const PointMotion& p : points) least = std::min(least, gap_value(obstacle, p.x));
  return least;
}

TEST(FirstTouchVerification, BruteForceFindsNoEarlierTouch) {
  int hits = 0, none = 0;
  for (unsigned seed = 0; seed < 120; ++seed) {
    Random random(seed);
    const Pair pair{random.shape(5), random.obstacle()};
    const TestMotion m = random.motion(pair);
    const auto touch = first_touch(pair.body, m, pair.obstacle, {0, 1});
    if (touch && touch->kind == FirstTouch::overlap) {
      EXPECT_LT(gap_value(pair.obstacle, touch->x), 0);
      continue;
    }
    ++(touch ? hits : none);
    const double end = touch ? touch->t : 1;
    const std::vector<Vector3d> X = samples(pair.body, 6);
    for (int i = 0; i < 100; ++i) EXPECT_GT(least_gap(m, pair.obstacle, X, end * i / 100), 0) << seed;
    for (double before = 1e-2; before > 1e-10 && before < end; before *= 0.1)
      EXPECT_GT(least_gap(m, pair.obstacle, X, end - before), 0) << seed;
    if (!touch) continue;
    EXPECT_EQ(touch->kind, FirstTouch::hit) << seed;
    EXPECT_NEAR(gap_value(pair.obstacle, touch->x), 0, 1e-12) << seed;  // the tolerance, between sharp edges
    PointMotion point;
    m.at(end, {&touch->X, 1}, {&point, 1});
    EXPECT_LT(touch->normal.dot(point.v), 0) << seed;
    EXPECT_LT(touch->bracket, 1e-9) << seed;
  }
  EXPECT_GT(hits, 60);
  EXPECT_GT(none, 8);
}

// What the proof says holds for samples at any time of its step; from far away, near, and at a tolerance's distance.
TEST(FirstTouchCertificate, WhatIsProvedHolds) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Random random(seed + 1000);
    const Pair pair{random.shape(5), random.obstacle()};
    const TestMotion m = random.motion(pair);
    const TouchSearch search{0, 1};
    const auto touch = first_touch(pair.body, m, pair.obstacle, search);
    if (!touch || touch->kind != FirstTouch::hit) continue;
    TouchSurface surface(pair.body);
    CountedMotion motion(m, search);
    const Descent descent(surface, motion, pair.obstacle);
    std::vector<Vector3d> X = samples(pair.body, 5);
    X.push_back(touch->X);
    for (const double before : {0.5, 1e-2, 1e-5, 1e-8}) {
      const double t = std::max(0.0, touch->t - before);
      NearPoint near{};
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k < surface.n_patches(); ++k) {
        const NearPoint p = descent.nearest(surface.cell(k).middle, t);
        if (p.gap.value < least) least = p.gap.value, near = p;
      }
      EXPECT_LE(least, least_gap(m, pair.obstacle, X, t) + 1e-15) << seed;
      const double level = 0.2 * least;
      const MotionBounds bounds = m.bounds(t, t + 1);
      const Proof proof = prove_clear({t, 1, near, level, bounds}, surface, motion, pair.obstacle);
      ASSERT_LT(proof.lower, 0) << seed;
      EXPECT_GT(proof.dt, 0) << seed;
      EXPECT_LT(t + proof.dt, touch->t) << seed;
      for (int i = 0; i <= 10; ++i)
        EXPECT_GT(least_gap(m, pair.obstacle, X, t + proof.dt * i / 10), level - 1e-15) << seed;
    }
  }
}

// For a body that falls without turning the bound is sharp: the whole way in one step, but for the thousandth of it
// that keeps the rounding out.
TEST(FirstTouchCertificate, IsSharpForABallisticBody) {
  const Shape box = Box{{0.1, 0.2, 0.3}};
  TestMotion m(box);
  m.orientation = Eigen::Quaterniond(0.9, 0.1, 0.3, 0.2).normalized();
  m.position = {0, 0, 1}, m.velocity = {1, 2, 0.5}, m.gravity = {0, 0, -9.81};
  const RigidSurface table{HalfSpace{}, 0, {}};
  const TouchSearch search{0, 1};
  const double t = first_touch(box, m, table, search)->t;
  TouchSurface surface(box);
  CountedMotion motion(m, search);
  const Descent descent(surface, motion, table);
  NearPoint near = descent.nearest(surface.cell(4).middle, 0);
  const MotionBounds bounds = m.bounds(0, 1);
  const double dt = prove_clear({0, 1, near, 0, bounds}, surface, motion, table).dt;
  EXPECT_LT(dt, t);
  EXPECT_GT(dt, 0.998 * t);
}

TEST(FirstTouchSurface, NeighboursShareTheirPoints) {
  for (const Shape& shape : {Shape(Box{{0.1, 0.2, 0.3}}), Shape(Cylinder{0.05, 0.2}), Shape(Sphere{0.1}),
                             Shape(Superquadric{{0.1, 0.05, 0.2}, 0.5, 1.7}),
                             Shape(TaperedSuperquadric{{{0.1, 0.05, 0.2}, 0.5, 1.7}, 0.7})}) {
    const TouchSurface surface(shape);
    for (int k = 0; k < surface.n_patches(); ++k)
      for (int edge = 0; edge < 4; ++edge)
        for (const double p : {0.0, 0.2, 0.5, 0.9}) {
          const PatchPoint at = edge < 2 ? PatchPoint{k, double(edge % 2), p} : PatchPoint{k, p, double(edge % 2)};
          const auto [there, back] = surface.across(at, edge);
          EXPECT_NE(there.patch, k);
          EXPECT_LT((surface.patch(k).at(at.s, at.t).x - surface.patch(there.patch).at(there.s, there.t).x).norm(),
                    1e-15);
          const PatchPoint home = surface.across(there, back).point;
          EXPECT_EQ(home.patch, k);
          EXPECT_NEAR(home.s, at.s, 1e-15);
          EXPECT_NEAR(home.t, at.t, 1e-15);
        }
  }
}

// A surface that has been divided before gives the same answers.
TEST(FirstTouchSurface, ServesManyFlights) {
  Random random(5);
  const Shape body = Cylinder{0.05, 0.1};
  TouchSurface surface(body);
  int hits = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Pair pair{body, random.obstacle()};
    const TestMotion m = random.motion(pair);
    const auto fresh = first_touch(body, m, pair.obstacle, {0, 1}),
               again = first_touch(surface, m, pair.obstacle, {0, 1});
    ASSERT_EQ(fresh.has_value(), again.has_value());
    if (!fresh) continue;
    ++hits;
    EXPECT_EQ(fresh->t, again->t);
    EXPECT_EQ(fresh->X, again->X);
  }
  EXPECT_GT(hits, 10);
  for (int k = 0; k < 30000; ++k) surface.children(k);
  surface.trim();
  EXPECT_EQ(surface.children(0), surface.n_patches());
}

TEST(FirstTouchSurface, LocatesThePointsOfSuperquadrics) {
  const Superquadric straight{{0.1, 0.05, 0.2}, 0.5, 1.9};
  for (const Shape& shape : {Shape(straight), Shape(TaperedSuperquadric{straight, -0.7})}) {
    const TouchSurface surface(shape);
    for (int k = 0; k < surface.n_patches(); ++k)
      for (const double s : {1e-9, 0.3, 0.999})
        for (const double t : {1e-6, 0.5, 0.9}) {
          const auto p = surface.locate(surface.patch(k).at(s, t).x);
          ASSERT_TRUE(p);
          EXPECT_EQ(p->patch, k);
          EXPECT_NEAR(p->s, s, 1e-14);
          EXPECT_NEAR(p->t, t, 1e-14);
        }
  }
  EXPECT_FALSE(TouchSurface(Sphere{1}).locate({0, 0, 1}));
}

}  // namespace
}  // namespace mb
