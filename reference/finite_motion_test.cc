// Steppers of bodies of finite deformation: ARKODE and average acceleration.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/central_difference.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/finite_force.h"
#include "mechanics/system/newmark.h"
#include "mechanics/system/symplectic_euler.h"
#include "mechanics/verified_test.h"
#include "reference/finite_bodies_test.h"
#include "reference/static_answer.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

using testing::FreeBody;
const Material rubber{1e6, 0.3, 1100};
const Shape brick = Box{{0.3, 0.1, 0.06}};

// Hung by one face, pulled at the other: the answer of K differs by the square of the amplitude.
TEST(FiniteMotion, SmallAmplitudesAreLinear) {
  const auto off = [](double amplitude, auto&& step) {
    Scene scene = testing::finite_body(brick, rubber, {2, {2, 1, 1}}, {3, 1e-4});
    scene.bodies[0].supports = {testing::support(Support::Kind::fixed, testing::face("x-min"))};
    testing::load(scene, "x-max", amplitude * Vector3d(2e4, 0, 3e3));
    scene.loads[0].history = Pulse{0.05};
    const auto model = testing::model_of(scene);
    const System linear = testing::without_energy(model->system());
    const VectorXd times = VectorXd::LinSpaced(9, 0, 0.1);
    const States bent = step(model->system(), times), straight = step(linear, times);
    EXPECT_EQ(bent.status, Status::ok);
    EXPECT_EQ(bent.n_valid, 9);
    return (bent.u - straight.u).norm() / straight.u.norm();
  };
  const auto arkode = [](const System& s, const VectorXd& t) { return sundials(s, 1e-7, 0.1)->run(t); };
  const auto average = [](const System& s, const VectorXd& t) { return newmark(s, 5e-4)->run(t); };
  EXPECT_NEAR(std::log10(off(0.1, arkode) / off(0.01, arkode)), 1, 0.1);  // beside terms of third order
  EXPECT_NEAR(std::log10(off(0.1, average) / off(0.01, average)), 1, 0.1);
  EXPECT_GT(off(1, arkode), 0.01);
}

// Free and fast: 41 rad in a second, over all axes.
struct Spun {
  explicit Spun(const Rayleigh& damping)
      : model(testing::model_of(testing::finite_body(brick, rubber, {2, {3, 1, 1}}, damping))),
        body(*model),
        system(model->system()) {
    system.v0 = body.moving({1, 2, 3}, {5, 40, 10});
  }
  double energy(const VectorXd& u, const VectorXd& v) const {
    return kinetic_energy(system, v) + strain_energy(system, u);
  }
  std::shared_ptr<const FullModel> model;
  FreeBody body;
  System system;
};

struct Drifts {
  double momentum, spin, energy;  // [-] largest, relative
};
Drifts drifts(const Spun& spun, const States& states) {
  const System& s = spun.system;
  const Vector3d P = spun.body.momentum(s.v0), L = spun.body.angular_momentum(s.u0, s.v0);
  const double E = spun.energy(s.u0, s.v0);
  Drifts largest{0, 0, 0};
  for (Index k = 0; k < states.u.cols(); ++k) {
    const VectorXd u = states.u.col(k), v = states.v.col(k);
    largest.momentum = worse(largest.momentum, (spun.body.momentum(v) - P).norm() / P.norm());
    largest.spin = worse(largest.spin, (spun.body.angular_momentum(u, v) - L).norm() / L.norm());
    largest.energy = worse(largest.energy, std::abs(spun.energy(u, v) - E) / E);
  }
  return largest;
}

