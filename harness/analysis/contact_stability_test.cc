#include "harness/analysis/contact_stability.h"

#include <gtest/gtest.h>

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
  for (const char* scheme : {"exact", "symplectic-euler"})  // free drift between kicks is leapfrog
    EXPECT_NEAR(pressed_limit(rigid(2, 8e5), scheme, 1), 2 / omega, 2e-3 / omega) << scheme;
  EXPECT_TRUE(std::isinf(pressed_limit(rigid(2, 8e5), "newmark", 1)));
  EXPECT_NEAR(pressed_radius(rigid(2, 8e5), "exact", 0.5 / omega), 1, 1e-12);
  // x = omega h: (2 - x^2)/2 + x/2 sqrt(x^2 - 4) in absolute value
  EXPECT_NEAR(pressed_radius(rigid(2, 8e5), "exact", 3 / omega), (7 + 3 * std::sqrt(5.0)) / 2, 1e-9);
}

// Without contact every scheme is as it is without: closed form stable at any step, Euler up to 2/omega.
TEST(ContactStability, WithoutALayerItIsThatOfTheModes) {
  const PressedModes free{VectorXd{{0, 100, 2500}}, VectorXd::Zero(3), VectorXd::Zero(3), 1};
  EXPECT_TRUE(std::isinf(pressed_limit(free, "exact", 10)));
  EXPECT_NEAR(pressed_limit(free, "symplectic-euler", 10), 2.0 / 50, 1e-4);
  EXPECT_TRUE(std::isinf(pressed_limit(free, "newmark", 10)));
}

// h -> 0: kicks and drift agree with the stiffened oscillators themselves, which are stable.
TEST(ContactStability, SmallStepsAreStableWhateverTheModes) {
  const PressedModes pressed{VectorXd{{0, 0, 1e4, 9e4}}, VectorXd{{0, 0, 3, 20}}, VectorXd{{1, -0.4, 2, 1.5}}, 1e6};
  for (const char* scheme : {"exact", "symplectic-euler", "newmark"})
    EXPECT_LE(pressed_radius(pressed, scheme, 1e-5), 1 + 1e-7) << scheme;
  const double omega = std::sqrt(1e6 * pressed.g.squaredNorm() + 9e4);  // above the largest
  EXPECT_GT(pressed_limit(pressed, "exact", 1), 0.9 * 2 / omega);
  EXPECT_THROW(pressed_radius(pressed, "central-difference", 1e-5), std::invalid_argument);
}

}  // namespace
}  // namespace mb
