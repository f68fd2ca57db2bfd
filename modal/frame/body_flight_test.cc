#include "modal/frame/body_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/rigid/flight.h"
#include "modal/contact/contact_step.h"
#include "modal/contact/floating_bodies_test.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::floating;

const Shape block = Box{{0.1, 0.08, 0.2}};
const Vector3d down(0.3, 0, -9.81);

BodyState spinning(const FloatingBody& body) {
  BodyState start = at_rest(body, {1, 2, 3}, {4, -5, 6});
  start.Q = Eigen::Quaterniond(0.5, -0.3, 0.7, 0.2).normalized();
  start.L = {0.03, -0.02, 0.05};
  return start;
}

// The same rigid flight as mechanics has it from pose and twist, minutes later, too.
TEST(BodyFlight, OfARigidBodyIsItsFlight) {
  FloatingBody body = floating(block, {}, down);
  const Eigen::Quaterniond turn(0.9, 0.1, 0.3, -0.2);
  const Eigen::Matrix3d A = turn.normalized().toRotationMatrix();
  const Eigen::Matrix3d J = A * body.inertia * A.transpose();
  body.inertia = (J + J.transpose()) / 2;  // principal axes of its own
  const BodyState start = spinning(body);
  const BodyFlight flight(body, start, 7);
  const Flight rigid({body.mass, Vector3d::Zero(), body.inertia}, {start.c, start.Q},
                     {start.v, angular_velocity(body, start)}, down);
  for (const double t : {0.0, 1e-6, 0.3, 20.0, 600.0}) {
    const BodyState at = flight.at(7 + t);
    EXPECT_LT((at.c - rigid.at(t).position).norm(), 1e-14 * (10 + 10 * t + 10 * t * t));
    EXPECT_LT((at.v - rigid.twist_at(t).velocity).norm(), 1e-14 * (10 + 10 * t));
    // phases to some roundings of |w| t: 30 rad/s
    EXPECT_LT(at.Q.angularDistance(rigid.at(t).orientation), 1e-13 * (1 + 30 * t)) << t;
    EXPECT_LT((angular_velocity(body, at) - rigid.twist_at(t).angular_velocity).norm(), 1e-11 * (1 + 30 * t)) << t;
    EXPECT_EQ(at.L, start.L);
    EXPECT_NEAR(at.Q.norm(), 1, 1e-14);
  }
  EXPECT_EQ(flight.start(), 7);
}

// The frame turns by its angular velocity: Q' = Omega x Q, by central differences of 1e-5 s, h^2 Omega^3 / 6.
TEST(BodyFlight, TurnsByItsAngularVelocity) {
  const FloatingBody body = floating(block, {}, down);
  const BodyState start = spinning(body);
  const BodyFlight flight(body, start, 0);
  const double h = 1e-5;
  for (const double t : {0.1, 0.5, 2.0}) {
    const Eigen::Matrix3d rate =
        (flight.at(t + h).Q.toRotationMatrix() - flight.at(t - h).Q.toRotationMatrix()) / (2 * h);
    const BodyState at = flight.at(t);
    const Vector3d w = angular_velocity(body, at);
    for (int i = 0; i < 3; ++i)
      EXPECT_LT((rate.col(i) - w.cross(Vector3d(at.Q.toRotationMatrix().col(i)))).norm(), 1e-6 * w.norm());
    EXPECT_LT((at.Q * (body.inertia * (at.Q.conjugate() * w)) - start.L).norm(), 1e-14);
  }
}

// Of every damping, by the equation itself: differences of p and q against what is left of the mode's equation.
TEST(BodyFlight, ModesObeyTheirEquations) {
  FloatingBody body =
      floating(block, {roots({1e4, 3}), roots({1e4, 200}), roots({1e4, 700}), roots({0, 0}), roots({0, 5})}, down);
  body.free = false;
  body.weight << 3, -2, 1, 0.4, 0.7;
  BodyState start = at_rest(body, {1, 2, 3}, {4, 5, 6});
  start.q << 0.1, 0.2, -0.1, 0.3, -0.2, start.p << 5, -3, 2, 0.1, 0.3;
  const BodyFlight flight(body, start, 0);
  const double h = 1e-6;
  EXPECT_EQ(flight.at(0).q, start.q);
  EXPECT_EQ(flight.at(0).p, start.p);
  for (const double t : {0.001, 0.02, 0.3}) {
    const BodyState at = flight.at(t), before = flight.at(t - h), after = flight.at(t + h);
    for (Index i = 0; i < 5; ++i) {
      const Roots& mode = body.modes[static_cast<size_t>(i)];
      const double size = 100 * (std::abs(start.p[i]) + 100 * std::abs(start.q[i]));
      // h^2 omega^4 q / 6 and 1e-16 p / h
      EXPECT_NEAR((after.q[i] - before.q[i]) / (2 * h), at.p[i], 1e-8 * size);
      EXPECT_NEAR((after.p[i] - before.p[i]) / (2 * h), body.weight[i] - 2 * mode.h * at.p[i] - mode.k * at.q[i],
                  1e-6 * size);
    }
    EXPECT_EQ(at.c, start.c);  // what is held stands
    EXPECT_EQ(at.Q.coeffs(), start.Q.coeffs());
  }
}

// On from half way is all the way: no state is hidden.
TEST(BodyFlight, GoesOnFromAnyState) {
  FloatingBody body = floating(block, {roots({1e4, 3}), roots({4e6, 100})}, down);
  BodyState start = spinning(body);
  start.q << 0.1, -0.2, start.p << 3, 4;
  const BodyFlight whole(body, start, 0), rest(body, whole.at(0.4), 0.4);
  const BodyState a = whole.at(1.1), b = rest.at(1.1);
  EXPECT_LT((a.c - b.c).norm(), 1e-13);
  EXPECT_LT(a.Q.angularDistance(b.Q), 1e-12);
  EXPECT_LT((a.q - b.q).norm() + (a.p - b.p).norm() / 100, 1e-12);
  const double energy = mechanical_energy(body, start);
  EXPECT_LE(mechanical_energy(body, a), energy);
  body.modes = {roots({1e4, 0}), roots({4e6, 0})};
  EXPECT_NEAR(mechanical_energy(body, BodyFlight(body, start, 0).at(3)), energy, 1e-11 * std::abs(energy) + 1e-10);
}

TEST(BodyFlight, LeavesStaticShapesBehind) {
  FloatingBody body = floating(block, {}, down);
  body.static_stiffness = MatrixXd::Identity(2, 2);
  BodyState start = at_rest(body, Vector3d::Zero());
  start.s << 1, 2;
  EXPECT_EQ(BodyFlight(body, start, 0).at(0).s, VectorXd::Zero(2));
  start.L.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(BodyFlight(body, start, 0), std::invalid_argument);
}

}  // namespace
}  // namespace mb
