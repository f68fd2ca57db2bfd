#include "cases/exact/sphere_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/exact/ode.h"
#include "cases/exact/sphere_on_plane.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
const Material rubbery{2e9, 0.3, 1100};

HertzPeaks hertz(const SphereImpact& impact) {
  const double m = 4 * pi / 3 * std::pow(impact.radius, 3) * impact.material.density;
  return hertz_peaks({m, hertz_stiffness({impact.radius, contact_modulus(impact.material)}), impact.speed});
}

// The speed at which Hertz's a/R is alpha: m v^2/2 = 8/15 E* R^3 alpha^5.
SphereImpact reaching(double alpha, double layers = inf) {
  const double modulus = contact_modulus(rubbery), R = 0.03;
  const double speed = std::sqrt(4 * modulus * std::pow(alpha, 5) / (5 * pi * rubbery.density));
  return {rubbery, R, speed, layers * modulus / (R * alpha)};
}

// An impact at the speed whose kinetic energy is the elastic energy of a solved contact ends in that contact. Between
// the two contacts that the expansion meets, it leaves alpha^3 ln alpha.
TEST(SphereImpactVerification, EndsInTheSolvedContact) {
  const double modulus = contact_modulus(rubbery), R = 0.03, m = 4 * pi / 3 * std::pow(R, 3) * rubbery.density;
  for (const double a : {0.02, 0.1, 0.2}) {
    const SphereOnPlane contact = sphere_on_plane(a, rubbery.poissons_ratio);
    const double speed = std::sqrt(2 * contact.energy * modulus * std::pow(R, 3) / m), tolerance = 0.01 * a * a * a;
    const SphereImpactPeaks peaks = sphere_impact({rubbery, R, speed, inf});
    EXPECT_NEAR(peaks.force / (modulus * R * R), contact.force, tolerance * contact.force) << a;
    EXPECT_NEAR(peaks.approach / R, contact.approach, tolerance * contact.approach) << a;
  }
}

// By perturbation: W = 2/5 alpha^5 + epsilon/2 alpha_m^-1 alpha^6, where D makes of C + D ln alpha what stands below.
// alpha_m falls by epsilon/4, force by 3/4 epsilon: the sphere is stiffer than a half-space.
TEST(SphereImpactVerification, TendsToHertz) {
  for (const double alpha : {0.01, 0.03}) {
    const SphereImpact impact = reaching(alpha);
    const SphereImpactPeaks peaks = sphere_impact(impact);
    const HertzPeaks limit = hertz(impact);
    const SmallContact small = small_contact(rubbery.poissons_ratio, PressureAlong::plane_normal);
    const double epsilon = alpha * (small.constant + small.logarithm * (std::log(alpha) + 1.0 / 6));
    EXPECT_NEAR(peaks.force / limit.force - 1, -0.75 * epsilon, 2 * alpha * alpha);
    EXPECT_NEAR(peaks.contact_radius, impact.radius * alpha * (1 - epsilon / 4), impact.radius * alpha * alpha * alpha);
    EXPECT_GT(peaks.force, limit.force);
    EXPECT_LT(peaks.duration, limit.duration);
    EXPECT_LT(peaks.approach, limit.approach);
  }
}

void expect_duration(double duration, double by_steps) {
  testing::expect_verified(
      {.quantity = "duration of the impact of a finite sphere, a/R = 0.05, on a layer with k_n a/E* = 100, relative",
       .reference = "second route",
       .source = "the equation of motion by extrapolation in time (cases/exact/ode.h), instead of the energy integral",
       .uncertainty = "about 1e-9, the sum of steps held to 1e-11 each",
       .tolerance = 1e-8,
       .why = "Ten times the error of the steps in time, for the contact's radius rises steeply where the layer gives "
              "way first."},
      1 - by_steps / duration);
}

