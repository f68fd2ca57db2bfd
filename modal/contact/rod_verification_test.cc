// A rod, nu = 0, thrown end-on at a wall, k_n L/E = 100, as modes in contact have it. Its modes are known, free at both
// ends and all of amplitude sqrt(2/m) at the end that touches, and so is what those beyond the r-th yield there:
//
//   phi_i = sqrt(2/m) cos(i pi x/L),   omega_i = i pi c/L,   1/K_s = sum_{i > r} 2 L/(E A pi^2 i^2) ~ 2 L/(E A pi^2 r)
//
// against the waves of cases/exact/rod_impact.h: rho c v on the face for 2 L/c (Graff 1975, Wave Motion in Elastic
// Solids, sect. 2.4). Pointwise, modes overshoot: the force's mean over 0.1 to 0.9 of the contact is compared.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/rod_impact.h"
#include "mechanics/verified_test.h"
#include "modal/contact/floating_bodies_test.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::expect_verified;
using testing::floating;
using testing::ground;
using testing::no_modes;
using testing::plan_of;

constexpr double L = 0.1, edge = 0.01, A = edge * edge, E = 1e7, rho = 1000, v = 0.1;  // of cases/rod-on-wall.toml
constexpr double k_n = 100 * E / L;                                                    // [Pa/m]
const double c = std::sqrt(E / rho), m = rho * A * L;
const Shape rod = Box{Vector3d(edge, edge, L)};

// r modes at four samples of the face, with what the others yield as a static shape or without. From the touch on.
ImpactPlan thrown(int r, bool yields, ContactScheme scheme) {
  std::vector<Roots> modes;
  double beyond = pi * pi / 6;  // sum_{i > r} 1/i^2
  for (int i = 1; i <= r; ++i) {
    modes.push_back(roots({std::pow(i * pi * c / L, 2), 0}));
    beyond -= 1.0 / i / i;
  }
  FloatingBody body = floating(rod, modes, Vector3d::Zero());
  const Index n_static = yields ? 1 : 0;
  SurfaceSamples face{Matrix3Xd(3, 4), VectorXd::Constant(4, A / 4), MatrixXd::Zero(12, r),
                      MatrixXd::Zero(12, n_static)};
  for (Index k = 0; k < 4; ++k) {
    face.X.col(k) = Vector3d(k % 2 ? edge / 4 : -edge / 4, k / 2 ? edge / 4 : -edge / 4, -L / 2);
    face.Phi.row(3 * k + 2).setConstant(std::sqrt(2 / m));
    face.Psi.row(3 * k + 2).setOnes();
  }
  if (yields) body.static_stiffness = MatrixXd::Constant(1, 1, E * A / L * pi * pi / 2 / beyond);
  body.contacts.push_back({face, ground, {k_n, 0, {}}});
  ImpactPlan plan = plan_of(body, rod, no_modes(rod), at_rest(body, {0, 0, L / 2}, {0, 0, -v}), scheme,
                            L / c / (pi * r));  // omega_r h = 1
  plan.flies = false;                           // 4 samples are no surface
  return plan;
}

// Relative to rho c v, to the waves' duration and to the speed before.
struct Bounce {
  double mean, duration, restitution;
};
Bounce bounce(int r, bool yields, ContactScheme scheme) {
  const double T = RodImpactWaves({L, E, rho, v, k_n}).contact().duration;
  const ImpactMotion motion = impact_motion(thrown(r, yields, scheme), VectorXd{{0.1 * T, 0.9 * T, 1.5 * T}});
  EXPECT_EQ(motion.status, Status::ok);
  if (motion.contact.touches.empty()) return {0, 0, 0};
  const auto J = motion.contact.impulse.row(2);
  return {(J[1] - J[0]) / (0.8 * T * A) / (rho * c * v), motion.contact.touches.back().end / T, J[2] / (m * v) - 1};
}

