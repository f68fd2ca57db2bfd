#include "modal/contact/contact_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mb {
namespace {

constexpr double m = 0.3, k = 4e5;  // [kg], [N/m]

// A rigid body of one sample below its centroid, on a layer of stiffness k: while it touches, an oscillator.
FloatingBody on_a_spring(double damping = 0) {
  FloatingBody body{
      true, m, Eigen::Vector3d(1e-3, 2e-3, 2.5e-3).asDiagonal(), Vector3d::Zero(), {}, VectorXd(0), MatrixXd(0, 0), {}};
  SurfaceSamples samples{Vector3d(0, 0, -0.1), VectorXd::Constant(1, 1e-2), MatrixXd(3, 0), MatrixXd(3, 0)};
  body.contacts.push_back({samples, {HalfSpace{}, 0, {}}, {k / 1e-2, damping, {}}});
  return body;
}
ContactState touching(const FloatingBody& body, double speed) {
  const Index r = body.n_modes();
  return {{{0, 0, 0.1},
           {0, 0, -speed},
           {1, 0, 0, 0},
           Vector3d::Zero(),
           VectorXd::Zero(r),
           VectorXd::Zero(r),
           VectorXd::Zero(body.n_static())},
          {},
          Vector3d::Zero(),
          0};
}
// Two modes, seen by the sample, and some by the others around.
FloatingBody vibrating(double damping = 0) {
  FloatingBody body = on_a_spring(damping);
  body.gravity = {0.3, 0, -9.81};
  body.modes = {roots({4e6, 40}), roots({2.5e7, 100})};
  body.weight = VectorXd::Zero(2);
  SurfaceSamples& s = body.contacts[0].samples;
  s.X.resize(3, 5);
  s.X << 0, 0.02, -0.02, 0, 0, 0, 0, 0, 0.02, -0.03, -0.1, -0.0995, -0.0995, -0.0995, -0.0993;
  s.w = VectorXd::Constant(5, 2e-3);
  s.Phi.resize(15, 2);
  for (Index i = 0; i < 15; ++i)
    s.Phi.row(i) << std::sin(1.0 + static_cast<double>(i)), std::cos(2.0 * static_cast<double>(i));
  s.Psi = MatrixXd(15, 0);
  return body;
}

// Over half a period of the oscillator.
double error(ContactScheme scheme, int n) {
  const FloatingBody body = on_a_spring();
  const double omega = std::sqrt(k / m), T = 0.8 * pi / omega, v = 2;
  ContactStepper stepper(body, scheme, T / n);
  ContactState state = touching(body, v);
  stepper.touch(state);
  for (int i = 0; i < n; ++i) EXPECT_TRUE(stepper.advance(state));
  return std::abs(state.body.v.z() + v * std::cos(omega * T)) / v;
}

TEST(ContactStep, ConvergesToTheOscillatorWithItsOrder) {
  for (const auto& [scheme, order] : {std::pair{ContactScheme::exact, 2.0},
                                      {ContactScheme::newmark, 2.0},
                                      {ContactScheme::central_difference, 2.0},
                                      {ContactScheme::symplectic_euler, 1.0},
                                      {ContactScheme::explicit_euler, 1.0}}) {
    const double coarse = error(scheme, 64), fine = error(scheme, 128);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.05);
    EXPECT_LT(fine, scheme == ContactScheme::explicit_euler ? 0.04 : 0.02);
  }
}

TEST(ContactStep, HandsOverMomentumExactly) {
  for (const auto scheme : {ContactScheme::exact, ContactScheme::newmark, ContactScheme::symplectic_euler,
                            ContactScheme::central_difference, ContactScheme::explicit_euler}) {
    const FloatingBody body = vibrating(0.2);
    const double h = 2e-6;
    ContactStepper stepper(body, scheme, h);
    ContactState state = touching(body, 1.5);
    const Vector3d before = m * state.body.v;
    stepper.touch(state);
    const int n = 700;
    for (int i = 0; i < n; ++i) ASSERT_TRUE(stepper.advance(state));
    ASSERT_GT(state.impulse.norm(), 0.1);
    const Vector3d defect = m * state.body.v - before - state.impulse - n * h * m * body.gravity;
    EXPECT_LT(defect.norm(), 1e-10 * state.impulse.norm());
  }
}