TEST(FiniteMotion, ASpunBodyKeepsMomentumAndEnergy) {
  const Spun spun({0, 0});
  const VectorXd times = VectorXd::LinSpaced(11, 0, 1);
  for (const double tolerance : {1e-4, 1e-6}) {
    const States states = sundials(spun.system, tolerance, 1)->run(times);
    ASSERT_EQ(states.status, Status::ok);
    const Drifts drift = drifts(spun, states);
    EXPECT_LT(drift.momentum, 1e-13);         // rounding
    EXPECT_LT(drift.spin, 8 * tolerance);     // seen 2.3 and 0.9 times it
    EXPECT_LT(drift.energy, 40 * tolerance);  // seen 1 and 16: its steps damp what is fast
    EXPECT_GT(strain_energy(spun.system, states.u.rightCols(1)), 5e-3 * spun.energy(spun.system.u0, spun.system.v0));
    EXPECT_LE(states.work.factorisations, 12);  // the tangent turns with the body
  }
  const auto error = [&](double h) {
    const Drifts drift = drifts(spun, newmark(spun.system, h)->run(times));
    EXPECT_LT(drift.momentum, 1e-13);
    return drift.spin;
  };
  EXPECT_NEAR(std::log2(error(1e-3) / error(5e-4)), 2, 0.5);  // order 2
}

// Central differences against ARKODE, whose error is far below: second order, first where damping lags.
TEST(FiniteMotion, ExplicitStepsConvergeWithTheirOrder) {
  const VectorXd times = VectorXd::LinSpaced(6, 0, 0.1);
  const auto order = [&](const Rayleigh& damping) {
    Spun spun(damping);
    spun.system.lumped_mass = {};
    const States truth = sundials(spun.system, 1e-9, 0.1)->run(times);
    const auto error = [&](double h) {
      const States states = central_difference(spun.system, h)->run(times);
      EXPECT_EQ(states.status, Status::ok);
      return (states.u - truth.u).norm() / truth.u.norm();
    };
    EXPECT_LT(error(2e-5), 1e-3);
    return std::log2(error(4e-5) / error(2e-5));
  };
  EXPECT_NEAR(order({0, 0}), 2, 0.1);
  EXPECT_NEAR(order({20, 1e-5}), 1, 0.3);
}

// Likewise either Euler method, of first order; steps so short that undamped explicit Euler has hardly grown.
TEST(FiniteMotion, EulerStepsConvergeWithOrderOne) {
  const VectorXd times = VectorXd::LinSpaced(3, 0, 5e-3);
  Spun spun({20, 1e-5});
  spun.system.lumped_mass = {};
  const States truth = sundials(spun.system, 1e-9, 5e-3)->run(times);
  for (const auto make : {static_cast<std::unique_ptr<Stepper> (*)(const System&, double)>(explicit_euler),
                          static_cast<std::unique_ptr<Stepper> (*)(const System&, double)>(symplectic_euler)}) {
    const auto error = [&](double h) {
      const States states = make(spun.system, h)->run(times);
      EXPECT_EQ(states.status, Status::ok);
      return (states.u - truth.u).norm() / truth.u.norm();
    };
    EXPECT_LT(error(5e-7), 1e-3);
    EXPECT_NEAR(std::log2(error(1e-6) / error(5e-7)), 1, 0.1);
  }
}

// As contenders step it: damping in proportion to the mass is that of the mass which is stepped with.
TEST(FiniteMotion, ExplicitStepsOfALumpedMassDampItAlone) {
  const VectorXd times = VectorXd::LinSpaced(6, 0, 0.1);
  Spun spun({20, 0});
  System alone = spun.system;
  alone.M = alone.lumped_mass;
  alone.lumped_mass = {};
  const States truth = sundials(alone, 1e-9, 0.1)->run(times);
  const auto error = [&](double h) {
    return (central_difference(spun.system, h)->run(times).u - truth.u).norm() / truth.u.norm();
  };
  EXPECT_LT(error(2e-5), 1e-3);
  EXPECT_NEAR(std::log2(error(4e-5) / error(2e-5)), 1, 0.3);
}

