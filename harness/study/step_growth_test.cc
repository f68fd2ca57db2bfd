#include "harness/study/step_growth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/catalogue.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/one_step.h"
#include "mechanics/system/oscillators_test.h"
#include "mechanics/system/stored_energy.h"
#include "modal/bases/highest_mode.h"

namespace mb {
namespace {

using test::lumped_box;
using test::oscillators;

const VectorXd omega{{10, 25, 80}};  // [rad/s]

Reduction of(std::vector<System> systems) {
  Reduction reduction;
  for (System& system : systems) reduction.bodies.push_back({std::move(system), {}, {}});
  return reduction;
}

// On both sides of the limit, from a thousandth of it on.
TEST(StepGrowth, OfModesBeginsAtTheLimitOfTheHighest) {
  for (const double beta : {0.0, 1e-3}) {
    const double zeta = beta * 80 / 2, lowered = 2 * (std::sqrt(1 + zeta * zeta) - zeta) / 80;
    const Reduction reduction = of({oscillators(omega, {0, beta})});
    for (const auto& [name, limit] :
         {std::pair("symplectic-euler", lowered), std::pair("central-difference", 2. / 80)}) {
      EXPECT_LE(predicted_growth(reduction, name, 0.999 * limit, 100), 1 + 1e-9) << name;
      EXPECT_GT(predicted_growth(reduction, name, 1.001 * limit, 100), 10) << name;
    }
    EXPECT_LE(predicted_growth(reduction, "newmark", 10, 100), 1 + 1e-9);
  }
}

// Undamped explicit Euler grows at any step, by (1 + x^2)^(n/2): slowly where steps are small.
TEST(StepGrowth, OfExplicitEulerIsThatOfItsSteps) {
  const Reduction undamped = of({oscillators(omega, {})});
  for (const double h : {1e-6, 1e-4, 1e-3})
    EXPECT_NEAR(predicted_growth(undamped, "explicit-euler", h, 1) / std::pow(1 + 6400 * h * h, 0.5 / h), 1, 1e-6);
  EXPECT_LT(predicted_growth(undamped, "explicit-euler", 1e-6, 1), 1.01);
  EXPECT_GT(predicted_growth(undamped, "explicit-euler", 1e-3, 1), 10);
}

TEST(StepGrowth, OfSeveralBodiesIsTheLargest) {
  const System slow = oscillators(VectorXd{{1, 2}}, {}), fast = oscillators(omega, {});
  const double both = predicted_growth(of({slow, fast}), "symplectic-euler", 0.03, 1);
  EXPECT_EQ(both, predicted_growth(of({fast}), "symplectic-euler", 0.03, 1));
  EXPECT_GT(both, 10);
  EXPECT_LE(predicted_growth(of({slow}), "symplectic-euler", 0.03, 1), 1 + 1e-9);
}

// A dashpot that all modes feel lowers the limit; its diagonal alone would lower it elsewhere.
TEST(StepGrowth, OfModesThatDampingCouplesIsThatOfAllTogether) {
  System system = oscillators(omega, {});
  system.modal_damping = {VectorXd{{1, -0.7, 0.4}}, VectorXd{{60}}};
  const auto& [W, d] = system.modal_damping;
  const CoupledModes modes{MatrixXd(system.K), W * d.asDiagonal() * W.transpose()};
  for (const double h : {0.01, 0.0245, 0.03})
    for (const char* name : {"explicit-euler", "symplectic-euler", "central-difference"}) {
      const double rho = spectral_radius(one_step(modes, name, h));
      EXPECT_NEAR(predicted_growth(of({system}), name, h, h), rho, 1e-12 * rho) << name << h;
    }
  EXPECT_GT(predicted_growth(of({system}), "symplectic-euler", 0.0245, 10), 10);
  EXPECT_LE(predicted_growth(of({oscillators(omega, {})}), "symplectic-euler", 0.0245, 10), 1 + 1e-9);
}

TEST(StepGrowth, OfAMeshIsThatOfItsHighestMode) {
  for (const double beta : {0.0, 1e-5}) {
    const System system = lumped_box({0, beta});
    const VectorXd lumped = generalized_eigenvalues(MatrixXd(system.K), MatrixXd(system.lumped_mass)).value();
    const double top = std::sqrt(lumped.maxCoeff()), zeta = beta * top / 2;
    const double limit = 2 * (std::sqrt(1 + zeta * zeta) - zeta) / top;
    for (const char* name : {"symplectic-euler", "central-difference"}) {
      EXPECT_LE(predicted_growth(of({system}), name, 0.999 * limit, 1000 * limit), 1 + 1e-6) << name;
      EXPECT_GT(predicted_growth(of({system}), name, 1.001 * limit, 1000 * limit), 10) << name;
    }
  }
}

// The lowest mode of a damped mesh without damping of its own: explicit Euler grows in it, by (1 + x^2)^(n/2), at steps
// at which the highest decays.
TEST(StepGrowth, OfAMeshSeesSingleModesDampedLessThanTheRest) {
  System system = lumped_box({0, 1e-3});
  system.M = system.lumped_mass;
  const EigenPairs all = generalized_eigen(MatrixXd(system.K), MatrixXd(system.M)).value();
  const double omega_1 = std::sqrt(all.values(6)), h = 0.5 * 1e-3;  // half of 2 zeta/omega, the limit of every mode
  EXPECT_LE(predicted_growth(of({system}), "explicit-euler", h, 10), 1 + 1e-9);
  system.modal_damping = {MatrixXd(system.M * all.vectors.col(6)), VectorXd{{-1e-3 * all.values(6)}}};
  const double x = omega_1 * h, grown = std::pow(1 + x * x, 0.5 * 10 / h);
  EXPECT_NEAR(std::log(predicted_growth(of({system}), "explicit-euler", h, 10)) / std::log(grown), 1, 1e-6);
  EXPECT_GT(grown, 1.1);
}

// Of which only that there is one is asked.
class Energy final : public StoredEnergy {
  double energy(const VectorXd&) const override { return 0; }
  bool force(const VectorXd& u, const VectorXd&, VectorXd& f) const override { return f.setZero(u.size()), true; }
  bool add_tangent(const VectorXd&, double, double, SparseMatrix&) const override { return true; }
  std::vector<Turn> turns(const VectorXd&) const override { return {}; }
  MatrixXd rigid_motions(const VectorXd& u) const override { return MatrixXd(u.size(), 0); }
};

// Steps of finite deformation lag with all of their damping, of mass and of stiffness; about rest they are those of the
// linear body, in contact without it.
TEST(StepGrowth, OfAMeshThatStretchesOrTouchesIsThatAboutRest) {
  for (const Rayleigh& damping : {Rayleigh{}, Rayleigh{30, 0}, Rayleigh{0, 1e-4}, Rayleigh{30, 1e-4}}) {
    System system = lumped_box(damping);
    const SteppedMode top = highest_mode(with_lumped_mass(system));
    const double limit = 2 * (std::sqrt(1 + top.zeta * top.zeta) - top.zeta) / top.omega;  // lagging
    system.stored_energy = std::make_shared<Energy>();
    Reduction full = of({system});
    full.modes_used = -1;
    full.in_contact = [](const Integrator&, const Settings&) { return std::unique_ptr<Prepared>(); };
    EXPECT_LE(predicted_growth(full, "central-difference", 0.99 * limit, 1), 1 + 1e-6);
    EXPECT_GT(predicted_growth(full, "central-difference", 1.01 * limit, 1), 10);
  }
}

TEST(StepGrowth, IsUnknownWhereNothingIsKnown) {
  Reduction touching = of({oscillators(omega, {})});
  touching.modes_used = 3;
  touching.in_contact = [](const Integrator&, const Settings&) { return std::unique_ptr<Prepared>(); };
  EXPECT_TRUE(std::isnan(predicted_growth(touching, "symplectic-euler", 1, 10)));
  EXPECT_TRUE(std::isnan(predicted_growth(of({oscillators(omega, {})}), "sundials", 1, 10)));
  System without_modes = lumped_box({});  // of which ARPACK finds none
  without_modes.K *= std::nan("");
  EXPECT_TRUE(std::isnan(predicted_growth(of({without_modes}), "symplectic-euler", 1e-3, 1)));
}

// Where theory tells of no such steps, their energy does.
TEST(StepGrowth, WhatWasLookedForInVainIsSaid) {
  System without_modes = lumped_box({});
  without_modes.K *= std::nan("");
  Reduction touching = of({oscillators(omega, {})}), in_vain = of({without_modes});
  touching.modes_used = 3;
  touching.in_contact = [](const Integrator&, const Settings&) { return std::unique_ptr<Prepared>(); };
  const auto is_unknown = [](const Reduction* reduction, const char* integrator) {
    return growth_of(reduction, default_catalogue().integrator(integrator), 1e-3, 1).unknown;
  };
  EXPECT_TRUE(is_unknown(&in_vain, "symplectic-euler"));
  EXPECT_FALSE(is_unknown(&in_vain, "newmark"));
  EXPECT_FALSE(is_unknown(&touching, "symplectic-euler"));
  EXPECT_FALSE(is_unknown(nullptr, "symplectic-euler"));
  const Reduction known = of({oscillators(omega, {})});
  EXPECT_FALSE(is_unknown(&known, "symplectic-euler"));
}

}  // namespace
}  // namespace mb
