#include "harness/analysis/contact_stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

// A rigid mass on the layer alone: omega^2 = kappa/m.
PressedModes rigid(double m, double kappa) {
  return {VectorXd::Zero(1), VectorXd::Zero(1), VectorXd::Constant(1, 1 / std::sqrt(m)), kappa};
}

TEST(ContactStability, ARigidMassIsLimitedByItsOwnFrequencyOnTheLayer) {
  const double omega = std::sqrt(8e5 / 2.0);
  for (const char* scheme : {"exact", "symplectic-euler", "central-difference"})  // free drift between kicks: leapfrog
    EXPECT_NEAR(pressed_limit(rigid(2, 8e5), scheme, 1), 2 / omega, 2e-3 / omega) << scheme;
  EXPECT_TRUE(std::isinf(pressed_limit(rigid(2, 8e5), "newmark", 1)));
  EXPECT_EQ(pressed_limit(rigid(2, 8e5), "explicit-euler", 1), 0);
  EXPECT_NEAR(pressed_radius(rigid(2, 8e5), "explicit-euler", 0.5 / omega), std::sqrt(1.25), 1e-12);
  EXPECT_NEAR(pressed_radius(rigid(2, 8e5), "exact", 0.5 / omega), 1, 1e-12);
  // x = omega h: (2 - x^2)/2 + x/2 sqrt(x^2 - 4) in absolute value
  EXPECT_NEAR(pressed_radius(rigid(2, 8e5), "exact", 3 / omega), (7 + 3 * std::sqrt(5.0)) / 2, 1e-9);
}

// A mass on a layer and massless shapes that are damped, K_s (s + beta s') = F by backward differences of order 2,
// stepped by kicks and drifts: whether it grows over 2000 steps.
bool grows(double m, double kappa, const StaticYield& yield, double h) {
  double u = 1, v = 0, s = 0, s_before = 0, largest = 0;
  const auto force = [&] {  // kappa (u - s) = (s + beta s')/c
    const double slope = 1 + 1.5 * yield.beta / h, past = yield.beta / h * (2 * s - 0.5 * s_before);
    const double now = (kappa * u + past / yield.c) / (kappa + slope / yield.c);
    s_before = s, s = now;
    return -kappa * (u - s);
  };
  double f = force();
  for (int i = 0; i < 2000; ++i) {
    v += h / (2 * m) * f;
    u += h * v;
    f = force();
    v += h / (2 * m) * f;
    largest = std::max(largest, std::abs(u));
  }
  return !(largest < 100);
}

TEST(ContactStability, DampedShapesYieldLessInShortSteps) {
  const double m = 2, kappa = 8e5;
  for (const double beta : {0.0, 1e-3, 1e-2})
    for (const double c : {1e-7, 1e-5, 1e-3}) {  // times kappa: from stiff shapes to soft ones
      PressedModes pressed = rigid(m, kappa);
      pressed.yields = {{c, beta}};
      const double limit = pressed_limit(pressed, "central-difference", 1);
      EXPECT_FALSE(grows(m, kappa, pressed.yields[0], 0.98 * limit)) << beta << " " << c;
      EXPECT_TRUE(grows(m, kappa, pressed.yields[0], 1.02 * limit)) << beta << " " << c;
      EXPECT_NEAR(limit, 2 / std::sqrt(pressed.stiffness(limit) / m), 1e-6 * limit);
      EXPECT_NEAR(opening_limit(pressed, m, 0.1),
                  opening_limit(pressed.stiffness(opening_limit(pressed, m, 0.1)), m, 0.1), 1e-6 * limit);
    }
}

// Without contact every scheme is as it is without: closed form stable at any step, Euler up to 2/omega.
TEST(ContactStability, WithoutALayerItIsThatOfTheModes) {
  const PressedModes free{VectorXd{{0, 100, 2500}}, VectorXd::Zero(3), VectorXd::Zero(3), 1};
  EXPECT_TRUE(std::isinf(pressed_limit(free, "exact", 10)));
  EXPECT_NEAR(pressed_limit(free, "symplectic-euler", 10), 2.0 / 50, 1e-4);
  EXPECT_TRUE(std::isinf(pressed_limit(free, "newmark", 10)));
}

// Twins and rigid modes are stepped as one in the search for the limit: each by itself, they are as unstable.
TEST(ContactStability, ModesAlikeArePressedAsOne) {
  PressedModes pressed{VectorXd{{0, 0, 900, 900, 4e4}}, VectorXd::Zero(5), VectorXd{{0.5, -0.3, 1, 2, 1.5}}, 300};
  for (const double c : {0.0, 0.01}) {
    pressed.c = VectorXd{{0, 0, c, c, 3 * c}};
    const double limit = pressed_limit(pressed, "exact", 1);
    ASSERT_TRUE(std::isfinite(limit));
    EXPECT_GT(pressed_radius(pressed, "exact", limit), 1 + 1e-6);
    EXPECT_LT(pressed_radius(pressed, "exact", limit / 1.0011), 1 + 2e-6);
    PressedModes one{VectorXd{{0, 900, 4e4}}, VectorXd{{0, c, 3 * c}}, VectorXd{{std::sqrt(0.34), std::sqrt(5.0), 1.5}},
                     300};
    EXPECT_NEAR(pressed_limit(one, "exact", 1), limit, 1e-9 * limit);
  }
}