// Kinetic energy after a touch over that before it, by steps x/omega from the touch on.
double returned_energy(ContactScheme scheme, double x) {
  const FloatingBody body = on_a_spring();
  ContactStepper stepper(body, scheme, x / std::sqrt(k / m));
  ContactState state = touching(body, 1);
  stepper.touch(state);
  int n = 0;
  do EXPECT_TRUE(stepper.advance(state));
  while (state.body.c.z() < 0.1 && ++n < 1000);
  EXPECT_LT(n, 1000);
  return state.body.v.squaredNorm();
}

// g/(1 - g), g = x^2/4 (harness/analysis/contact_stability.h): met by steps that end the touch half way.
TEST(ContactStep, WhatOpensWithinAStepGainsUpToItsBound) {
  for (const auto scheme : {ContactScheme::exact, ContactScheme::newmark, ContactScheme::symplectic_euler,
                            ContactScheme::central_difference}) {
    double most = 0;
    for (double x = 0.05; x < 1.2; x *= 1.001) {
      const double g = x * x / 4, bound = g / (1 - g), gain = returned_energy(scheme, x) - 1;
      EXPECT_GE(gain, -1e-8) << x;  // Newton's tolerance of 1e-10 over some sixty steps
      EXPECT_LE(gain, bound + 1e-8) << x;
      most = std::max(most, gain / bound);
    }
    EXPECT_GT(most, 0.99);
  }
}

// Explicit Euler feeds a mass on the layer at every step: (1 + x^2) each, x = omega h.
TEST(ContactStep, ExplicitEulerFeedsWhatItSteps) {
  const FloatingBody body = on_a_spring();
  const double x = 0.02;
  ContactStepper stepper(body, ContactScheme::explicit_euler, x / std::sqrt(k / m));
  ContactState state = touching(body, 1);
  stepper.touch(state);
  const auto energy = [&] { return mechanical_energy(body, state.body) + state.load.stored; };
  const double start = energy();
  const int n = 100;  // 2 of pi radians: within the touch
  for (int i = 0; i < n; ++i) ASSERT_TRUE(stepper.advance(state));
  EXPECT_NEAR(energy() / start, std::pow(1 + x * x, n), 1e-6);
}

// Without losses energy stays but for what steps of order 2 make of it: halved steps, a quarter.
TEST(ContactStep, EnergyErrorFallsWithTheSquareOfTheStep) {
  FloatingBody body = vibrating();
  body.modes = {roots({4e6, 0}), roots({2.5e7, 0})};
  const auto drift = [&](int n) {
    const double T = 1.2e-3;
    ContactStepper stepper(body, ContactScheme::exact, T / n);
    ContactState state = touching(body, 1.5);
    stepper.touch(state);
    const double start = mechanical_energy(body, state.body);
    double largest = 0;
    for (int i = 0; i < n; ++i) {
      EXPECT_TRUE(stepper.advance(state));
      largest = std::max(largest, std::abs(mechanical_energy(body, state.body) + state.load.stored - start));
    }
    return largest / start;
  };
  const double coarse = drift(400), fine = drift(1600);
  EXPECT_LT(fine, 2e-3);
  EXPECT_LT(fine, coarse / 8);  // 16 but for the kinks where samples begin to press
}

TEST(ContactStep, SchemesAgree) {
  const FloatingBody body = vibrating(0.1);
  const auto end = [&](ContactScheme scheme, double h) {
    ContactStepper stepper(body, scheme, h);
    ContactState state = touching(body, 1.5);
    stepper.touch(state);
    for (int i = 0, n = static_cast<int>(std::lround(1e-3 / h)); i < n; ++i) EXPECT_TRUE(stepper.advance(state));
    return state;
  };
  const ContactState a = end(ContactScheme::exact, 5e-7), b = end(ContactScheme::newmark, 5e-7),
                     c = end(ContactScheme::symplectic_euler, 5e-8), d = end(ContactScheme::central_difference, 5e-7),
                     e = end(ContactScheme::explicit_euler, 5e-8);
  const double q = a.body.q.norm(), L = a.body.L.norm();
  EXPECT_GT(L, 3e-5);  // it does turn
  for (const ContactState& other : {b, c, d, e}) {
    EXPECT_LT((a.body.q - other.body.q).norm(), 1e-3 * q);
    EXPECT_LT((a.body.L - other.body.L).norm(), 1e-3 * L);
  }
}

