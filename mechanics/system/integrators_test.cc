// What all integrators with equal steps have in common: order, energy, damping, rigid motion, failures.
#include <gtest/gtest.h>

#include "mechanics/system/central_difference.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/newmark.h"
#include "mechanics/system/small_test_systems.h"
#include "mechanics/system/symplectic_euler.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using testing::distance;
using testing::largest_omega;
using testing::lumped;
using testing::small_box;
using testing::with_all_damping;

struct Named {
  const char* name;
  std::unique_ptr<Stepper> (*make)(const System&, double h);
  int order;
};
const std::vector<Named> integrators = {{"explicit Euler", explicit_euler, 1},
                                        {"symplectic Euler", symplectic_euler, 1},
                                        {"central difference", central_difference, 2},
                                        {"newmark", newmark, 2}};

VectorXd equally_spaced(double end, Index n) { return VectorXd::LinSpaced(n, 0, end); }

// A step of about h that divides the first interval of t: the error of a first-order scheme depends on where within a
// step it is read.
double dividing(const VectorXd& t, double h) { return t[1] / std::ceil(t[1] / h); }

// Of the error against `truth` from h to h/4.
double observed_order(const Named& integrator, const System& system, const States& truth, const VectorXd& t, double h) {
  const double coarse = distance(integrator.make(system, h)->run(t), truth);
  const double fine = distance(integrator.make(system, h / 4)->run(t), truth);
  EXPECT_LT(coarse, 0.5) << integrator.name;
  return std::log2(coarse / fine) / 2;
}

TEST(IntegratorsVerification, ConvergeAtTheirOrderWithEveryDamping) {
  const VectorXd t = equally_spaced(5, 12);
  double worst = 0;
  for (const bool is_clamped : {false, true})
    for (const bool is_damped : {false, true}) {
      const System plain = small_box(is_clamped), s = is_damped ? with_all_damping(plain) : plain;
      const States truth = exact(s, 5)->run(t);
      for (const Named& integrator : integrators) {
        // Euler's growth omega^2 h t/2 is to stay small: a tenth of the second order's steps.
        const double omega = largest_omega(plain), h = integrator.order == 1 ? dividing(t, 0.01 / omega) : 0.1 / omega;
        const double order = observed_order(integrator, s, truth, t, h);
        EXPECT_NEAR(order, integrator.order, 0.1)
            << integrator.name << (is_clamped ? ", clamped" : ", free") << (is_damped ? ", damped" : "");
        worst = std::max(worst, std::abs(order - integrator.order));
      }
    }
  testing::expect_verified(
      {.quantity = "distance of the order from theory's, absolute: 1 of explicit and symplectic Euler, 2 of central "
                   "differences and average acceleration; displacement and velocity of a box, free and clamped, "
                   "undamped and damped",
       .reference = "property",
       .source = "orders of the schemes; errors are against the closed form of all modes",
       .uncertainty = "none",
       .tolerance = 0.1,
       .why = "Steps of a hundredth or a tenth of 1/omega of the highest mode: the error's next term bends the fit."},
      worst);
}

// The closed form of the lumped system: its mass in place of M, rigid modes orthonormal in it.
System consistent_with_lumps(const System& s) {
  System result = s;
  result.M = s.lumped_mass;
  result.lumped_mass.resize(0, 0);
  const MatrixXd gram = s.R.transpose() * (result.M * s.R);
  if (s.R.cols() > 0) result.R = gram.llt().matrixU().solve<Eigen::OnTheRight>(s.R);
  return result;
}

TEST(IntegratorsVerification, ConvergeWithLumpedMass) {
  const VectorXd t = equally_spaced(5, 12);
  for (const Rayleigh& damping : {Rayleigh{}, Rayleigh{0.3, 0}, Rayleigh{0.1, 0.02}})
    for (const Named& integrator : integrators) {
      if (integrator.make == newmark) continue;  // keeps the consistent mass
      System s = lumped(small_box(false));
      s.damping = damping;
      const States truth = exact(consistent_with_lumps(s), 5)->run(t);
      const int order = damping.beta > 0 ? 1 : integrator.order;  // the damping of K lags half a step
      const double h = dividing(t, (order == 1 ? 0.01 : 0.05) / largest_omega(small_box(false)));
      EXPECT_NEAR(observed_order(integrator, s, truth, t, h), order, 0.15) << integrator.name << damping.beta;
    }
}

TEST(Integrators, SeeTheLumpedMassOnly) {
  const VectorXd t = equally_spaced(2, 7);
  System s = lumped(small_box(false));
  s.damping = {0.3, 0.01};
  const System consistent = consistent_with_lumps(s);
  for (const auto make : {explicit_euler, symplectic_euler})
    EXPECT_LT(distance(make(s, 0.01)->run(t), make(consistent, 0.01)->run(t)), 1e-13);
}