// h -> 0: kicks and drift agree with the stiffened oscillators themselves, which are stable.
TEST(ContactStability, SmallStepsAreStableWhateverTheModes) {
  const PressedModes pressed{VectorXd{{0, 0, 1e4, 9e4}}, VectorXd{{0, 0, 3, 20}}, VectorXd{{1, -0.4, 2, 1.5}}, 1e6};
  for (const char* scheme : {"exact", "symplectic-euler", "central-difference", "newmark"})
    EXPECT_LE(pressed_radius(pressed, scheme, 1e-5), 1 + 1e-7) << scheme;
  const double omega = std::sqrt(1e6 * pressed.g.squaredNorm() + 9e4);  // above the largest
  EXPECT_GT(pressed_limit(pressed, "exact", 1), 0.9 * 2 / omega);
  EXPECT_THROW(pressed_radius(pressed, "sundials", 1e-5), std::invalid_argument);
}

// Theory of one mode: |cos x - (a/2) sin x| > 1, a = kappa h g^2/omega, for x = omega h just below pi, by a share
// kappa g^2/omega^2 of it. However narrow, it is the limit.
TEST(ContactStability, KicksOfOneModeFeedItInANarrowWindowBelowHalfAPeriod) {
  const double omega = 40;
  for (const double share : {7e-2, 3e-2, 1e-3, 1e-5}) {
    const PressedModes one{VectorXd::Constant(1, omega * omega), VectorXd::Zero(1), VectorXd::Ones(1),
                           share * omega * omega};
    const double limit = pressed_limit(one, "exact", 8 * pi / omega) * omega / pi;
    EXPECT_NEAR(limit, 1 - share, 0.6 * share + 1.1e-3) << share;  // bisection to a thousandth
    EXPECT_LT(limit, 1) << share;
    EXPECT_GT(pressed_radius(one, "exact", (1 - share / 2) * pi / omega), 1 + share) << share;
    EXPECT_LE(pressed_radius(one, "exact", (1 - 1.2 * share) * pi / omega), 1 + 1e-9) << share;
    EXPECT_LE(pressed_radius(one, "exact", (1 + 0.2 * share) * pi / omega), 1 + 1e-9) << share;
    EXPECT_EQ(resonances(one, 8 * pi / omega).empty(), share > 0.06) << share;
  }
}

// Of two modes the sum of the frequencies has windows, too, and the first of all is the limit.
TEST(ContactStability, EveryResonanceOfTwoModesIsUnstableUnlessDamped) {
  PressedModes two{VectorXd{{100, 900}}, VectorXd::Zero(2), VectorXd{{1, 1.5}}, 0.4};
  const std::vector<double> windows = resonances(two, 2);
  ASSERT_EQ(windows.size(), 6u + 19u + 12u);  // below 2 s of pi/10, pi/30 and 2 pi/40
  for (const double h : windows) EXPECT_GT(pressed_radius(two, "exact", h), 1 + 1e-4) << h;
  EXPECT_NEAR(pressed_limit(two, "exact", 2), windows.front(), 2e-3 * windows.front());
  two.c = VectorXd{{1, 1}};
  EXPECT_TRUE(resonances(two, 2).empty());
  EXPECT_TRUE(std::isinf(pressed_limit(two, "exact", 2)));
}

// The steppers themselves are held to the bound by ContactStep.WhatOpensWithinAStepGainsUpToItsBound.
TEST(ContactStability, TheStepOfAGainGainsIt) {
  EXPECT_NEAR(opening_gain(8e5, 2, opening_limit(8e5, 2, 0.1)), 0.1, 1e-15);
  const double theta = 2 * std::asin(std::sqrt(8e5 * 1e-3 * 1e-3 / (4 * 2)));  // of kicks: 1/cos^2(theta/2) - 1
  EXPECT_NEAR(opening_gain(8e5, 2, 1e-3), std::pow(std::cos(theta / 2), -2) - 1, 1e-15);
  EXPECT_NEAR(opening_limit(8e5, 2, 1e9), 2 / std::sqrt(8e5 / 2), 1e-9);
  EXPECT_TRUE(std::isinf(opening_gain(8e5, 2, 1.001 * 2 / std::sqrt(8e5 / 2))));
}

}  // namespace
}  // namespace mb
