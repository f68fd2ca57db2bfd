#include "harness/analysis/layer_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/analysis/pressed_cap.h"

namespace mb {
namespace {

// One spring of weight w is met at a height: half a period of an oscillator of frequency sqrt(w).
TEST(LayerImpactVerification, OneSampleIsAnOscillator) {
  const double w = 4, v = 3, h = 0.5, free = h / v;
  const HeightSamples one(VectorXd{{h}}, VectorXd{{w}});
  const LayerImpact all = impact_on_samples(one, v, 100);
  EXPECT_NEAR(all.duration, pi / 2, 1e-14);
  EXPECT_NEAR(all.peak_force, v * 2, 1e-14);
  EXPECT_NEAR(all.impulse, 2 * v, 1e-14);
  EXPECT_EQ(impact_on_samples(one, v, 0.9 * free).impulse, 0);
  for (const double t : {0.1, 0.7, 1.2})
    EXPECT_NEAR(impact_on_samples(one, v, free + t).impulse, v - v * std::cos(2 * t), 1e-13);
}

// The law of a sphere, F = pi R delta^2: by its closed form, by the integral of its energy, and by so many samples on
// rings of equal height that they are no different.
TEST(LayerImpactVerification, ThreeWaysOfTheSameImpactAgree) {
  const double R = 0.3, depth = 0.02, c = pi * R, speed = std::sqrt(2 * c * std::pow(depth, 3) / 3);
  const double rest = time_to_rest([&](double d) { return contact_by_curvatures(1 / R, 1 / R, d); }, depth);
  const LayerImpact smooth = impact_on_square_law(c, speed, rest);
  EXPECT_NEAR(smooth.duration, 2 * rest, 1e-10 * rest);
  EXPECT_NEAR(smooth.impulse, speed, 1e-10 * speed);  // at rest
  EXPECT_NEAR(smooth.peak_force, c * depth * depth, 1e-12 * smooth.peak_force);
  const Index n = 20000;
  const VectorXd height =
      (VectorXd::LinSpaced(n, 0.5, static_cast<double>(n) - 0.5) * (1.5 * depth / static_cast<double>(n)));
  const HeightSamples rings(height, VectorXd::Constant(n, 2 * pi * R * 1.5 * depth / static_cast<double>(n)));
  for (const double t : {0.5, 1.0, 1.5}) {  // steps of 1/13000 of the depth, second order
    const LayerImpact stepped = impact_on_samples(rings, speed, t * rest);
    EXPECT_NEAR(stepped.impulse, impact_on_square_law(c, speed, t * rest).impulse, 1e-7 * speed) << t;
    EXPECT_NEAR(stepped.peak_force, smooth.peak_force, 1e-7 * smooth.peak_force);
  }
  EXPECT_NEAR(impact_on_samples(rings, speed, 9 * rest).duration, smooth.duration, 1e-4 * smooth.duration);
}

// The layer keeps energy: the greatest depth of samples is where their energy is the body's.
TEST(LayerImpact, SamplesKeepEnergyAndTheWholeImpulseIsTwiceTheMomentum) {
  const HeightSamples samples(VectorXd{{0.1, 0.2, 0.2, 0.45, 0.5}}, VectorXd{{1, 5, 2, 3, 0.5}});
  const double depth = 0.47, speed = std::sqrt(2 * samples.at(depth).energy);
  const LayerImpact impact = impact_on_samples(samples, speed, 1e9);
  EXPECT_NEAR(impact.peak_force, samples.at(depth).force, 1e-13);
  EXPECT_EQ(impact.impulse, 2 * speed);
  EXPECT_NEAR(impact_on_samples(samples, speed, 0.1 / speed + impact.duration / 2).impulse, speed, 1e-7);  // at rest
  EXPECT_EQ(impact_on_square_law(2, speed, 1e9).impulse, impact_on_square_law(2, speed, 1e12).impulse);
  EXPECT_NEAR(impact_on_square_law(2, speed, 1e9).impulse, 2 * speed, 1e-11);
}

TEST(LayerImpact, BadInputIsRefused) {
  const HeightSamples some(VectorXd{{0}}, VectorXd{{1}}), none(VectorXd(0), VectorXd(0));
  for (const double bad : {std::nan(""), 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(impact_on_samples(some, bad, 1), std::invalid_argument);
    EXPECT_THROW(impact_on_square_law(1, bad, 1), std::invalid_argument);
    EXPECT_THROW(impact_on_square_law(bad, 1, 1), std::invalid_argument);
  }
  for (const double bad : {std::nan(""), -1.0}) {
    EXPECT_THROW(impact_on_samples(some, 1, bad), std::invalid_argument);
    EXPECT_THROW(time_to_rest([](double d) { return contact_by_curvatures(1, 1, d); }, bad), std::invalid_argument);
  }
  EXPECT_THROW(impact_on_samples(none, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace mb