// Every scheme commutes with the change of coordinates; there all products and solves are diagonal.
TEST(Integrators, DoTheSameInModalCoordinates) {
  const VectorXd t = equally_spaced(3, 40);
  const System s = with_all_damping(small_box(false));
  const ModalForm form = modal_form(s);
  const System reduced = testing::in_modal_coordinates(s, form);
  for (const Named& integrator : integrators) {
    States states = integrator.make(reduced, 0.02)->run(t);
    states.u = form.Phi * states.u;
    states.v = form.Phi * states.v;
    EXPECT_LT(distance(states, integrator.make(s, 0.02)->run(t)), 1e-11) << integrator.name;
    EXPECT_EQ(states.work.factorisations, 0);
    EXPECT_EQ(states.work.solves, 0);
  }
}

System unloaded(System s) {
  s.F.resize(s.M.rows(), 0);
  s.s.clear();
  return s;
}

// (u+ - u)^T M (u+ - u)/(2 h^2) + u+^T K u/2, between outputs a step apart.
VectorXd energy_between_steps(const System& s, const States& x, double h) {
  VectorXd energy(x.u.cols() - 1);
  for (Index k = 0; k < energy.size(); ++k)
    energy[k] = kinetic_energy(s, (x.u.col(k + 1) - x.u.col(k)) / h) + x.u.col(k).dot(s.K * x.u.col(k + 1)) / 2;
  return energy;
}

VectorXd energy_at_steps(const System& s, const States& x) {
  VectorXd energy(x.u.cols());
  for (Index k = 0; k < energy.size(); ++k) energy[k] = kinetic_energy(s, x.v.col(k)) + strain_energy(s, x.u.col(k));
  return energy;
}

constexpr Index n_steps = 5000;

TEST(Integrators, NewmarkConservesEnergy) {
  const System s = unloaded(small_box(true));  // clamped: rounding of displacements that stay small
  for (const double h : {0.01, 0.5, 5.0}) {
    const VectorXd energy = energy_at_steps(s, newmark(s, h)->run(h * VectorXd::LinSpaced(n_steps, 0, n_steps - 1)));
    EXPECT_LT((energy.array() / energy[0] - 1).abs().maxCoeff(), 1e-10) << h;
  }
}

// Both repeat u+ - 2 u + u- = -h^2 M^-1 K u, whose energy is conserved to rounding right up to the step limit.
TEST(Integrators, ExplicitOnesConserveTheirEnergy) {
  for (const System& s : {unloaded(small_box(false)), consistent_with_lumps(lumped(unloaded(small_box(false))))})
    for (const auto make : {symplectic_euler, central_difference})
      for (const double share : {0.1, 0.9, 0.999}) {
        const double h = share * 2 / largest_omega(s);
        const States x = make(s, h)->run(h * VectorXd::LinSpaced(n_steps, 0, n_steps - 1));
        const VectorXd energy = energy_between_steps(s, x, h);
        EXPECT_LT((energy.array() / energy[0] - 1).abs().maxCoeff(), 1e-9) << share;  // seen 1e-11
        const VectorXd plain = energy_at_steps(s, x);
        const auto late = plain.tail(n_steps / 2), early = plain.head(n_steps / 2);
        EXPECT_NEAR(late.maxCoeff() / early.maxCoeff(), 1, share < 0.5 ? 0.01 : 0.2) << share;  // oscillates, no drift
      }
}

TEST(Integrators, DampingTakesEnergyAway) {
  for (const bool is_clamped : {false, true}) {
    const System s = unloaded(with_all_damping(small_box(is_clamped)));
    const double h = 1.9 / largest_omega(s);
    const VectorXd t = h * VectorXd::LinSpaced(500, 0, 499);
    const VectorXd implicit = energy_at_steps(s, newmark(s, h)->run(t));
    const VectorXd central = energy_between_steps(s, central_difference(s, h)->run(t), h);
    for (const VectorXd& energy : {implicit, central}) {
      const VectorXd change = energy.tail(energy.size() - 1) - energy.head(energy.size() - 1);
      EXPECT_LE(change.maxCoeff(), 1e-14 * energy[0]);
      EXPECT_LT(energy.tail(1)[0], 0.9 * energy[0]);
    }
  }
}

TEST(Integrators, LeaveRigidMotionUndamped) {
  System s = unloaded(with_all_damping(small_box(false)));
  s.u0.setZero();
  s.v0 = s.R * VectorXd{{1, -2, 3, 0.3, -0.2, 0.1}};
  const VectorXd t = equally_spaced(20, 7);
  for (const System& system : {s, lumped(s)})
    for (const Named& integrator : integrators) {
      const States x = integrator.make(system, 0.02)->run(t);
      EXPECT_LT((x.u - s.v0 * t.transpose()).norm(), 1e-10 * x.u.norm()) << integrator.name;
    }
}