// The limit is that of the mass that is stepped with; beyond it the body inverts within a few steps.
TEST(FiniteMotion, ExplicitStepsPastTheLimitAreSeen) {
  const VectorXd times = VectorXd::LinSpaced(6, 0, 0.1);
  const Spun spun({0, 0});
  const VectorXd lambda = generalized_eigenvalues(MatrixXd(spun.system.K), MatrixXd(spun.system.lumped_mass)).value();
  const double limit = 2 / std::sqrt(lambda.maxCoeff());
  EXPECT_EQ(central_difference(spun.system, 0.9 * limit)->run(times).status, Status::ok);
  const States past = central_difference(spun.system, 1.2 * limit)->run(times);
  EXPECT_EQ(past.status, Status::not_finite);
  EXPECT_LT(past.n_valid, 6);
  EXPECT_LT(past.work.steps, 600);
}

TEST(FiniteMotion, DampingBrakesNoRotation) {
  const Spun spun({20, 2e-3});
  const VectorXd times = VectorXd::LinSpaced(3, 0, 1);
  const States states = sundials(spun.system, 1e-5, 1)->run(times);
  ASSERT_EQ(states.status, Status::ok);
  const Drifts drift = drifts(spun, states);
  EXPECT_LT(drift.momentum, 1e-13);
  EXPECT_LT(drift.spin, 40 * 1e-5);  // seen 14 times the tolerance
  EXPECT_LT(drift.energy, 0.02);     // a per cent goes into the first swing; twenty per second of all would be left
}

TEST(FiniteMotion, DampingLinearisesAndDissipates) {
  const Spun spun({20, 2e-3});
  const System& s = spun.system;
  const FiniteForce force(s);
  const VectorXd v = VectorXd::Random(s.u0.size()), u = 2e-3 * VectorXd::Random(s.u0.size());
  VectorXd f, f_0;
  ASSERT_TRUE(force.resistance(0, s.u0, v, f));
  const VectorXd Cv = apply_damping(s, v);
  EXPECT_LT((f - Cv).norm(), 1e-12 * Cv.norm());  // rounding
  ASSERT_TRUE(force.resistance(0, u, v, f) && force.resistance(0, u, s.u0, f_0));
  EXPECT_GT(v.dot(f - f_0), 0);
  // turned by 2 rad and spinning: nothing
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(2, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const VectorXd turned = (Q * spun.body.X.reshaped(3, s.u0.size() / 3)).reshaped() - spun.body.X;
  const VectorXd r = s.stored_energy->rigid_motions(turned) * VectorXd::LinSpaced(6, 1, 2);
  ASSERT_TRUE(force.resistance(0, turned, r, f));
  EXPECT_LT(f.norm(), 1e-10 * apply_damping(s, v).norm() * r.norm() / v.norm());
}

// A bar of nu = 0 that spins about its middle stretches to  (mu (x' - 1/x'))' + rho Omega^2 x = 0,  x(0) = 0,
// x'(L) = 1: by Runge and Kutta from the free end, with Omega such that the angular momentum is that of the start.
struct SteadyBar {
  double E, rho, half, side;
  double reach(double omega) const { return from_end(omega).reach; }
  struct Shot {
    double reach, at_middle, inertia;
  };
  // x' = p(s), (mu (p - 1/p))' = -rho omega^2 x, backwards from x(half) = reach: at_middle is then x(0).
  Shot shoot(double omega, double end) const {
    const double mu = E / 2;
    const int n = 2000;
    const double h = half / n;
    const auto rate = [&](const Vector3d& y) {  // x, P, int x^2
      const double P = y[1] / (2 * mu), p = P + std::sqrt(P * P + 1);
      return Vector3d(-p, rho * omega * omega * y[0], y[0] * y[0]);
    };
    Vector3d y(end, 0, 0);
    for (int i = 0; i < n; ++i) {
      const Vector3d a = rate(y), b = rate(y + h / 2 * a), c = rate(y + h / 2 * b), d = rate(y + h * c);
      y += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return {end, y[0], 2 * rho * side * side * y[2] + rho * side * side * 2 * half * side * side / 12};
  }
  Shot from_end(double omega) const {
    double low = half, high = 2 * half;
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      (shoot(omega, middle).at_middle < 0 ? low : high) = middle;
    }
    return shoot(omega, low);
  }
  Shot spinning_with(double L) const {
    double low = 0, high = L / from_end(0).inertia;
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      (from_end(middle).inertia * middle < L ? low : high) = middle;
    }
    return from_end(low);
  }
};

