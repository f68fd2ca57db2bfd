#include "harness/analysis/stability_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/catalogue.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/oscillators_test.h"
#include "mechanics/system/stability.h"

namespace mb {
namespace {

const VectorXd omega{{10, 25, 80}};

MappedSystem under_a_pulse(const Rayleigh& damping) {
  System system = test::oscillators(omega, damping);
  system.F = VectorXd{{1, -2, 3}};
  system.s = {Pulse{.duration = 0.5}};
  return mapped_system(system, VectorXd::LinSpaced(101, 0, 1), 1, 1e-6);
}

StepCell cell(const MappedSystem& mapped, const std::string& integrator, double dt) {
  return step_cell(mapped, default_catalogue().integrator(integrator), dt, 1000);
}

TEST(StabilityGrid, ExplicitStepsAreUnstableBeyondTheLimitOfTheirAmplification) {
  for (const double beta : {0.0, 1e-3}) {
    const MappedSystem mapped = under_a_pulse({0, beta});
    for (const char* name : {"central-difference", "symplectic-euler"}) {
      const double limit = predicted_limit(mapped, name);
      EXPECT_NEAR(limit, beta == 0 ? 2.0 / 80 : limit, 1e-8);
      for (const double factor : {0.02, 0.3, 0.99, 1.02, 3.0, 30.0}) {
        const StepCell one = cell(mapped, name, factor * limit);
        EXPECT_EQ(one.found == StepClass::unstable, factor > 1) << name << " " << factor;
        EXPECT_EQ(one.radius > 1 + 1e-9, factor > 1) << name << " " << factor;
        EXPECT_EQ(verdict(one), "as predicted") << name << " " << factor;
        EXPECT_TRUE(one.found == StepClass::stable || factor > 0.02) << name << " " << factor;
      }
    }
  }
}

// A cell without one is neither as predicted nor not: no check would see it.
TEST(StabilityGrid, HasAPredictionForEveryIntegratorOfFixedStep) {
  for (const Integrator& integrator : default_catalogue().integrators) {
    if (integrator.knob != Integrator::Knob::time_step) continue;
    for (const Rayleigh& damping : {Rayleigh{}, Rayleigh{1, 0}, Rayleigh{0, 1e-3}})
      for (const bool is_lumped : {false, true}) {
        System system = test::oscillators(omega, damping);
        if (is_lumped) system.lumped_mass = system.M;
        EXPECT_NE(scheme_of(integrator.name, system), nullptr) << integrator.name;
      }
  }
}

TEST(StabilityGrid, AverageAccelerationIsStableAtAnyStepAndInaccurateAtLargeOnes) {
  const MappedSystem mapped = under_a_pulse({});
  EXPECT_TRUE(std::isinf(predicted_limit(mapped, "newmark")));
  EXPECT_EQ(cell(mapped, "newmark", 1e-3).found, StepClass::stable);
  const StepCell large = cell(mapped, "newmark", 0.4);
  EXPECT_EQ(large.found, StepClass::inaccurate);
  EXPECT_NEAR(large.radius, 1, 1e-12);
  EXPECT_LT(large.energy, 1 + 1e-9);
  EXPECT_EQ(verdict(large), "as predicted");
}

TEST(StabilityGrid, EnergyStaysWithinWhatTheoryAllows) {
  for (const Rayleigh& damping : {Rayleigh{}, Rayleigh{1, 0}, Rayleigh{0, 1e-3}}) {
    const MappedSystem mapped = under_a_pulse(damping);
    for (const char* name : {"newmark", "central-difference", "symplectic-euler"}) {
      for (const double factor : {0.1, 0.5, 0.9}) {
        const StepCell one = cell(mapped, name, factor * predicted_limit(mapped, "central-difference"));
        EXPECT_LE(one.energy, one.bound * (1 + 1e-9)) << name << " " << factor;
      }
    }
  }
  const MappedSystem undamped = under_a_pulse({});
  const StepCell near = cell(undamped, "symplectic-euler", 0.9 * 2 / 80);
  const double bound = (1 / (1 - 0.9 * omega[0] / 80) + 1 / (1 - 0.9 * omega[1] / 80) + 1 / (1 - 0.9)) / 3;
  EXPECT_NEAR(near.bound, bound, 1e-9);
  EXPECT_GT(near.energy, 0.95 * bound) << "theory says how far it swings, not only that it does";
  EXPECT_TRUE(std::isnan(cell(undamped, "symplectic-euler", 1.1 * 2 / 80).bound)) << "past the limit";
  const MappedSystem damped = under_a_pulse({4, 0});
  const StepCell close = cell(damped, "symplectic-euler", 0.999 * predicted_limit(damped, "symplectic-euler"));
  EXPECT_LE(close.energy, close.bound * (1 + 1e-9));
  EXPECT_GT(close.energy, 2 * 1 / (1 - 80 * close.dt / 2) / 3) << "damping lets energy swing wider there";
  EXPECT_TRUE(std::isnan(cell(undamped, "explicit-euler", 1e-4).bound));
}

// Damping lags where the mass is lumped: energy may swing up there, as far as theory says.
TEST(StabilityGrid, EnergyStaysWithinWhatTheoryAllowsWhereDampingLags) {
  for (const double beta : {0.0, 1e-4, 1e-3, 1e-2}) {
    System system = test::oscillators(omega, {0, beta}, true);
    system.F = VectorXd{{1, -2, 3}};
    system.s = {Pulse{.duration = 0.5}};
    const MappedSystem mapped = mapped_system(system, VectorXd::LinSpaced(101, 0, 1), 1, 1e-6);
    const double limit = predicted_limit(mapped, "central-difference");
    const double zeta = 80 * beta / 2;
    EXPECT_NEAR(limit * 80, 2 * (std::sqrt(1 + zeta * zeta) - zeta), 1e-7) << beta;
    double nearest = 0;
    for (const double factor : {0.1, 0.5, 0.9, 0.999}) {
      const StepCell one = cell(mapped, "central-difference", factor * limit);
      EXPECT_EQ(verdict(one), "as predicted") << beta << " " << factor;
      const double x = 80 * one.dt, a = 80 * 80 * beta * one.dt;
      const bool heavy = std::pow(2 - a - x * x, 2) >= 4 * (1 - a);  // steps of the highest mode swing no more
      EXPECT_EQ(std::isnan(one.bound), heavy) << beta << " " << factor;
      if (heavy) continue;
      EXPECT_LE(one.energy, one.bound * (1 + 1e-9)) << beta << " " << factor;
      if (beta == 0) {
        EXPECT_NEAR(one.bound, 1, 1e-9);
      }
      nearest = std::max(nearest, one.energy / one.bound);
    }
    EXPECT_GT(nearest, 0.5) << "a bound that is never near is none";
  }
}

TEST(StabilityGrid, GrowthTooSlowForTheRunIsNotCalledStability) {
  const MappedSystem undamped = under_a_pulse({});
  EXPECT_EQ(predicted_limit(undamped, "explicit-euler"), 0);
  const StepCell slow = cell(undamped, "explicit-euler", 1e-4);  // grows by 6.4e-5 a period of the highest mode
  EXPECT_GT(slow.radius, 1);
  EXPECT_FALSE(slow.predicted.has_value());
  EXPECT_EQ(verdict(slow), "too slow to be seen");
  StepCell still = cell(undamped, "explicit-euler", 1.6e-3);  // x = 0.128: e^16 in 1000 steps, less than 1e4 squared
  EXPECT_EQ(verdict(still), "too slow to be seen");
  still.found = StepClass::stable, still.energy = 1;
  EXPECT_EQ(verdict(still), "not as predicted") << "what is bounded where so much is foretold";
  const StepCell fast = cell(undamped, "explicit-euler", 0.01);
  EXPECT_EQ(fast.found, StepClass::unstable);
  EXPECT_EQ(verdict(fast), "as predicted");
}

// In 1000 steps its energy grows by e^6.4, in the 10000 of the run its motion by e^32.
TEST(StabilityGrid, WhatRunsAwayInMoreStepsThanAreVibratedIsUnstable) {
  System system = test::oscillators(omega, {});
  system.F = VectorXd{{1, -2, 3}};
  system.s = {Pulse{.duration = 0.5}};
  const MappedSystem mapped = mapped_system(system, VectorXd::LinSpaced(101, 0, 10), 10, 1e-6);
  const StepCell away = cell(mapped, "explicit-euler", 1e-3);
  EXPECT_LT(away.energy, energy_bound);
  EXPECT_EQ(away.found, StepClass::unstable);
  EXPECT_TRUE(std::isnan(away.error));
  EXPECT_EQ(verdict(away), "as predicted");
  const StepCell lost = cell(mapped, "explicit-euler", 3e-4);  // by e^9.6 in the 33333 of the run: e^3.2 times the next
  EXPECT_LT(lost.energy, 10);                                  // e^0.6 of its motion in 1000 steps
  EXPECT_EQ(lost.found, StepClass::unstable);
  EXPECT_EQ(verdict(lost), "as predicted");
  StepCell slow = cell(mapped, "explicit-euler", 2e-4);  // by e^6.4 in the 50000 of the run, of next to nothing
  EXPECT_EQ(slow.found, StepClass::inaccurate);
  EXPECT_LT(slow.error, lost_from);
  EXPECT_EQ(verdict(slow), "too slow to be seen");
  slow.found = StepClass::unstable;
  EXPECT_EQ(verdict(slow), "not as predicted") << "a runaway that growth does not explain";
}

// There the energy of what does not grow by rho passes any bound: on both sides, as rounding and little damping have
// it.
TEST(StabilityGrid, AStepAtTheLimitIsNoContradiction) {
  for (const double alpha : {0., 2 * 80 * 1e-7}) {
    const MappedSystem mapped = under_a_pulse({alpha, 0});
    for (const double off : {-1e-5, -1e-15, 0., 1e-15, 1e-8}) {
      const StepCell at = cell(mapped, "symplectic-euler", (1 + off) * 2 / 80);
      EXPECT_EQ(at.found, StepClass::unstable) << alpha << " " << off;
      EXPECT_EQ(verdict(at), "at the limit") << alpha << " " << off;
    }
    for (const double factor : {0.99, 1.01}) {
      const StepCell away = cell(mapped, "symplectic-euler", factor * 2 / 80);
      EXPECT_FALSE(away.at_limit) << factor;
      EXPECT_EQ(verdict(away), "as predicted") << factor;
    }
  }
}

// Damping of the stiffness, taken from one mode again, leaves rounding of either sign.
TEST(StabilityGrid, AModeUndampedButForRoundingHasNoStepOfExplicitEuler) {
  for (const double residue : {1e-16, 0., -1e-16}) {
    System system = test::oscillators(omega, {0, 1e-3});
    system.modal_damping = {VectorXd::Unit(3, 1), VectorXd{{-1e-3 * 625 * (1 + residue)}}};
    system.F = VectorXd{{1, -2, 3}};
    system.s = {Pulse{.duration = 0.5}};
    const MappedSystem mapped = mapped_system(system, VectorXd::LinSpaced(101, 0, 1), 1, 1e-6);
    EXPECT_EQ(predicted_limit(mapped, "explicit-euler"), 0) << residue;
  }
}

// A dashpot that every mode feels: the limit is that of all together, below that of the diagonal of its damping.
TEST(StabilityGrid, StepsOfModesThatDampingCouplesDoWhatOneOfThemSays) {
  System system = test::oscillators(omega, {});
  system.F = VectorXd{{1, -2, 3}};
  system.s = {Pulse{.duration = 0.5}};
  const VectorXd g{{1, -0.7, 0.4}};
  system.modal_damping = {g, VectorXd{{60}}};
  const MappedSystem mapped = mapped_system(system, VectorXd::LinSpaced(101, 0, 1), 1, 1e-6);
  ASSERT_EQ(mapped.modes.coupled.K.rows(), 3);
  for (const char* name : {"central-difference", "symplectic-euler", "explicit-euler"}) {
    const double limit = predicted_limit(mapped, name);
    for (const double factor : {0.02, 0.3, 0.99, 1.05, 3.0, 30.0}) {
      if (factor > 1 && factor < 30 && name[0] == 'e') continue;  // explicit Euler grows too slowly there
      const StepCell one = cell(mapped, name, factor * limit);
      EXPECT_EQ(one.found == StepClass::unstable, factor > 1) << name << " " << factor;
      EXPECT_EQ(verdict(one), "as predicted") << name << " " << factor;
    }
  }
  EXPECT_NEAR(predicted_limit(mapped, "central-difference"), 2.0 / 80, 3e-6);  // its damping is implicit
  const MatrixXd C = 60 * g * g.transpose(), K = VectorXd(omega.cwiseAbs2()).asDiagonal();
  const double limit = predicted_limit(mapped, "symplectic-euler");
  const MatrixXd left = 4 * MatrixXd::Identity(3, 3) - 2 * limit * C - limit * limit * K;
  EXPECT_NEAR(symmetric_eigenvalues(left)(0), 0, 2e-3);
  EXPECT_LT(limit, 0.99 * 2 / 80);
  EXPECT_TRUE(std::isinf(predicted_limit(mapped, "newmark")));
  for (const double dt : {1e-3, 0.1, 0.9}) {
    const StepCell one = cell(mapped, "newmark", dt);
    EXPECT_LE(one.energy, 1 + 1e-9) << dt;
    EXPECT_EQ(verdict(one), "as predicted") << dt;
  }
}

// Rigid motion is no error and no growth: a free mode accelerates as it should.
TEST(StabilityGrid, RigidModesDrift) {
  System system = test::oscillators(VectorXd{{0, 30}}, {});
  system.R = MatrixXd::Identity(2, 1);
  system.F = VectorXd{{1000, 1}};
  system.s = {Step{}};
  const MappedSystem mapped = mapped_system(system, VectorXd::LinSpaced(101, 0, 1), 1, 1e-6);
  ASSERT_EQ(mapped.modes.omega.size(), 1);
  EXPECT_EQ(cell(mapped, "newmark", 1e-3).found, StepClass::stable);
  EXPECT_NEAR(cell(mapped, "newmark", 1e-3).energy, 1, 1e-6);
}

}  // namespace
}  // namespace mb
