#include "modal/frame/spin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "modal/frame/body_flight.h"
#include "modal/frame/particles_test.h"

namespace mb {
namespace {

// Momentum, energy and velocities are those of the particles themselves.
TEST(Spin, HasTheMomentumAndEnergyOfItsParticles) {
  const Particles p = five_particles();
  const BodyState state = tumbling(p.body, 0.05);
  const Matrix3Xd x = p.places(state), v = p.velocities(state);
  Vector3d L = Vector3d::Zero(), P = Vector3d::Zero();
  double T = 0;
  for (Index k = 0; k < 5; ++k) {
    L += p.mass[k] * Vector3d(x.col(k)).cross(Vector3d(v.col(k)));
    P += p.mass[k] * v.col(k);
    T += 0.5 * p.mass[k] * v.col(k).squaredNorm();
  }
  EXPECT_LT((L - state.L).norm(), 1e-13 * L.norm());
  EXPECT_LT(P.norm(), 1e-13 * p.mass.sum() * v.norm());
  EXPECT_NEAR(T + p.potential(x), mechanical_energy(p.body, state), 1e-13 * T);
  EXPECT_LT((angular_velocity(p.body, state) - state.Q * spin(p.body, state).Omega).norm(), 1e-14);
}

// Turns of a body strained by some 5 %, against Runge-Kutta's steps of the particles in the world's axes: all of
// centrifugal, gyroscopic and Euler's forces, and what modes do to the rotation.
TEST(CoupledFlight, IsTheMotionOfParticles) {
  const Particles p = five_particles();
  const BodyState start = tumbling(p.body, 0.03);
  Matrix3Xd x = p.places(start), v = p.velocities(start);
  const double T = 1, h = 5e-4;  // of the fastest mode's period, 0.083 s: error (2 pi h/T)^4 = 2e-6 of a part of q
  for (int i = 0; i < 2000; ++i) {
    const Matrix3Xd a1 = p.acceleration(x), v2 = v + h / 2 * a1, a2 = p.acceleration(x + h / 2 * v),
                    v3 = v + h / 2 * a2, a3 = p.acceleration(x + h / 2 * v2), v4 = v + h * a3,
                    a4 = p.acceleration(x + h * v3);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  const BodyState end = BodyFlight(p.body, start, 0).at(T);
  EXPECT_GT(end.Q.angularDistance(start.Q), 0.5);
  EXPECT_LT((p.places(end) - x).norm(), 2e-6 * x.norm());
  EXPECT_LT((p.velocities(end) - v).norm(), 2e-6 * v.norm() * 10);
  FloatingBody rigid = p.body;  // what it would be without: no small matter
  rigid.coupling = nullptr;
  EXPECT_GT((p.places(BodyFlight(rigid, start, 0).at(T)) - x).norm(), 0.02 * x.norm());
}

TEST(CoupledFlight, KeepsEnergyAndComesBack) {
  const Particles p = five_particles();
  const BodyState start = tumbling(p.body, 0.03);
  const BodyFlight flight(p.body, start, 2);
  const double energy = mechanical_energy(p.body, start);
  for (const double t : {2.0, 2.1, 5.0, 42.0})  // at most 2e-9 a step, some 1e4 steps kept: 2e-7 was seen
    EXPECT_NEAR(mechanical_energy(p.body, flight.at(t)), energy, 1e-6 * energy) << t;
  EXPECT_GT(flight.n_steps(), 100);
  EXPECT_FALSE(flight.failed());
  BodyState back = flight.at(5);
  back.L = -back.L, back.p = -back.p;
  const BodyState home = BodyFlight(p.body, back, 5).at(8);
  EXPECT_LT((home.q - start.q).norm(), 1e-6 * start.q.norm());
  EXPECT_LT(home.Q.angularDistance(start.Q), 1e-6);
  // What was asked for in another order is the same.
  const BodyFlight again(p.body, start, 2);
  again.at(42);
  EXPECT_EQ(again.at(5).q, flight.at(5).q);
}

// Four particles on a ring that can only widen, in its steady turn: omega^2 q = Omega^2 (U + q), U^2 = J.
TEST(CoupledFlight, HoldsTheSteadyStretchOfARing) {
  Particles p{Matrix3Xd(3, 4), VectorXd::Constant(4, 0.5), {}, {}};
  p.X << 1, 0, -1, 0, 0, 1, 0, -1, 0, 0, 0, 0;
  const double U = std::sqrt(2), omega = 30, Omega = 4, q = Omega * Omega * U / (omega * omega - Omega * Omega);
  p.Phi = p.X.reshaped() / U;
  p.body = {true, 2, Vector3d(1, 1, 2).asDiagonal(), Vector3d::Zero(), {roots({omega * omega, 3})}, VectorXd::Zero(1),
            {},   {}};
  p.body.coupling = std::make_shared<const SpinCoupling>(spin_coupling(p.X, p.mass, p.Phi));
  const BodyState start{Vector3d::Zero(),
                        Vector3d::Zero(),
                        Eigen::Quaterniond::Identity(),
                        Vector3d(0, 0, (U + q) * (U + q) * Omega),
                        VectorXd::Constant(1, q),
                        VectorXd::Zero(1),
                        VectorXd(0)};
  const BodyState end = BodyFlight(p.body, start, 0).at(10);
  EXPECT_NEAR(end.q[0], q, 1e-12 * q);
  EXPECT_NEAR(end.Q.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(Omega * 10, Vector3d::UnitZ()))), 0, 1e-7);
  // Let go from rest it swings about there until damping has it: e^{-1.5 * 10}.
  BodyState unstretched = start;
  unstretched.q.setZero();
  EXPECT_NEAR(BodyFlight(p.body, unstretched, 0).at(10).q[0], q, 1e-6 * q);
}

// One mode cannot turn anything: a body at rest vibrates in closed form, whatever the step.
TEST(CoupledFlight, NeedsNoStepsWithoutSpin) {
  Particles p = five_particles();
  const Matrix3Xd X = p.X;
  p.Phi = p.Phi.leftCols(1).eval();
  p.body.modes.resize(1, roots({0, 0}));
  p.body.weight = VectorXd::Zero(1);
  p.body.coupling = std::make_shared<const SpinCoupling>(spin_coupling(X, p.mass, p.Phi));
  BodyState start = tumbling(p.body, 0.1);
  start.L.setZero();
  FloatingBody uncoupled = p.body;
  uncoupled.coupling = nullptr;
  const BodyState a = CoupledFlow(p.body, 7.3).advance(start), b = BodyFlight(uncoupled, start, 0).at(7.3);
  EXPECT_NEAR(a.q[0], b.q[0], 1e-13);
  EXPECT_NEAR(a.p[0], b.p[0], 1e-12);
  EXPECT_LT(a.Q.angularDistance(start.Q), 1e-14);
}

TEST(CoupledFlow, IsOfOrderFour) {
  const Particles p = five_particles();
  const BodyState start = tumbling(p.body, 0.03), truth = BodyFlight(p.body, start, 0).at(0.2);
  const auto error = [&](int n) {
    const CoupledFlow step(p.body, 0.2 / n);
    BodyState at = start;
    for (int i = 0; i < n; ++i) at = step.advance(at);
    return (at.q - truth.q).norm() + (at.Q.coeffs() - truth.Q.coeffs()).norm();
  };
  const double coarse = error(50), fine = error(100);
  EXPECT_GT(fine, 1e-8 * start.q.norm());  // above the truth's own error
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.4);
}

TEST(CoupledFlight, SaysWhereItFails) {
  Particles p = five_particles();
  BodyState start = tumbling(p.body, 0.1);
  start.L *= 1e200;  // squares overflow
  const BodyFlight flight(p.body, start, 0);
  const BodyState end = flight.at(10);
  EXPECT_TRUE(flight.failed());
  EXPECT_TRUE(is_finite(end));
  EXPECT_THROW(spin_coupling(p.X, p.mass.head(3), p.Phi), std::invalid_argument);
  EXPECT_THROW(CoupledFlight(p.body, start, 0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace mb