// The expansion as the header states it, its motion integrated in time with alpha as the unknown.
TEST(SphereImpactVerification, EquationOfMotionWithALayer) {
  const double a = 0.05;
  const SphereImpact impact = reaching(a, 100);  // k_n a/E* = 100: 0.3 % more approach at the peak
  const double modulus = contact_modulus(rubbery), R = impact.radius, nu = rubbery.poissons_ratio;
  const double m = 4 * pi / 3 * std::pow(R, 3) * rubbery.density, layer = modulus / (pi * impact.layer_stiffness * R);
  const SmallContact small = small_contact(nu, PressureAlong::plane_normal);
  Eigen::Matrix2d equations;
  Eigen::Vector2d rest;
  for (int i = 0; i < 2; ++i) {
    const SphereOnPlane contact = sphere_on_plane(i == 0 ? a : a / 2, nu);
    const double alpha = std::cbrt(0.75 * contact.force), first = small.constant + small.logarithm * std::log(alpha);
    equations.row(i) << 1, std::log(alpha);
    rest[i] = (contact.approach / (alpha * alpha) - 1 - alpha * first) / (alpha * alpha);
  }
  const Eigen::Vector2d E_G = equations.inverse() * rest;
  const auto x = [&](double alpha) {
    const double l = std::log(alpha), first = small.constant + small.logarithm * l, second = E_G[0] + E_G[1] * l;
    return alpha * (layer + alpha * (1 + alpha * (first + alpha * second)));
  };
  const double unit = R / impact.speed;
  const Derivative f = [&](double, const VectorXd& y) {  // alpha, x'/v; times in R/v
    const double alpha = std::max(y[0], 1e-200), l = std::log(alpha), first = small.constant + small.logarithm * l;
    const double slope =
        layer + alpha * (2 + alpha * (3 * first + small.logarithm + alpha * (4 * E_G[0] + E_G[1] + 4 * E_G[1] * l)));
    return VectorXd{{y[1] / slope, -4.0 / 3 * modulus * R * R * std::pow(alpha, 3) / m * unit / impact.speed}};
  };
  const OdeState peak = integrate_to_zero(f, {0, VectorXd{{0.0, 1.0}}}, 1, {1e-11, 1e-14});
  const SphereImpactPeaks peaks = sphere_impact(impact);
  EXPECT_NEAR(peaks.contact_radius / R, peak.y[0], 1e-9 * peak.y[0]);
  EXPECT_NEAR(peaks.approach / R, x(peak.y[0]), 1e-9 * x(peak.y[0]));
  expect_duration(peaks.duration, 2 * peak.t * unit);

  SphereImpact bare = impact;
  bare.layer_stiffness = inf;
  const SphereImpactPeaks hard = sphere_impact(bare);
  EXPECT_GT(peaks.duration, hard.duration);
  EXPECT_LT(peaks.force, hard.force);
}

TEST(SphereImpactTest, RefusesBadInput) {
  const SphereImpact good = reaching(0.05);
  const double nan = std::nan("");
  for (const double bad : {0.0, -1.0, nan, inf}) {
    SphereImpact impact = good;
    impact.radius = bad;
    EXPECT_THROW(sphere_impact(impact), std::invalid_argument);
    impact = good;
    impact.speed = bad;
    EXPECT_THROW(sphere_impact(impact), std::invalid_argument);
    impact = good;
    impact.material.density = bad;
    EXPECT_THROW(sphere_impact(impact), std::invalid_argument);
  }
  for (const double bad : {0.0, -1.0, nan, 1e3 /* too soft */}) {
    SphereImpact impact = good;
    impact.layer_stiffness = bad;
    EXPECT_THROW(sphere_impact(impact), std::invalid_argument);
  }
  EXPECT_THROW(sphere_impact(reaching(0.003)), std::invalid_argument);
  EXPECT_THROW(sphere_impact(reaching(0.3)), std::invalid_argument);
}

}  // namespace
}  // namespace mb
