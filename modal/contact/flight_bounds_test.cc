#include "modal/contact/flight_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modal/contact/floating_bodies_test.h"
#include "modal/contact/next_touch.h"
#include "modal/frame/body_flight.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::coupling_of;
using testing::floating;
using testing::ground;
using testing::momentless_modes;
using testing::plan_of;

const Shape block = Box{{0.1, 0.06, 0.2}};
const Vector3d down(0, 0, -9.81);

struct Tumbler {
  PolynomialBasis modes = momentless_modes(block, 2, 8, 5);
  FloatingBody body;
  BodyState start;

  // spin: of the lowest frequency; amplitude [m] of the modes.
  Tumbler(double spin, double amplitude, double damping) {
    std::vector<Roots> frequencies;
    for (int i = 0; i < 8; ++i) frequencies.push_back(roots({std::pow(400.0 + 150 * i, 2), damping}));
    body = floating(block, frequencies, down);
    body.coupling = coupling_of(block, modes);
    start = at_rest(body, {0, 0, 0.5});
    start.L = body.inertia * Vector3d(0.5, 0.7, -0.4) * spin * 400;
    for (Index i = 0; i < 8; ++i) start.q[i] = amplitude * std::sqrt(body.mass) * (i % 2 ? 1 : -1);
  }
};

// Their making: orthonormal, without momentum.
TEST(MomentlessModes, AreWhatTheySay) {
  const PolynomialBasis modes = momentless_modes(block, 2, 8, 5);
  const Quadrature volume = volume_quadrature(block);
  const MatrixXd Phi = modes.at(volume.points);
  const VectorXd mass = 1000 * volume.weights.replicate(1, 3).transpose().reshaped();
  EXPECT_LT((Phi.transpose() * mass.asDiagonal() * Phi - MatrixXd::Identity(8, 8)).norm(), 1e-12);
  for (Index j = 0; j < 8; ++j) {
    const auto phi = Phi.col(j).reshaped(3, volume.points.cols());
    Vector3d P = Vector3d::Zero(), L = Vector3d::Zero();
    for (Index i = 0; i < volume.points.cols(); ++i) {
      P += 1000 * volume.weights[i] * phi.col(i);
      L += 1000 * volume.weights[i] * Vector3d(volume.points.col(i)).cross(Vector3d(phi.col(i)));
    }
    EXPECT_LT(P.norm() + L.norm(), 1e-12);
  }
}

// Of a long flight, slow and fast, damped and not, by differences of states: below the bounds from its start and from
// any later time, and not by orders of magnitude below those of the angular velocity.
TEST(FlightBounds, HoldForCoupledFlight) {
  for (const double spin : {0.02, 0.08})
    for (const double damping : {0.0, 60.0}) {
      const Tumbler of(spin, 4e-4, damping);
      const ShapeBounds shapes = shape_bounds(block, of.modes);
      const BodyFlight flight(of.body, of.start, 0);
      const Matrix3Xd X = surface_quadrature(block).points;
      const MatrixXd Phi = of.modes.at(X);
      double fastest = 0;
      for (int k = 0; k < 60; ++k) {
        const double t = 1e-3 * k + 1e-5, d = 1e-6;
        const BodyState a = flight.at(t - d), b = flight.at(t), c = flight.at(t + d);
        const FlightBounds most = flight_bounds(of.body, shapes, flight.at(k < 30 ? 0 : 0.03), 0.06).value();
        const Vector3d Omega = angular_velocity(of.body, b),
                       Omega_t = (angular_velocity(of.body, c) - angular_velocity(of.body, a)) / (2 * d);
        fastest = std::max(fastest, Omega.norm() / most.Omega);
        EXPECT_LE(Omega.norm(), most.Omega);
        EXPECT_LE(Omega_t.norm(), most.Omega_t);
        const auto largest = [&](const VectorXd& q) {
          return (Phi * q).reshaped(3, X.cols()).colwise().norm().maxCoeff();
        };
        EXPECT_LE(largest(b.q), most.u);
        EXPECT_LE(largest(rates(of.body, b)), most.u_t);
        EXPECT_LE(largest((rates(of.body, c) - rates(of.body, a)) / (2 * d)), most.u_tt);
      }
      EXPECT_GT(fastest, 0.1);
    }
}

TEST(FlightBounds, AreNoneWhereABodySpinsAsFastAsItVibrates) {
  Tumbler of(1, 0, 0);
  of.body.contacts.push_back({{}, ground, {1e9, 0, {}}});
  EXPECT_FALSE(flight_bounds(of.body, shape_bounds(block, of.modes), of.start, 1));
  ImpactPlan plan = plan_of(of.body, block, of.modes, of.start, ContactScheme::exact, 1e-5);
  const BodyFlight flight(plan.body, plan.start, 0);
  const auto touch = next_touch(plan, flight, 1, false);
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->t, 0);
  EXPECT_FALSE(touch->decided);  // nothing is proved: who steps from then on misses nothing
}

// The surface's lowest point of many times against the time that was found.
TEST(NextTouch, FindsThatOfCoupledFlight) {
  for (const double spin : {0.02, 0.08}) {
    Tumbler of(spin, 4e-4, 0);
    of.body.contacts.push_back({{}, ground, {1e9, 0, {}}});
    const ImpactPlan plan = plan_of(of.body, block, of.modes, of.start, ContactScheme::exact, 1e-5);
    const BodyFlight flight(plan.body, plan.start, 0);
    const auto touch = next_touch(plan, flight, 1, false);
    ASSERT_TRUE(touch && touch->decided);
    Matrix3Xd X(3, 8);  // corners and edges: where a box lands; faces of a slightly bent one bulge less than 1e-3
    for (int i = 0; i < 8; ++i) X.col(i) = Vector3d(i & 1 ? 0.05 : -0.05, i & 2 ? 0.03 : -0.03, i & 4 ? 0.1 : -0.1);
    const auto lowest = [&](double t) {
      const BodyState at = flight.at(t);
      const PolynomialMap map = of.modes.map(at.q);
      double z = 1;
      for (Index i = 0; i < 8; ++i) z = std::min(z, (at.c + at.Q * map.at(X.col(i)).x).z());
      return z;
    };
    for (int k = 0; k <= 400; ++k) EXPECT_GT(lowest(touch->t * k / 400.0 - 1e-9), -1e-12);
    EXPECT_LT(std::abs(lowest(touch->t)), 1e-10);
    // It is not the touch of the body without coupling.
    FloatingBody alone = of.body;
    alone.coupling = nullptr;
    const ImpactPlan other = plan_of(alone, block, of.modes, of.start, ContactScheme::exact, 1e-5);
    const BodyFlight apart(other.body, other.start, 0);
    EXPECT_GT(std::abs(next_touch(other, apart, 1, false)->t - touch->t), 1e-8);
  }
}

}  // namespace
}  // namespace mb