// A kilometre from the origin places round by 1e-13 m, which this layer makes a hundredth of a newton of: Newton's
// method comes no nearer than that times the step, 1e-9 of the momentum. Motion is as near the origin, to what hundred
// such steps add up to.
TEST(ContactStep, AverageAccelerationEndsWhereRoundingStopsIt) {
  const double T = 1e-4;
  const auto speed_after = [&](const Vector3d& away) {
    FloatingBody body = vibrating();
    SampledContact& contact = body.contacts[0];
    contact.law.stiffness *= 1e6;
    contact.surface.shape = Sphere{0.5};  // a general pair, which knows places alone
    contact.surface.pose.position = away - Vector3d(0, 0, 0.5);
    ContactState state = touching(body, 2);
    state.body.c += away;
    ContactStepper stepper(body, ContactScheme::newmark, T / 100);
    stepper.touch(state);
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(stepper.advance(state)) << i;
    return state.body.v;
  };
  const Vector3d here = speed_after(Vector3d::Zero()), there = speed_after({600, -700, 400});
  EXPECT_LT((here - there).norm(), 1e-6 * here.norm());
  EXPECT_GT(here.z(), 0);  // it has bounced
}

// General and flat evaluation of one half-space: friction of a vanishing coefficient takes the general one.
TEST(ContactLoad, FlatAndGeneralAgree) {
  FloatingBody flat = vibrating(0.3), general = flat;
  general.contacts[0].law.friction = Friction{1e-14, 1.0};
  ContactLoads on_flat(flat), on_general(general);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    ContactState state = touching(flat, 1);
    state.body.c.z() -= 1e-3;
    state.body.Q = Eigen::Quaterniond(Eigen::AngleAxisd(0.02 * normal(random), Vector3d(1, 2, 0).normalized()));
    for (Index i = 0; i < 2; ++i) state.body.q[i] = 1e-3 * normal(random), state.body.p[i] = normal(random);
    const Vector3d Omega(normal(random), normal(random), normal(random));
    ContactLoad a, b;
    on_flat(state.body, Omega, a);
    on_general(state.body, Omega, b);
    const double f = 1e-9 * (a.force.norm() + 1);
    EXPECT_NEAR((a.force - b.force).norm(), 0, f);
    EXPECT_NEAR((a.torque - b.torque).norm(), 0, f);
    EXPECT_NEAR((a.modal - b.modal).norm(), 0, 10 * f);
    EXPECT_NEAR(a.stored, b.stored, 1e-9 * (a.stored + 1e-6));
    EXPECT_NEAR(a.least_gap, b.least_gap, 1e-15);
  }
}

TEST(ContactLoad, StaticShapesAreInBalance) {
  for (const bool friction : {false, true}) {
    FloatingBody body = vibrating();
    SurfaceSamples& s = body.contacts[0].samples;
    s.Psi.resize(15, 2);
    for (Index i = 0; i < 15; ++i) s.Psi.row(i) << (i % 3 == 2 ? 0.02 : 0.003), 0.01 * std::sin(static_cast<double>(i));
    body.static_stiffness = MatrixXd::Identity(2, 2);
    if (friction) body.contacts[0].law.friction = Friction{0.2, 0.1};
    ContactLoads loads(body);
    ContactState state = touching(body, 1);
    state.body.c.z() -= 2e-3;
    ContactLoad load;
    loads(state.body, Vector3d::Zero(), load);
    EXPECT_TRUE(load.converged);
    EXPECT_GT(state.body.s.norm(), 0);
    // The same forces from samples moved by hand.
    FloatingBody moved = vibrating();
    moved.contacts[0].law = body.contacts[0].law;
    moved.contacts[0].samples.X += (s.Psi * state.body.s).reshaped(3, 5);
    ContactLoads again(moved);
    ContactState same = touching(moved, 1);
    same.body.c.z() -= 2e-3;
    ContactLoad with;
    again(same.body, Vector3d::Zero(), with);
    EXPECT_NEAR((load.force - with.force).norm(), 0, 1e-9 * load.force.norm());
  }
}

TEST(ContactStep, NoStepIsNoStepper) {
  const FloatingBody body = on_a_spring();
  EXPECT_THROW(ContactStepper(body, ContactScheme::exact, 0), std::invalid_argument);
  EXPECT_THROW(ContactStepper(body, ContactScheme::exact, std::nan("")), std::invalid_argument);
  EXPECT_FALSE(contact_scheme("sundials"));
}

}  // namespace
}  // namespace mb
