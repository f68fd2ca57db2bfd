#include "modal/contact/contact_load.h"

#include <gtest/gtest.h>

#include <cmath>

#include "modal/contact/floating_bodies_test.h"
#include "modal/contact/sampled_pair.h"
#include "modal/frame/turn.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::floating;
using testing::ground;
using testing::random_modes;
using testing::samples_of;
using testing::wall;

const Shape block = Box{{0.1, 0.08, 0.06}};
const RigidSurface tilted = wall({0.01, 0, -0.002}, Vector3d(0.1, -0.2, 1).normalized());
const RigidSurface dome{Sphere{0.3}, 0, {{0.01, 0.02, -0.3}, {1, 0, 0, 0}}};

// A block with three modes and two static shapes, all of them polynomials, on one obstacle.
FloatingBody block_on(const RigidSurface& obstacle, const PenaltyLaw& law, bool free = true) {
  const PolynomialBasis modes = random_modes(block, 2, 3, 1, 7), shapes = random_modes(block, 3, 2, 1e-3, 8);
  FloatingBody body = floating(block, {roots({1e6, 20}), roots({4e6, 0}), roots({9e6, 50})}, {0, 0, -9.81});
  body.free = free;
  SurfaceSamples samples = samples_of(block, modes, {0.01, 0.01, 0, 2});
  samples.Psi = shapes.at(samples.X);
  body.static_stiffness = (Eigen::Matrix2d() << 2, 0.3, 0.3, 1).finished();
  body.contacts.push_back({samples, obstacle, law});
  return body;
}
// Pressed in by about that depth, a little turned, deformed and in motion.
BodyState pressed(const FloatingBody& body, double depth) {
  BodyState state = at_rest(body, {0.004, -0.003, 0.03 - depth}, {0.2, 0.1, -0.3});
  state.Q = Eigen::Quaterniond(1, 0.01, -0.02, 0.3).normalized();
  state.q << 2e-4, -1e-4, 1.5e-4;
  state.p << 0.1, -0.2, 0.05;
  return state;
}
const Vector3d Omega(0.7, -0.4, 1.1);

struct Setting {
  RigidSurface obstacle;
  PenaltyLaw law;
};
class ContactLoadsOn : public ::testing::TestWithParam<Setting> {};

// Forces are what the energy falls by: f = -dE/dz for every part of z, the static shapes following in balance. Central
// differences of step h: h^2 and rounding / h.
TEST_P(ContactLoadsOn, AreTheGradientOfTheStoredEnergy) {
  PenaltyLaw law = GetParam().law;
  law.damping = 0, law.friction.reset();
  const FloatingBody body = block_on(GetParam().obstacle, law);
  const BodyState at = pressed(body, 2e-3);
  ContactLoads loads(body);
  const auto energy = [&](BodyState state) {
    ContactLoad load;
    loads(state, Omega, load);
    return load.stored;
  };
  const double h = 1e-7;
  BodyState here = at;
  ContactLoad load;
  loads(here, Omega, load);
  const double F = load.force.norm();
  for (int i = 0; i < 3; ++i) {
    BodyState plus = at, minus = at;
    plus.c[i] += h, minus.c[i] -= h;
    EXPECT_NEAR(load.force[i], (energy(minus) - energy(plus)) / (2 * h), 1e-5 * F) << i;
    plus = minus = at;
    plus.Q = turned(at.Q, h * Vector3d::Unit(i)), minus.Q = turned(at.Q, -h * Vector3d::Unit(i));
    EXPECT_NEAR(load.torque[i], (energy(minus) - energy(plus)) / (2 * h), 1e-6 * F) << i;
    plus = minus = at;
    plus.q[i] += h, minus.q[i] -= h;
    EXPECT_NEAR(load.modal[i], (energy(minus) - energy(plus)) / (2 * h), 1e-5 * F) << i;
  }
}

TEST_P(ContactLoadsOn, AreNoneAwayFromTheObstacle) {
  const FloatingBody body = block_on(GetParam().obstacle, GetParam().law);
  ContactLoads loads(body);
  BodyState state = pressed(body, -0.2);
  state.s << 0.3, -0.2;  // of an earlier touch
  ContactLoad load;
  loads(state, Omega, load);
  EXPECT_TRUE(load.converged);
  EXPECT_EQ(load.force, Vector3d::Zero());
  EXPECT_EQ(load.modal, VectorXd::Zero(3));
  EXPECT_LT(state.s.norm(), 1e-9);  // without force no static shape
  EXPECT_GE(load.least_gap, 0);
  EXPECT_LT(load.stored, 1e-18);
}

