#include "mechanics/contact/hertz_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/contact/hertz.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr HertzImpact unit{1, 1, 1};

// Johnson 1985, sect. 11.4, quotes 2.87 for the first; nine digits: hertz_nondim.csv's author.
TEST(HertzMotionVerification, ConstantsOfTheSphere) {
  const double m = 0.3, R = 0.02, E = 7e9, v = 2.5;
  const HertzPeaks peaks = hertz_peaks({m, hertz_stiffness({R, E}), v});
  const double T = peaks.duration / std::pow(m * m / (R * E * E * v), 0.2);
  const double F = peaks.force / std::pow(m * m * m * std::pow(v, 6) * R * E * E, 0.2);
  EXPECT_NEAR(T, 2.868265699, 5e-10);
  EXPECT_NEAR(F, 1.282689390, 5e-10);
  EXPECT_NEAR(hertz_at({R, E}, peaks.approach).force, peaks.force, 1e-14 * peaks.force);
  testing::expect_verified(
      {.quantity =
           "duration and peak force of a sphere's impact on a half-space, as the constants T = 2.87 and F = 1.28",
       .reference = "table",
       .source = "Constants given with hertz_nondim.csv, of another program; Johnson 1985, sect. 11.4, has 2.87",
       .uncertainty = "5e-10, the digits written",
       .tolerance = 5e-10,
       .why = "Half of the last digit; both constants are closed forms here."},
      std::max(std::abs(T - 2.868265699), std::abs(F - 1.282689390)));
}

// xi'^2 + 4/5 xi^(5/2) = 1 all along, and by sixth-order differences xi' is the rate of xi and -xi^(3/2) that of xi';
// near touch, where xi^(3/2) has no further derivatives, a series takes their place.
TEST(HertzMotionTest, SatisfiesEnergyAndMotion) {
  const double duration = hertz_peaks(unit).duration, h = 2e-3;
  const VectorXd stencil = VectorXd::LinSpaced(7, -3 * h, 3 * h);
  const Eigen::Matrix<double, 7, 1> d{-1 / 60.0, 0.15, -0.75, 0, 0.75, -0.15, 1 / 60.0};
  for (double t = 0.1; t < duration - 0.1; t += 0.0173) {
    const HertzMotion m = hertz_motion(unit, stencil.array() + t);
    const double x = m.approach[3], v = m.rate[3];
    EXPECT_NEAR(v * v + 0.8 * std::pow(x, 2.5), 1, 3e-15) << t;
    EXPECT_NEAR(m.force[3], std::pow(x, 1.5), 1e-15) << t;
    // rounding 1e-16 / h, truncation h^6 x^(8)/140, x^(8) < 1e4 at t = 0.1
    EXPECT_NEAR(d.dot(m.approach) / h, v, 1e-12) << t;
    EXPECT_NEAR(d.dot(m.rate) / h, -m.force[3], 2e-12) << t;
  }
}

// xi = tau - 4/35 tau^(7/2) + 1/175 tau^6 - ...: each term from the one before it by xi'' = -xi^(3/2).
TEST(HertzMotionVerification, StartsLikeItsSeries) {
  for (const double t : {1e-300, 1e-12, 1e-4, 1e-3, 0.01, 0.05}) {
    const double power = std::pow(t, 2.5);
    const HertzMotion m = hertz_motion(unit, VectorXd::Constant(1, t));
    const double series = 1 - 4.0 / 35 * power + power * power / 175;
    EXPECT_NEAR(m.approach[0], t * series, t * (5e-16 + 1e-3 * power * power * power)) << t;
    EXPECT_NEAR(m.rate[0], 1 - 0.4 * power + 6.0 / 175 * power * power, 5e-16 + 0.01 * power * power * power) << t;
  }
}

TEST(HertzMotionTest, IsSymmetricAndFliesFree) {
  const HertzImpact impact{0.7, 3e9, 1.9};
  const HertzPeaks peaks = hertz_peaks(impact);
  const VectorXd t = VectorXd::LinSpaced(101, 0, peaks.duration);
  const HertzMotion m = hertz_motion(impact, t), back = hertz_motion(impact, peaks.duration - t.array());
  EXPECT_LT((m.approach - back.approach).cwiseAbs().maxCoeff(), 1e-15 * peaks.approach * 4);
  EXPECT_LT((m.rate + back.rate).cwiseAbs().maxCoeff(), 1e-14 * impact.speed);
  EXPECT_NEAR(m.approach[50], peaks.approach, 1e-15 * peaks.approach * 4);
  EXPECT_NEAR(m.force[50], peaks.force, 1e-14 * peaks.force);
  EXPECT_NEAR(m.rate[50], 0, 1e-14 * impact.speed);
  const HertzMotion away = hertz_motion(impact, Eigen::Vector2d(-0.4, peaks.duration + 0.25));
  EXPECT_NEAR(away.approach[0], -0.4 * impact.speed, 1e-15);
  EXPECT_NEAR(away.approach[1], -0.25 * impact.speed, 1e-15);
  EXPECT_EQ(away.rate[0], impact.speed);
  EXPECT_EQ(away.rate[1], -impact.speed);
  EXPECT_EQ(away.force.norm(), 0);
}

// Impulse 2 m v and scaling by dimensions: Simpson's rule errs by h^(5/2) where the force starts as t^(3/2).
TEST(HertzMotionTest, TransfersTwiceTheMomentum) {
  const HertzImpact impact{0.7, 3e9, 1.9};
  const double duration = hertz_peaks(impact).duration;
  const Index n = 2000;
  const HertzMotion m = hertz_motion(impact, VectorXd::LinSpaced(n + 1, 0, duration));
  double impulse = 0;
  for (Index i = 1; i < n; ++i) impulse += (i % 2 ? 4 : 2) * m.force[i];
  impulse *= duration / static_cast<double>(n) / 3;
  EXPECT_NEAR(impulse, 2 * impact.mass * impact.speed, 1e-8 * impulse);
}

TEST(HertzMotionTest, RefusesBadInput) {
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(hertz_peaks({bad, 1, 1}), std::invalid_argument);
    EXPECT_THROW(hertz_peaks({1, bad, 1}), std::invalid_argument);
    EXPECT_THROW(hertz_motion({1, 1, bad}, VectorXd::Zero(1)), std::invalid_argument);
  }
  EXPECT_THROW(hertz_motion(unit, VectorXd::Constant(1, std::nan(""))), std::invalid_argument);
  EXPECT_EQ(hertz_motion(unit, VectorXd()).force.size(), 0);
}

}  // namespace
}  // namespace mb
