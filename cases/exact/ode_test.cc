#include "cases/exact/ode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace mb {
namespace {

VectorXd oscillator(double, const VectorXd& y) { return VectorXd{{y[1], -y[0]}}; }

TEST(OdeTest, HarmonicOscillator) {
  for (const double t_end : {1e-9, 1.0, 40.0, -7.0}) {
    const OdeState end = integrate(oscillator, {0, VectorXd{{1.0, 0.0}}}, t_end);
    EXPECT_EQ(end.t, t_end);
    const double tolerance = 2e-15 + 1e-14 * std::abs(t_end);  // one period takes some six steps
    EXPECT_NEAR(end.y[0], std::cos(t_end), tolerance);
    EXPECT_NEAR(end.y[1], -std::sin(t_end), tolerance);
  }
  const OdeState same = integrate(oscillator, {3, VectorXd{{1.0, 2.0}}}, 3);
  EXPECT_EQ(same.y, (VectorXd{{1.0, 2.0}}));
}

// y' = 2 t y^2, y = 1/(1 - t^2) towards its pole: steps shrink with the radius of convergence.
TEST(OdeTest, FollowsTowardsAPole) {
  const Derivative f = [](double t, const VectorXd& y) { return VectorXd(2 * t * y.cwiseAbs2()); };
  const double t = 0.999, end = integrate(f, {0, VectorXd::Ones(1)}, t).y[0], exact = 1 / (1 - t * t);
  EXPECT_NEAR(end, exact, 1e-11 * exact);  // errors grow like y^2
  EXPECT_THROW(integrate(f, {0, VectorXd::Ones(1)}, 1.1), std::runtime_error);
}

TEST(OdeTest, ToleranceIsMet) {
  for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
    const double error =
        std::abs(integrate(oscillator, {0, VectorXd{{1.0, 0.0}}}, 10, {tolerance, tolerance}).y[0] - std::cos(10.0));
    EXPECT_LT(error, 10 * tolerance);
  }
}

TEST(OdeTest, FindsTheCrossing) {
  const OdeState quarter = integrate_to_zero(oscillator, {0, VectorXd{{1.0, 0.0}}}, 0);
  EXPECT_NEAR(quarter.t, std::acos(0.0), 1e-14);  // a few steps of 1e-13 each at most
  EXPECT_NEAR(quarter.y[0], 0, 1e-15);
  EXPECT_NEAR(quarter.y[1], -1, 1e-14);
  const OdeState half = integrate_to_zero(oscillator, {2, VectorXd{{0.0, 1.0}}}, 0);  // starts at zero, rising
  EXPECT_NEAR(half.t, 2 + 2 * std::acos(0.0), 1e-14);
  // a shallow crossing, y = exp(-t) - 1e-6
  const Derivative decay = [](double, const VectorXd& y) { return VectorXd(-(y.array() + 1e-6)); };
  EXPECT_NEAR(integrate_to_zero(decay, {0, VectorXd::Constant(1, 1 - 1e-6)}, 0).t, 6 * std::log(10.0), 1e-8);
}

TEST(OdeTest, RefusesBadInput) {
  const VectorXd y = VectorXd{{1.0, 0.0}};
  const double nan = std::nan("");
  EXPECT_THROW(integrate(oscillator, {nan, y}, 1), std::invalid_argument);
  EXPECT_THROW(integrate(oscillator, {0, VectorXd::Constant(2, nan)}, 1), std::invalid_argument);
  EXPECT_THROW(integrate(oscillator, {0, y}, nan), std::invalid_argument);
  EXPECT_THROW(integrate(oscillator, {0, y}, 1, {0, 0}), std::invalid_argument);
  EXPECT_THROW(integrate(oscillator, {0, y}, 1, {1e-9, -1}), std::invalid_argument);
  EXPECT_THROW(integrate_to_zero(oscillator, {0, y}, 2), std::invalid_argument);
  EXPECT_THROW(integrate_to_zero(oscillator, {0, -y}, 0), std::invalid_argument);
  const Derivative broken = [](double t, const VectorXd& v) { return VectorXd(v * (t > 0.5 ? std::nan("") : 1.0)); };
  EXPECT_THROW(integrate(broken, {0, y}, 1), std::runtime_error);
}

}  // namespace
}  // namespace mb
