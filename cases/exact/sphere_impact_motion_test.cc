// The motion of a finite sphere's impact, against its equation of motion and Hertz's.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/exact/sphere_impact.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"

namespace mb {
namespace {

const Material rubbery{2e9, 0.3, 1100};
constexpr double R = 0.03;
const double mass = 4 * pi / 3 * R * R * R * 1100;

// The speed at which Hertz's a/R is alpha; k_n a/E* = layers; the weight by the largest force.
SphereImpact reaching(double alpha, double layers, double weight = 0) {
  const double modulus = contact_modulus(rubbery);
  const double speed = std::sqrt(4 * modulus * std::pow(alpha, 5) / (5 * pi * rubbery.density));
  const double force = hertz_peaks({mass, hertz_stiffness({R, modulus}), speed}).force;
  return {rubbery, R, speed, layers * modulus / (R * alpha), weight * force / mass};
}

// x' = dx/dt and m x'' = m g - F by differences of fourth order, whose error is 1e-9 away from touch and release, where
// higher derivatives of the force have no bound.
TEST(SphereImpactVerification, MotionObeysItsEquation) {
  for (const double weight : {0.0, 0.005}) {
    const SphereImpact impact = reaching(0.05, 100, weight);
    const auto [T, peak, approach, radius] = sphere_impact(impact);
    const Index n = 26;
    const double h = 1e-3 * T;
    const VectorXd first{{1.0 / 12, -2.0 / 3, 0, 2.0 / 3, -1.0 / 12}};
    VectorXd t(5 * n);
    for (Index k = 0; k < n; ++k)
      t.segment(5 * k, 5) = T * (0.04 + 0.0365 * static_cast<double>(k)) + h * VectorXd::LinSpaced(5, -2, 2).array();
    const SphereImpactMotion motion = sphere_impact_motion(impact, t);
    for (Index k = 0; k < 5 * n; k += 5) {
      EXPECT_NEAR(first.dot(motion.approach.segment(k, 5)) / h, motion.rate[k + 2], 1e-6 * impact.speed) << t[k] / T;
      const double pushed = mass * (impact.gravity - first.dot(motion.rate.segment(k, 5)) / h);
      EXPECT_NEAR(pushed, motion.force[k + 2], 1e-6 * peak) << t[k] / T;
    }
  }
}

TEST(SphereImpactVerification, WayOutMirrorsTheWayIn) {
  const SphereImpact impact = reaching(0.1, 80, 0.004);
  const auto [T, peak, approach, radius] = sphere_impact(impact);
  const VectorXd t = T * VectorXd::LinSpaced(41, -0.5, 1.5);
  const SphereImpactMotion motion = sphere_impact_motion(impact, t);
  const double tiny = 1e-10;  // T/2 is known to rounding, its neighbourhood to that over the speed
  for (Index k = 0; k < t.size(); ++k) {
    EXPECT_NEAR(motion.approach[k], motion.approach[t.size() - 1 - k], tiny * approach);
    EXPECT_NEAR(motion.rate[k], -motion.rate[t.size() - 1 - k], tiny * impact.speed);
    EXPECT_EQ(motion.force[k] > 1e-9 * peak, k > 10 && k < 30);
  }
  EXPECT_NEAR(motion.force[20], peak, 1e-9 * peak);
  EXPECT_NEAR(motion.approach[20], approach, 1e-9 * approach);
  EXPECT_NEAR(motion.approach[0], -0.5 * T * (impact.speed - impact.gravity * T / 4), 1e-12 * approach);
}

// As a/R falls, so does the distance to Hertz's motion, in proportion to alpha ln alpha.
TEST(SphereImpactVerification, MotionTendsToHertz) {
  double before = 0;
  for (const double alpha : {0.08, 0.02, 0.005}) {
    const SphereImpact impact = reaching(alpha, std::numeric_limits<double>::infinity());
    const HertzImpact limit{mass, hertz_stiffness({R, contact_modulus(rubbery)}), impact.speed};
    const VectorXd t = hertz_peaks(limit).duration * VectorXd::LinSpaced(60, -0.1, 1.1);
    const VectorXd force = sphere_impact_motion(impact, t).force;
    const double off = (force - hertz_motion(limit, t).force).cwiseAbs().maxCoeff() / hertz_peaks(limit).force;
    EXPECT_LT(off, alpha * -std::log(alpha) / 2);
    if (before > 0) {
      EXPECT_LT(off, before / 2.5);
    }
    before = off;
  }
}

// The layer's energy is the integral of p^2/(2 k_n) over Hertz's disc, p_0^2 pi a^2/(4 k_n).
TEST(SphereImpactVerification, LayerHoldsHertzsPressure) {
  const SphereImpact impact = reaching(0.02, 100);
  const auto peaks = sphere_impact(impact);
  const SphereImpactMotion motion = sphere_impact_motion(impact, VectorXd::Constant(1, peaks.duration / 2));
  const HertzState state = hertz_under({R, contact_modulus(rubbery)}, peaks.force);
  const double expected =
      state.peak_pressure * state.peak_pressure * pi * std::pow(state.contact_radius, 2) / (4 * impact.layer_stiffness);
  EXPECT_NEAR(motion.layer_energy[0], expected, 1e-9 * expected);
}

TEST(SphereImpactTest, MotionRefusesBadInput) {
  const SphereImpact good = reaching(0.05, 100);
  EXPECT_THROW(sphere_impact_motion(good, VectorXd::Constant(1, std::nan(""))), std::invalid_argument);
  for (const double bad : {-1.0, std::nan(""), 1e9 /* heavy */}) {
    SphereImpact impact = good;
    impact.gravity = bad;
    EXPECT_THROW(sphere_impact_motion(impact, VectorXd::Zero(1)), std::invalid_argument);
  }
  EXPECT_EQ(sphere_impact_motion(good, VectorXd()).force.size(), 0);
}

}  // namespace
}  // namespace mb
