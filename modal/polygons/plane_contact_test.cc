#include "modal/polygons/plane_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/contact/hertz.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

TEST(PlaneContact, SamplesAddUpWhatIsBelowThePlane) {
  const HeightSamples samples(VectorXd{{3, 0.5, 1}}, VectorXd{{7, 2, 4}});
  EXPECT_EQ(samples.height(0), 0.5);  // by height, weights with them
  EXPECT_EQ(samples.weight(1), 4);
  const PlaneContact at = samples.at(2);
  EXPECT_EQ(at.n_touching, 2);
  EXPECT_EQ(at.area, 6);
  EXPECT_EQ(at.force, 2 * 1.5 + 4 * 1);
  EXPECT_EQ(at.energy, 2 * 1.5 * 1.5 / 2 + 4 * 0.5);
  EXPECT_EQ(at.depth, 1.5);
  EXPECT_DOUBLE_EQ(samples.root_moment(2), 2 * std::sqrt(1.5) + 4);
  for (const double none : {0.5, 0.0, -1.0}) EXPECT_EQ(samples.at(none).area, 0) << none;
}

// Force is the energy's derivative by depth, of samples and of curvatures alike.
TEST(PlaneContact, ForceIsTheDerivativeOfEnergy) {
  const VectorXd height = VectorXd::LinSpaced(200, 0, 1).array().square();
  const HeightSamples samples(height, VectorXd::LinSpaced(200, 1, 2));
  const double h = 1e-5;  // central differences of a cubic: h^2; kinks of g^2/2 add h
  for (const double depth : {0.1, 0.35, 0.8}) {
    const double slope = (samples.at(depth + h).energy - samples.at(depth - h).energy) / (2 * h);
    EXPECT_NEAR(slope, samples.at(depth).force, 1e-4 * samples.at(depth).force);
    const auto energy = [](double d) { return contact_by_curvatures(2, 5, d).energy; };
    EXPECT_NEAR((energy(depth + h) - energy(depth - h)) / (2 * h), contact_by_curvatures(2, 5, depth).force,
                1e-8);  // h^2
  }
}

TEST(PlaneContactVerification, CurvaturesGiveTheZoneOfASphereAndItsVolumeInTheLimit) {
  const double R = 0.3;
  for (const double depth : {1e-6, 0.01, 0.2}) {
    const PlaneContact at = contact_by_curvatures(1 / R, 1 / R, depth);
    EXPECT_NEAR(at.area, 2 * pi * R * depth, 1e-14 * at.area);        // Archimedes
    EXPECT_NEAR(at.force, pi * R * depth * depth, 1e-14 * at.force);  // int (delta - h) 2 pi R dh
    EXPECT_NEAR(at.energy, pi * R * std::pow(depth, 3) / 3, 1e-14 * at.energy);
    EXPECT_EQ(at.depth, depth);
  }
  const double depth = 1e-3 * R, cap = pi * depth * depth * (R - depth / 3);  // what the plane cuts off, per k_n
  EXPECT_NEAR(contact_by_curvatures(1 / R, 1 / R, depth).force, cap, 1.001 * depth / (3 * R) * cap);
}

// A rule on the sphere, fine at the pole: the same sums by quadrature, and Hertz's force of his pressure.
TEST(PlaneContactVerification, AQuadratureOfASphereGivesTheZoneAndHertzsForce) {
  const double R = 0.3, depth = 0.03, modulus = 2e6;
  const GradedRule rule = graded_rule(Sphere{R}, {Vector3d(0, 0, -R)}, {5e-3 * R, 1, 0.0, 2}, 0.5 * R);
  const HeightSamples samples((rule.points.row(2).array() + R).matrix().transpose(), rule.weights);
  const PlaneContact by_samples = samples.at(depth), exact = contact_by_curvatures(1 / R, 1 / R, depth);
  // Cells of 5e-3 R against a rim of radius 0.45 R: the rim cuts through cells that are 2 % of the area, g^1.5 less so.
  EXPECT_NEAR(by_samples.area, exact.area, 1e-3 * exact.area);
  EXPECT_NEAR(by_samples.force, exact.force, 2e-5 * exact.force);
  EXPECT_NEAR(by_samples.energy, exact.energy, 2e-6 * exact.energy);
  const double force = 2 * modulus / pi * std::sqrt(2 / R) * samples.root_moment(depth / 2);
  const double expected = hertz_at({R, modulus}, depth).force;
  EXPECT_NEAR(force, expected, 2e-4 * force);
  testing::expect_verified(
      {.quantity = "Hertz's force on a sphere from heights of its samples, relative",
       .reference = "exact solution",
       .source = "Hertz 1882, J. reine angew. Math. 92; Johnson 1985, Contact Mechanics, sect. 4.2",
       .uncertainty = "rounding",
       .tolerance = 2e-4,
       .why = "Cells of 5e-3 R against a rim of radius 0.32 R, where the root of the height is not "
              "smooth; a paraboloid and a sphere have the same bands of height."},
      force / expected - 1);
}

TEST(PlaneContact, ATroughIsUnboundedAndNoInputMakesNaN) {
  EXPECT_EQ(contact_by_curvatures(0, 3, 1).force, infinite);
  EXPECT_EQ(contact_by_curvatures(0, 3, 1).depth, 1);
  EXPECT_EQ(contact_by_curvatures(0, 3, 0).force, 0);
  EXPECT_GT(contact_by_curvatures(1e-200, 1e-200, 1e-9).force, 0);
  for (const double bad : {nan, infinite, -1.0}) EXPECT_THROW(contact_by_curvatures(1, bad, 1), std::invalid_argument);
  for (const double bad : {nan, infinite}) {
    EXPECT_THROW(contact_by_curvatures(1, 1, bad), std::invalid_argument);
    EXPECT_THROW(HeightSamples(VectorXd{{bad}}, VectorXd{{1}}), std::invalid_argument);
    EXPECT_THROW(HeightSamples(VectorXd{{1}}, VectorXd{{bad}}), std::invalid_argument);
    EXPECT_THROW(HeightSamples(VectorXd{{0}}, VectorXd{{1}}).at(bad), std::invalid_argument);
    EXPECT_THROW(HeightSamples(VectorXd{{0}}, VectorXd{{1}}).root_moment(bad), std::invalid_argument);
  }
  EXPECT_THROW(HeightSamples(VectorXd{{0}}, VectorXd{{0}}), std::invalid_argument);
  EXPECT_THROW(HeightSamples(VectorXd{{0, 1}}, VectorXd{{1}}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
