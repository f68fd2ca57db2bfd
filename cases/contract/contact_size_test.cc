#include "cases/contract/contact_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"
#include "mechanics/geometry/tapered.h"

namespace mb {
namespace {

const Material steel{2e11, 0.3, 7800, {}};
const Vector3d weight(0, 0, -9.81), none = Vector3d::Zero();
const Gap floor_at{0, Vector3d::UnitZ(), Eigen::Matrix3d::Zero()};

Body body(const Shape& shape) { return {"body", shape, steel, {}, {}, {1, {1}}, {}}; }
ContactPair pair_of(double stiffness = 0) { return {.body = "body", .obstacle = "floor", .stiffness = stiffness}; }
Vector3d below(double z) { return {0, 0, -z}; }

// Hertz's impact of a ball, by its own formulas: Johnson 1985, sect. 11.4.
TEST(ContactSizeVerification, OfABallIsHertzs) {
  const double R = 0.02, E = 2e11 / (1 - 0.09), m = 7800 * 4 / 3.0 * pi * R * R * R;
  for (const double v : {0.01, 1.0}) {
    const ContactSize size = contact_size(body(Sphere{R}), pair_of(), below(R), {}, floor_at, v, none);
    const double k = 4.0 / 3 * E * std::sqrt(R), approach = std::pow(1.25 * m * v * v / k, 0.4);
    EXPECT_NEAR(size.modulus, E, 1e-12 * E);
    EXPECT_NEAR(size.approach, approach, 1e-9 * approach);
    EXPECT_NEAR(size.radius, std::sqrt(R * approach), 1e-9 * size.radius);
    EXPECT_NEAR(size.force, k * std::pow(approach, 1.5), 1e-9 * size.force);
    EXPECT_NEAR(size.duration, 2.868265699 * std::pow(m * m / (R * E * E * v), 0.2), 1e-9 * size.duration);
    EXPECT_EQ(size.speed, v);
    // The layer adds E*/(pi k_n a) = 1/(100 pi) of the approach a^2/R at its largest pressure.
    EXPECT_NEAR(size.stiffness, 100 * E / size.radius, 1e-9 * size.stiffness);
    const double p_0 = hertz_at({R, E}, approach).peak_pressure;
    EXPECT_NEAR(p_0 / size.stiffness / approach, 2 / pi / 100, 1e-6);
  }
}

// 1/R is that of both: a ball in a socket, a ball on a ball, a lying cylinder by sqrt(k_1 k_2) with k_1 at its least.
TEST(ContactSize, CurvaturesAreThoseOfTheGap) {
  const double R = 0.02;
  const auto radius = [](const Shape& shape, const Vector3d& X, const Pose& pose, const Gap& at) {
    const ContactSize size = contact_size(body(shape), pair_of(), X, pose, at, 0.1, none);
    return size.radius * size.radius / size.approach;
  };
  const Eigen::Matrix3d across = Vector3d(1, 1, 0).asDiagonal();
  EXPECT_NEAR(radius(Sphere{R}, below(R), {}, floor_at), R, 1e-9 * R);
  EXPECT_NEAR(radius(Sphere{R}, below(R), {}, {0, Vector3d::UnitZ(), across / 0.05}), 1 / (1 / R + 20), 1e-9 * R);
  EXPECT_NEAR(radius(Sphere{R}, below(R), {}, {0, Vector3d::UnitZ(), -across / 0.05}), 1 / (1 / R - 20), 1e-9 * R);
  const Pose lying{{}, Eigen::Quaterniond(Eigen::AngleAxisd(pi / 2, Vector3d::UnitY()))};
  const Vector3d side = lying.orientation.conjugate() * below(R);
  EXPECT_NEAR(radius(Cylinder{R, 0.1}, side, lying, floor_at), 1 / std::sqrt(0.05 / 0.1 / R), 1e-6 * R);
  // In a frame that is turned all is the same.
  const Pose turned{{}, Eigen::Quaterniond(0.3, 0.5, -0.7, 0.2).normalized()};
  const Superquadric egg{{0.02, 0.03, 0.05}, 1, 1};
  const Vector3d n = turned.orientation * Vector3d::UnitZ();
  EXPECT_NEAR(radius(egg, below(0.05), turned, {0, n, Eigen::Matrix3d::Zero()}), radius(egg, below(0.05), {}, floor_at),
              1e-9);
  // Of an ellipsoid's end k_i = c / a_i^2.
  EXPECT_NEAR(radius(egg, below(0.05), {}, floor_at), 0.02 * 0.03 / 0.05, 1e-6);
  // Of a pear's slender end the section is c = 1 - k times the straight one's: k_i = a_3 / (c a_i)^2.
  const TaperedSuperquadric pear{egg, 0.4};
  EXPECT_NEAR(radius(pear, below(0.05 + Taper(pear).shift()), {}, floor_at), 0.6 * 0.6 * 0.02 * 0.03 / 0.05, 1e-6);
}

// A face meets all at once: a bar's impact, F = rho c v A, T = 2 l/c.
TEST(ContactSize, OfAFaceIsABars) {
  const ContactSize size = contact_size(body(Box{{0.02, 0.03, 0.2}}), pair_of(), below(0.1), {}, floor_at, 2, none);
  const double c = std::sqrt(2e11 / 7800), A = 0.0006;
  EXPECT_NEAR(size.duration, 0.4 / c, 0.01 * size.duration);  // the height by points of a quadrature
  EXPECT_NEAR(size.force, 7800 * c * 2 * A, 0.15 * size.force);
  EXPECT_NEAR(size.force * size.duration, 2 * 7800 * 0.02 * 0.03 * 0.2 * 2, 1e-9 * size.force * size.duration);
  EXPECT_NEAR(size.approach, 2 * size.duration / 2, 1e-12 * size.approach);
  EXPECT_EQ(size.speed, 2);
}

TEST(ContactSize, AtRestTheWeightPresses) {
  const double R = 0.02, m = 7800 * 4 / 3.0 * pi * R * R * R;
  const ContactSize size = contact_size(body(Sphere{R}), pair_of(), below(R), {}, floor_at, 0, weight);
  const double k = hertz_stiffness({R, 2e11 / 0.91});
  EXPECT_NEAR(k * std::pow(size.approach, 1.5), m * 9.81, 1e-6 * m * 9.81);
  EXPECT_NEAR(hertz_peaks({m, k, size.speed}).approach, size.approach, 1e-9 * size.approach);
  // Faster than that the impact counts; a weight that pulls away does not.
  EXPECT_GT(contact_size(body(Sphere{R}), pair_of(), below(R), {}, floor_at, 1, weight).approach, 10 * size.approach);
  const ContactSize away = contact_size(body(Sphere{R}), pair_of(), below(R), {}, floor_at, 0, -weight);
  EXPECT_NEAR(away.approach, 1e-3 * 2 * R, 1e-9 * R);
}

// Nothing presses: a thousandth of the extent is taken.
TEST(ContactSize, UnpressedIsAThousandthOfTheExtent) {
  for (const Shape& shape : {Shape(Sphere{0.02}), Shape(Box{{0.02, 0.03, 0.2}})}) {
    const double low = std::holds_alternative<Sphere>(shape) ? 0.02 : 0.1;
    const ContactSize size = contact_size(body(shape), pair_of(), below(low), {}, floor_at, 0, none);
    EXPECT_NEAR(size.approach, 1e-3 * extent(shape), 1e-9 * size.approach);
    for (const double x : {size.radius, size.speed, size.duration, size.force, size.stiffness}) {
      EXPECT_GT(x, 0);
      EXPECT_TRUE(std::isfinite(x));
    }
  }
}

// Wherever on the surface it is, and however fast: finite, and never beyond half the radius of curvature.
TEST(ContactSize, IsFiniteForEdgesAndGrossImpacts) {
  for (const Vector3d& X : {Vector3d(-0.01, -0.01, -0.01), Vector3d(0, -0.01, -0.01), Vector3d(0.0099999, 0, -0.01)}) {
    const ContactSize size = contact_size(body(Box{{0.02, 0.02, 0.02}}), pair_of(), X, {}, floor_at, 1, weight);
    for (const double x : {size.radius, size.approach, size.duration, size.force, size.stiffness}) {
      EXPECT_GT(x, 0);
      EXPECT_TRUE(std::isfinite(x));
    }
  }
  const ContactSize gross = contact_size(body(Sphere{0.02}), pair_of(), below(0.02), {}, floor_at, 1e4, none);
  EXPECT_EQ(gross.radius, 0.01);
}

TEST(ContactSize, StatedStiffnessStands) {
  EXPECT_EQ(contact_size(body(Sphere{0.02}), pair_of(3e12), below(0.02), {}, floor_at, 1, none).stiffness, 3e12);
  Body wood = body(Sphere{0.02});
  wood.material.orthotropy = Orthotropy{};
  wood.material.orthotropy->youngs_moduli = {1e9, 12e9, 0.6e9};
  EXPECT_EQ(contact_size(wood, pair_of(), below(0.02), {}, floor_at, 1, none).modulus, 12e9);
}

// What strikes: its mass alone, the modulus of both.
TEST(ContactSize, OfABallThatStrikesIsHertzsOfBoth) {
  const Obstacle ball{"ball", {Sphere{0.01}, 0, {}}, Striker{0.0325, 0.5, 2e11, 0.3}};
  const ContactSize size = strike_size(body(Box{{0.5, 0.01, 0.01}}), pair_of(), ball);
  const double E = 1e11 / 0.91, k = 4.0 / 3 * E * std::sqrt(0.01);  // two alike: half
  EXPECT_NEAR(size.modulus, E, 1e-9 * E);
  EXPECT_NEAR(size.stiffness, k, 1e-9 * k);
  EXPECT_NEAR(size.approach, std::pow(1.25 * 0.0325 * 0.25 / k, 0.4), 1e-9 * size.approach);
  EXPECT_NEAR(size.radius, std::sqrt(0.01 * size.approach), 1e-12);
  EXPECT_EQ(strike_size(body(Box{{0.5, 0.01, 0.01}}), pair_of(7e9), ball).stiffness, 7e9);
  EXPECT_THROW(strike_size(body(Sphere{1}), pair_of(), {"floor", {HalfSpace{}, 0, {}}}), std::invalid_argument);
  EXPECT_THROW(strike_size(body(Sphere{1}), pair_of(), {"ball", {Sphere{1}, 0, {}}}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