TEST(FiniteMotionVerification, ASpinningBarStretchesAsInOneDimension) {
  const double half = 0.2, side = 0.012, omega = 24;
  const Material bar{1e5, 0, 1100};
  const Scene scene = testing::finite_body(Box{{2 * half, side, side}}, bar, {3, {4, 1, 1}}, {0, 8e-3});
  const auto model = testing::model_of(scene);
  const FreeBody body(*model);
  System s = model->system();
  s.v0 = body.moving(Vector3d::Zero(), {0, 0, omega});
  const double L = body.spin(s.u0, s.v0).z();
  const States states = sundials(s, 1e-6, 1)->run(VectorXd{{1.0}});
  ASSERT_EQ(states.status, Status::ok);
  const SteadyBar steady{bar.youngs_modulus, bar.density, half, side};
  const double expected = steady.spinning_with(L).reach / half - 1;
  EXPECT_GT(expected, 0.05);
  const Matrix3Xd ends{{-half, half}, {0, 0}, {0, 0}};
  const Matrix3Xd x = ends + (model->displacement_at(ends) * states.u.col(0)).reshaped(3, 2).matrix();
  const double stretch = (x.col(1) - x.col(0)).norm() / (2 * half) - 1;
  testing::expect_verified(
      {.quantity = "stretch of a steadily spinning neo-Hookean bar of nu = 0, between the centres of its end sections",
       .reference = "second route",
       .source = "the bar in one dimension, an ordinary differential equation by shooting and Runge-Kutta",
       .uncertainty = "9e-4, (side/length)^2: with nu = 0 the sides' own stretch enters by their inertia alone",
       .tolerance = 2e-3,
       .why = "Twice that; angular momentum, which sets the speed, drifts by some 1e-5 at a tolerance of 1e-6."},
      stretch / expected - 1);
}

TEST(FiniteMotion, WhatCannotBeSteppedIsRefused) {
  Spun spun({0, 0});
  const System& s = spun.system;
  EXPECT_THROW(exact(s, 1), std::invalid_argument);
  EXPECT_THROW(explicit_euler(s, 0), std::invalid_argument);
  EXPECT_THROW(symplectic_euler(s, 0), std::invalid_argument);
  EXPECT_THROW(central_difference(s, 0), std::invalid_argument);
  EXPECT_THROW(newmark(s, 0), std::invalid_argument);
  System ratios = s;
  ratios.modal_damping = {MatrixXd::Ones(s.u0.size(), 1), VectorXd::Ones(1)};
  EXPECT_THROW(newmark(ratios, 1e-4), std::invalid_argument);
}

// Steps much longer than a body takes to turn inside out: said by name, and no number beyond.
TEST(FiniteMotion, FailuresHaveNames) {
  Spun spun({0, 0});
  spun.system.v0 = -20 * spun.body.X;  // [m/s] each point to the middle in 50 ms
  spun.system.v0 *= 40;
  const VectorXd times = VectorXd::LinSpaced(5, 0, 0.04);
  const States states = newmark(spun.system, 0.01)->run(times);
  EXPECT_TRUE(states.status == Status::inverted || states.status == Status::no_convergence);
  ASSERT_LT(states.n_valid, 5);
  EXPECT_TRUE(states.u.leftCols(states.n_valid).allFinite() && states.v.leftCols(states.n_valid).allFinite());
  EXPECT_TRUE(states.u.rightCols(5 - states.n_valid).array().isNaN().all());
  EXPECT_TRUE(states.v.rightCols(5 - states.n_valid).array().isNaN().all());
}

}  // namespace
}  // namespace mb
