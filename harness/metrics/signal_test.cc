#include "harness/metrics/signal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/worse_test.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

const VectorXd t = VectorXd::LinSpaced(2001, 0, 3);  // three periods of one second

VectorXd wave(double amplitude, double phi) { return amplitude * (2 * pi * t.array() - phi).sin(); }

TEST(TrapezoidWeights, IntegrateLinesOnUnevenTimesExactly) {
  const VectorXd uneven{{0, 0.1, 0.4, 1}};
  const VectorXd weights = trapezoid_weights(uneven);
  EXPECT_NEAR(weights.sum(), 1, 1e-15);
  EXPECT_NEAR(weights.dot(uneven), 0.5, 1e-15);
  EXPECT_EQ(trapezoid_weights(VectorXd::Constant(1, 7))(0), 1);
  EXPECT_EQ(trapezoid_weights(VectorXd()).size(), 0);
}

TEST(SpragueGeersVerification, MagnitudeAndPhaseOfAShiftedWave) {
  const VectorXd weights = trapezoid_weights(t);
  double worst = 0;
  for (const double amplitude : {0.5, 1.0, 1.2}) {
    for (const double phi : {1e-9, 0.01, 0.3, pi / 2, 3.0}) {
      const SpragueGeers marks = sprague_geers(weights, wave(amplitude, phi), wave(1, 0));
      // The trapezoidal rule is exact for whole periods of trigonometric polynomials: only rounding is left.
      EXPECT_NEAR(marks.magnitude, amplitude - 1, 1e-13);
      EXPECT_NEAR(marks.phase, phi / pi, 1e-13);
      EXPECT_NEAR(marks.combined, std::hypot(amplitude - 1, phi / pi), 1e-13);
      worst = worse({worst, std::abs(marks.magnitude - (amplitude - 1)), std::abs(marks.phase - phi / pi),
                     std::abs(marks.combined - std::hypot(amplitude - 1, phi / pi))});
    }
  }
  testing::expect_verified(
      {.quantity =
           "Sprague and Geers's magnitude, phase and combined error of A sin(wt - phi) against sin wt over three "
           "periods",
       .reference = "exact solution",
       .source = "A - 1, phi/pi and the root of the sum of their squares (Sprague and Geers 2004)",
       .uncertainty = "rounding",
       .tolerance = 1e-13,
       .why = "The trapezoidal rule is exact over whole periods of sines: only the rounding of 2001 terms is left."},
      worst);
}

TEST(SpragueGeers, UnitsAndLengthOfTheRecordDoNotMatter) {
  const VectorXd weights = trapezoid_weights(t), c = wave(1.3, 0.2), m = wave(1, 0);
  const SpragueGeers marks = sprague_geers(weights, c, m);
  const SpragueGeers scaled = sprague_geers(1e3 * weights, 1e-6 * c, 1e-6 * m);
  EXPECT_NEAR(scaled.magnitude, marks.magnitude, 1e-14);
  EXPECT_NEAR(scaled.phase, marks.phase, 1e-14);
  EXPECT_NEAR(sprague_geers(weights, -m, m).phase, 1, 1e-14);
}

TEST(SpragueGeers, NothingHasNoMarks) {
  const VectorXd weights = trapezoid_weights(t), zero = VectorXd::Zero(t.size());
  EXPECT_TRUE(std::isnan(sprague_geers(weights, wave(1, 0), zero).magnitude));
  EXPECT_TRUE(std::isnan(sprague_geers(weights, zero, zero).combined));
  EXPECT_EQ(sprague_geers(weights, zero, wave(1, 0)).magnitude, -1);
  EXPECT_TRUE(std::isnan(sprague_geers(weights, zero, wave(1, 0)).phase));
  EXPECT_TRUE(std::isnan(relative_l2(weights, zero, zero)));
  EXPECT_TRUE(std::isnan(sprague_geers(weights, wave(1, 0) * NAN, wave(1, 0)).phase));
}

TEST(RelativeL2, OfAScaledAndOfAShiftedWave) {
  const VectorXd weights = trapezoid_weights(t);
  EXPECT_NEAR(relative_l2(weights, wave(1.1, 0), wave(1, 0)), 0.1, 1e-13);
  // |sin(x - phi) - sin x| = 2 sin(phi/2) |cos(x - phi/2)|
  EXPECT_NEAR(relative_l2(weights, wave(1, 0.3), wave(1, 0)), 2 * std::sin(0.15), 1e-13);
}

}  // namespace
}  // namespace mb
