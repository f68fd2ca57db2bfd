#include "mechanics/geometry/disc_rule.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "mechanics/geometry/tapered.h"

namespace mb {
namespace {

// int w dA = pi a^2 / 3 on a plane and on a sphere; first moments about the centre vanish by symmetry.
TEST(DiscRule, AreaAndMomentsAreExact) {
  const std::vector<std::pair<Shape, Patch>> patches = {
      {Cylinder{0.05, 0.2}, {"z-max", Disc{{0.02, 0.01, 0.1}, 0.008}}},
      {Box{{0.3, 0.2, 0.5}}, {"y-min", Disc{{0.05, -0.1, 0.1}, 0.03}}},
      {Sphere{0.07}, {"surface", Disc{{0, 0.07, 0}, 0.05}}},
      {Sphere{0.07}, {"surface", Disc{{0, 0, -0.07}, 0.01}}}};
  for (const auto& [shape, patch] : patches) {
    const DiscRule rule = disc_rule(shape, patch, 1);
    const double a = patch.disc->radius, area = pi * a * a / 3;
    EXPECT_NEAR(rule.weights.sum(), area, 1e-14 * area);
    const Vector3d centre = rule.points * rule.weights / rule.weights.sum(), n = rule.normals.col(0);
    const Vector3d offset = centre - patch.disc->centre;
    EXPECT_LT(offset.cross(patch.disc->centre.normalized()).norm() * std::abs(n.norm()),
              std::holds_alternative<Sphere>(shape) ? 1e-14 : 1);  // on a sphere only along the normal
    if (!std::holds_alternative<Sphere>(shape)) {
      EXPECT_LT(offset.norm(), 1e-15);
    }
    for (Index i = 0; i < rule.weights.size(); ++i)
      EXPECT_LT(std::abs(face_distance(shape, patch.face, rule.points.col(i))), 1e-15);
  }
}

// On the side the weighted area is pi a^2/3 (1 + O((a/R)^2)): the chord of a circle is shorter than its arc.
TEST(DiscRule, SideOfACylinder) {
  const double R = 0.05;
  const auto area = [&](double a) {
    return disc_rule(Cylinder{R, 0.4}, {"side", Disc{{0, R, 0.02}, a}}, 1).weights.sum();
  };
  EXPECT_NEAR(area(0.001), pi * 1e-6 / 3, 1e-4 * pi * 1e-6 / 3);
  // int int (1 - (c^2+z^2)/a^2)^2 / sqrt(1 - c^2/4R^2) dc dz, expanded: 1 + (1/8) <c^2>/R^2, <c^2> = a^2/8.
  const double a = 0.01, expected = pi * a * a / 3 * (1 + a * a / (64 * R * R));
  EXPECT_NEAR(area(a), expected, 1e-4 * expected);
  EXPECT_GT(area(a), pi * a * a / 3);
}

// Of a ball by another door: the weighted area is pi a^2/3 to what cells of a/6 leave of a weight with a bend at its
// rim.
TEST(DiscRule, OfSuperquadricsIsGraded) {
  const double R = 0.07, a = 0.02;
  const Patch patch{"surface", Disc{{0, 0, -R}, a}};
  const DiscRule ball = disc_rule(Superquadric{{R, R, R}, 1, 1}, patch, 1);
  EXPECT_NEAR(ball.weights.sum(), pi * a * a / 3, 2e-4 * a * a);
  EXPECT_LT((ball.normals - ball.points / R).cwiseAbs().maxCoeff(), 1e-13);
  const TaperedSuperquadric pear{{{R, R, R}, 1, 1}, 0.4};
  const Vector3d end(0, 0, -R - Taper(pear).shift());
  const DiscRule rule = disc_rule(pear, {"surface", Disc{end, a}}, 1);
  EXPECT_NEAR(rule.weights.sum(), pi * a * a / 3, 0.05 * a * a);  // curvature: of order (a/R)^2
  for (Index i = 0; i < rule.weights.size(); ++i) EXPECT_LT((rule.points.col(i) - end).norm(), a);
  EXPECT_THROW(disc_rule(pear, {"surface", Disc{{5, 0, 0}, 0.03}}, 1), std::invalid_argument);
}

TEST(DiscRule, HalfAndQuarterDiscsAreExact) {
  const Box box{{0.3, 0.2, 0.5}};
  const double a = 0.06, area = pi * a * a / 3;
  const auto at = [&](double x, double y) { return disc_rule(box, {"z-max", Disc{{x, y, 0.25}, a}}, 1); };
  EXPECT_NEAR(at(0, 0.1).weights.sum(), area / 2, 1e-11 * area);  // what lies on the face: to 1e-12 of the body's size
  const DiscRule quarter = at(-0.15, -0.1);
  EXPECT_NEAR(quarter.weights.sum(), area / 4, 1e-11 * area);
  // int (1 - s)^2 x dA of a quarter: a^3 int_0^1 (1 - r^2)^2 r^2 dr = 8 a^3/105
  const double moment = (quarter.points.row(0).array() + 0.15).matrix() * quarter.weights;
  EXPECT_NEAR(moment, 8 * a * a * a / 105, 1e-11 * a * a * a);
}

// Case files give centres as rounding has them, a billionth of the body off their face.
TEST(DiscRule, ACentreOffItsFaceByRoundingIsOnIt) {
  const auto area = [](double z) {
    return disc_rule(Box{{0.3, 0.2, 1.0 / 3}}, {"z-max", Disc{{0.05, 0, z}, 0.03}}, 1).weights.sum();
  };
  for (const double off : {-1e-10, 1e-10}) EXPECT_NEAR(area(1.0 / 6 + off), pi * 9e-4 / 3, 1e-12) << off;
}

// The rim's first touch of a ring leaves a root in the length of its arc, which the rings' places take away.
TEST(DiscRule, OverARoundRimConverges) {
  for (const double x : {0.045, 0.04986, 0.05, 0.05014, 0.052}) {
    const auto area = [&](double spacing) {
      return disc_rule(Cylinder{0.05, 0.2}, {"z-max", Disc{{x, 0, 0.1}, 0.02}}, spacing).weights.sum();
    };
    const double finest = area(0.02 / 128);
    EXPECT_NEAR(area(1), finest, 1e-6 * finest) << x;
    EXPECT_NEAR(area(0.02 / 32), finest, 1e-9 * finest) << x;
  }
}

// A corner of the rim within the disc: the length of arcs has a kink there.
TEST(DiscRule, OverACornerConverges) {
  const auto area = [&](double spacing) {
    return disc_rule(Box{{0.3, 0.2, 0.5}}, {"z-max", Disc{{0.14, 0.08, 0.25}, 0.05}}, spacing).weights.sum();
  };
  const double finest = area(0.05 / 128);
  EXPECT_NEAR(area(1), finest, 1e-6 * finest);
  EXPECT_NEAR(area(0.05 / 32), finest, 1e-6 * finest);
}

TEST(DiscRule, PointsAreAsFarApartAsAsked) {
  const Patch patch{"z-max", Disc{{0, 0, 0.1}, 0.02}};
  const auto n = [&](double spacing) { return disc_rule(Cylinder{0.05, 0.2}, patch, spacing).weights.size(); };
  EXPECT_EQ(n(1), 3 * 8 * 8);
  EXPECT_EQ(n(0.02 / 40), 3 * 40 * 40);
  EXPECT_EQ(n(1e-9), 3 * 128 * 128);
  EXPECT_THROW(n(0), std::invalid_argument);
}

TEST(DiscRule, WhatHangsOverTheRimIsLeftOut) {
  const Cylinder can{0.05, 0.2};
  const double whole = disc_rule(can, {"z-max", Disc{{0, 0, 0.1}, 0.02}}, 1).weights.sum();
  const double half = disc_rule(can, {"z-max", Disc{{0.05, 0, 0.1}, 0.02}}, 1).weights.sum();
  EXPECT_LT(half, 0.5 * whole);
  EXPECT_GT(half, 0.35 * whole);
  EXPECT_THROW(disc_rule(can, {"z-max", Disc{{5, 0, 0.1}, 0.03}}, 1), std::invalid_argument);
  EXPECT_THROW(disc_rule(Sphere{0.07}, {"surface", Disc{{5, 0, 0}, 0.03}}, 1), std::invalid_argument);
  EXPECT_THROW(disc_rule(can, {"z-max", {}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace mb