INSTANTIATE_TEST_SUITE_P(Obstacles, ContactLoadsOn,
                         ::testing::Values(Setting{ground, {1e9, 0, {}}}, Setting{tilted, {1e9, 0.3, {}}},
                                           Setting{tilted, {1e13, 0, {}}},
                                           Setting{tilted, {1e9, 0.1, Friction{0.3, 0.5}}}, Setting{dome, {1e9, 0, {}}},
                                           Setting{dome, {1e9, 0.3, {}}}));

// One half-space, two ways: all that pairs add, pressed by static shapes or not.
TEST(ContactPairs, FlatAndGeneralAgreeOnAHalfSpace) {
  for (const bool free : {true, false}) {
    const FloatingBody body = block_on(tilted, {1e9, 0.2, {}}, free);
    const auto flat = flat_pair(body, body.contacts[0]), general = general_pair(body, body.contacts[0]);
    for (const double depth : {1e-4, 1e-3, 4e-3, -0.1}) {
      const BodyState state = pressed(body, depth);
      // Static shapes are at rest in the general one's lever, and so in both only without a spin.
      flat->look(state, Vector3d::Zero(), state.p), general->look(state, Vector3d::Zero(), state.p);
      for (const VectorXd& s : {VectorXd(VectorXd::Zero(2)), VectorXd{{0.02, -0.01}}}) {
        VectorXd f_flat = VectorXd::Zero(2), f_general = f_flat;
        MatrixXd H_flat = MatrixXd::Zero(2, 2), H_general = H_flat;
        flat->push(s, f_flat, H_flat), general->push(s, f_general, H_general);
        EXPECT_LT((f_flat - f_general).norm(), 1e-11 * f_general.norm() + 1e-30);
        EXPECT_LT((H_flat - H_general).norm(), 1e-11 * H_general.norm() + 1e-30);
        const Index n = (free ? 6 : 0) + 5;
        MatrixXd K_flat = MatrixXd::Zero(n, n), K_general = K_flat;
        flat->stiffen(s, 1e4, K_flat), general->stiffen(s, 1e4, K_general);
        EXPECT_LT((K_flat - K_general).norm(), 1e-11 * K_general.norm() + 1e-30);
        EXPECT_EQ(K_general.norm() > 0, depth > 0);
      }
    }
  }
}

// A kilometre from the origin places round by 1e-13 m, 1e-6 of how far so stiff a layer is pressed: forces there are no
// better balanced than that. What the shapes yield, millimetres, is known to 1e-10 all the same, and so the force; ten
// times that for what is pressed at few samples.
TEST(ContactLoads, OfStiffLayersAreBalancedAsFarAsPlacesAreKnown) {
  const Vector3d away(600, -700, 400);
  const auto load_of = [](const FloatingBody& body, BodyState& state) {
    ContactLoads loads(body);
    ContactLoad load;
    loads(state, Omega, load);
    EXPECT_TRUE(load.converged);
    return load;
  };
  for (RigidSurface obstacle : {tilted, dome}) {
    const FloatingBody body = block_on(obstacle, {1e13, 0, {}});
    obstacle.pose.position += away;
    const FloatingBody far = block_on(obstacle, {1e13, 0, {}});
    for (const double depth : {1e-3, 1.5e-3, 2e-3, 3e-3, 4e-3}) {
      BodyState here = pressed(body, depth), there = here;
      there.c += away;
      const Vector3d force = load_of(body, here).force;
      EXPECT_LT((load_of(far, there).force - force).norm(), 1e-8 * force.norm()) << depth;
      EXPECT_LT((here.s - there.s).norm(), 1e-8 * here.s.norm()) << depth;
    }
  }
}

TEST(ContactLoads, OfTwoObstaclesAreTheSum) {
  FloatingBody both = block_on(ground, {1e9, 0, {}}), other = block_on(tilted, {2e9, 0, {}});
  for (FloatingBody* body : {&both, &other}) {
    body->static_stiffness.resize(0, 0);
    body->contacts[0].samples.Psi.resize(body->contacts[0].samples.Psi.rows(), 0);
  }
  const FloatingBody one = both;
  both.contacts.push_back(other.contacts[0]);
  const auto load = [](const FloatingBody& body) {
    BodyState state = pressed(body, 2e-3);
    ContactLoads loads(body);
    ContactLoad of;
    loads(state, Omega, of);
    return of;
  };
  const ContactLoad a = load(one), b = load(other), sum = load(both);
  EXPECT_LT((sum.force - a.force - b.force).norm(), 1e-12 * sum.force.norm());
  EXPECT_LT((sum.torque - a.torque - b.torque).norm(), 1e-12 * sum.torque.norm());
  EXPECT_LT((sum.modal - a.modal - b.modal).norm(), 1e-12 * sum.modal.norm());
  EXPECT_EQ(sum.least_gap, std::min(a.least_gap, b.least_gap));
}

}  // namespace
}  // namespace mb