// Mean stress and duration within 1 %, rebound at 0.99 of the speed or more. The waves' own: T is 0.84 % above 2 L/c,
// and the layer takes 0.05 % of the speed.
void expect_of_a_hard_wall(const Bounce& of) {
  EXPECT_NEAR(of.mean, 1, 0.01);
  EXPECT_NEAR(of.duration, 1, 0.01);
  EXPECT_NEAR(of.duration * (1 + 1.678347 / 200), 1, 0.013);  // of 2 L/c
  EXPECT_GE(of.restitution, 0.99);
  EXPECT_LE(of.restitution, 1.001);
}

void expect_verified_of_1024_modes(const Bounce& of) {
  const std::string waves =
      "waves, Graff 1975, Wave Motion in Elastic Solids, sect. 2.4, with the layer in closed form";
  expect_verified(
      {.quantity = "mean force of 1024 modes of a rod on a wall over 0.1 to 0.9 of the contact, relative",
       .reference = "exact solution",
       .source = waves,
       .uncertainty = "2e-9: the layer has come to its balance but for e^-20",
       .tolerance = 1e-6,
       .why = "Momentum of the wave's front fixes the mean; the ripple of 1024 modes cancels in it, for which "
              "no bound is derived."},
      of.mean - 1);
  expect_verified(
      {.quantity = "duration of the contact of 1024 modes of a rod with a wall, relative",
       .reference = "exact solution",
       .source = waves,
       .uncertainty = "rounding",
       .tolerance = 1.678347 / 200 * 30 / 1024,
       .why = "Modes left out would yield 20/r of the layer and shorten its share of the contact by as much; "
              "half as much again is room."},
      of.duration - 1);
}

TEST(ModalRodVerification, ManyModesPressAsWavesDo) {
  for (const int r : {64, 256, 1024}) {
    SCOPED_TRACE(r);
    const Bounce exact = bounce(r, false, ContactScheme::exact);
    expect_of_a_hard_wall(exact);
    // What is missing, 2 L/(E A pi^2 r), yields 20/r of the layer: the contact is shorter by some of 1.678/200 as much.
    EXPECT_NEAR(exact.duration, 1, 1.678347 / 200 * 30 / r);
  }
  const Bounce many = bounce(1024, false, ContactScheme::exact);
  EXPECT_NEAR(many.restitution, 1 - 0.103423 / 200, 1e-4);
  expect_verified_of_1024_modes(many);
}

TEST(ModalRodVerification, AStaticShapeStandsForTheModesLeftOut) {
  for (const auto scheme : {ContactScheme::exact, ContactScheme::newmark})
    for (const int r : {64, 128}) {
      SCOPED_TRACE(r);
      expect_of_a_hard_wall(bounce(r, true, scheme));
    }
  const double with = bounce(64, true, ContactScheme::exact).duration;
  EXPECT_LT(std::abs(with - 1), 0.3 * std::abs(bounce(64, false, ContactScheme::exact).duration - 1));
}

// Few modes are thrown off the layer again and again; all of their touches together are still one impact.
TEST(ModalRodVerification, ChatterAddsUpToTheImpact) {
  const ImpactMotion motion = impact_motion(thrown(16, false, ContactScheme::exact), VectorXd{{0.0035}});
  const auto& touches = motion.contact.touches;
  ASSERT_GT(touches.size(), 5u);
  EXPECT_LT(touches.front().end, 0.2 * 2 * L / c);
  EXPECT_NEAR(touches.back().end, 2 * L / c, 0.02 * 2 * L / c);
  double impulse = 0;
  for (const Touch& touch : touches) impulse += touch.impulse.z();
  EXPECT_NEAR(impulse, 2 * m * v, 0.02 * m * v);
  EXPECT_NEAR(bounce(16, false, ContactScheme::exact).mean, 1, 0.02);  // 0.8 %
}

}  // namespace
}  // namespace mb