TEST(Integrators, StopWhereNothingIsFinite) {
  const System s = small_box(false);
  const double h = 4 / largest_omega(s);
  const VectorXd t = h * VectorXd::LinSpaced(50, 0, 1e6);
  for (const Named& integrator : integrators) {
    const States x = integrator.make(s, h)->run(integrator.make == newmark ? t.head(2) : t);
    if (integrator.make == newmark) {
      EXPECT_EQ(x.status, Status::ok);
      continue;
    }
    EXPECT_EQ(x.status, Status::not_finite) << integrator.name;
    EXPECT_EQ(x.n_valid, 1) << integrator.name;
    EXPECT_LT(x.work.steps, 5000) << integrator.name;
    EXPECT_TRUE(x.u.leftCols(1).allFinite() && x.v.leftCols(1).allFinite()) << integrator.name;
    EXPECT_TRUE(x.u.rightCols(49).array().isNaN().all()) << integrator.name;  // no memory that was never written
    EXPECT_TRUE(x.v.rightCols(49).array().isNaN().all()) << integrator.name;
  }
}

TEST(Integrators, RunsRepeat) {
  const System s = with_all_damping(small_box(false));
  const VectorXd t = equally_spaced(3, 10);
  for (const Named& integrator : integrators) {
    const auto stepper = integrator.make(s, 0.05);
    const States first = stepper->run(t), second = stepper->run(t);
    EXPECT_TRUE(first.u == second.u && first.v == second.v) << integrator.name;
    EXPECT_EQ(first.work.steps, 60) << integrator.name;
    EXPECT_EQ(first.work.load_evaluations, 60) << integrator.name;
    const bool finds_initial_acceleration = integrator.order == 2;
    EXPECT_EQ(first.work.solves, finds_initial_acceleration ? 61 : 60) << integrator.name;
    EXPECT_GE(first.work.factorisations, 1) << integrator.name;  // of the preparation
    EXPECT_EQ(stepper->run(VectorXd()).u.cols(), 0);
  }
}

// Hence first order there: a load that comes at 1.5 h and one that comes at 2 h are the same to all of them.
TEST(Integrators, SeeAJumpBetweenStepsAtTheNextStep) {
  System between = small_box(true), at_step = between;
  between.s.assign(static_cast<size_t>(between.F.cols()), Step{1, 0.075});
  at_step.s.assign(static_cast<size_t>(at_step.F.cols()), Step{1, 0.1});
  const VectorXd t = equally_spaced(1, 11);
  for (const Named& integrator : integrators) {
    const States x = integrator.make(between, 0.05)->run(t);
    EXPECT_GT(x.u.norm(), 0) << integrator.name;
    EXPECT_TRUE(x.u == integrator.make(at_step, 0.05)->run(t).u) << integrator.name;
  }
}

TEST(Integrators, TakeASystemWithoutUnknowns) {
  const System nothing;
  for (const Named& integrator : integrators)
    EXPECT_EQ(integrator.make(nothing, 0.1)->run(equally_spaced(1, 3)).n_valid, 3) << integrator.name;
}

TEST(Integrators, RefuseBadInput) {
  const System s = with_all_damping(small_box(true));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Named& integrator : integrators) {
    for (const double h : {0.0, -1.0, std::nan(""), infinity})
      EXPECT_THROW(integrator.make(s, h), std::invalid_argument) << integrator.name << h;
    const auto stepper = integrator.make(s, 0.1);
    for (const VectorXd& t :
         {VectorXd{{0.5, 0.4}}, VectorXd{{-0.1, 0.4}}, VectorXd{{0, std::nan("")}}, VectorXd{{0, infinity}}})
      EXPECT_THROW(stepper->run(t), std::invalid_argument) << integrator.name;
    EXPECT_THROW(stepper->averages(equally_spaced(1, 3), 0.1), std::invalid_argument);
    System broken = s;
    broken.modal_damping.d.conservativeResize(2);
    EXPECT_THROW(integrator.make(broken, 0.1), std::invalid_argument) << integrator.name;
    broken = s;
    broken.s.pop_back();
    EXPECT_THROW(integrator.make(broken, 0.1), std::invalid_argument) << integrator.name;
    broken = s;
    broken.M *= -1e3;
    EXPECT_THROW(integrator.make(broken, 0.1), std::runtime_error) << integrator.name;
    if (integrator.make == newmark) continue;
    broken = lumped(s);
    broken.lumped_mass.coeffRef(3, 3) = 0;
    EXPECT_THROW(integrator.make(broken, 0.1), std::runtime_error) << integrator.name;
    broken.lumped_mass.resize(3, 3);
    EXPECT_THROW(integrator.make(broken, 0.1), std::invalid_argument) << integrator.name;
  }
}

}  // namespace
}  // namespace mb
