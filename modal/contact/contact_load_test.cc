#include "modal/contact/contact_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "modal/contact/contact_pair.h"
#include "modal/contact/contact_step.h"
#include "modal/contact/floating_bodies_test.h"
#include "modal/contact/turn.h"

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

// The sums of the header, sample by sample, in a state whose static shapes are given.
ContactLoad by_hand(const FloatingBody& body, const BodyState& at, const Vector3d& spin, VectorXd& on_shapes) {
  ContactLoad sum{Vector3d::Zero(),
                  Vector3d::Zero(),
                  VectorXd::Zero(body.n_modes()),
                  std::numeric_limits<double>::infinity(),
                  0,
                  0,
                  0,
                  true};
  on_shapes = VectorXd::Zero(body.n_static());
  const Eigen::Matrix3d Q = at.Q.toRotationMatrix();
  for (const auto& [samples, surface, law] : body.contacts)
    for (Index i = 0; i < samples.w.size(); ++i) {
      const auto Phi = samples.Phi.middleRows(3 * i, 3), Psi = samples.Psi.middleRows(3 * i, 3);
      const Vector3d r = Q * (samples.X.col(i) + Phi * at.q + Psi * at.s);
      const Vector3d r_0 = Q * (samples.X.col(i) + Phi * at.q);  // what static shapes add is left out of the damping
      const Gap g = gap(surface, at.c + r);
      sum.least_gap = std::min(sum.least_gap, g.value);
      const Vector3d v =
          at.v + spin.cross(law.friction || dome.shape.index() == surface.shape.index() ? r_0 : r) + Q * (Phi * at.p);
      const Vector3d f = samples.w[i] * contact_traction(law, g, v).t;
      sum.force += f;
      sum.torque += r.cross(f);
      sum.modal += Phi.transpose() * (Q.transpose() * f);
      on_shapes += Psi.transpose() * (Q.transpose() * f);
      sum.stored += samples.w[i] * stored_energy(law, g.value);
    }
  sum.stored += 0.5 * at.s.dot(body.static_stiffness * at.s);
  return sum;
}

struct Setting {
  RigidSurface obstacle;
  PenaltyLaw law;
};
class ContactLoadsOn : public ::testing::TestWithParam<Setting> {};

TEST_P(ContactLoadsOn, AreTheSumsOverSamples) {
  for (const double depth : {1e-4, 3e-3}) {
    const FloatingBody body = block_on(GetParam().obstacle, GetParam().law);
    BodyState state = pressed(body, depth);
    ContactLoads loads(body);
    ContactLoad load;
    for (int again = 0; again < 3; ++again) {  // what was found before is no part of the answer
      loads(state, Omega, load);
      ASSERT_TRUE(load.converged);
      VectorXd on_shapes;
      const ContactLoad sum = by_hand(body, state, Omega, on_shapes);
      const double F = sum.force.norm();
      ASSERT_GT(F, 0);
      EXPECT_LT((load.force - sum.force).norm(), 1e-11 * F);
      EXPECT_LT((load.torque - sum.torque).norm(), 1e-11 * F * 0.1);
      EXPECT_LT((load.modal - sum.modal).norm(), 1e-11 * F);
      EXPECT_NEAR(load.stored, sum.stored, 1e-11 * sum.stored);
      EXPECT_NEAR(load.least_gap, sum.least_gap, 1e-15);
      EXPECT_GT(load.n_visited, 0);
      // K_s s = sum Psi^T Q^T f, to 1e-10 of either side.
      EXPECT_LT((body.static_stiffness * state.s - on_shapes).norm(), 2e-10 * on_shapes.norm() + 1e-14 * F);
      state.c.z() -= 1e-5;
    }
  }
}

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

// By differences of the forces. Left out are turns of the forces' levers, F |x - c| beside k |x - c|^2: as much as the
// depth is of the lever.
TEST_P(ContactLoadsOn, HaveTheStiffnessOfTheirDifferences) {
  for (const bool free : {true, false}) {
    PenaltyLaw law = GetParam().law;
    law.damping = std::min(law.damping, 0.05);
    const FloatingBody body = block_on(GetParam().obstacle, law, free);
    BodyState at = pressed(body, 2e-3);
    at.v.setZero(), at.p /= 100;
    const Vector3d spin = free ? Vector3d(0.01, 0.02, 0) : Vector3d::Zero();
    const Index n = free ? 9 : 3;
    ContactLoads loads(body);
    ContactLoad load;
    loads(at, spin, load);
    const MatrixXd K = loads.stiffness(at.s, 0), C = (loads.stiffness(at.s, 1) - K);
    ASSERT_EQ(K.rows(), n);
    const auto force = [&](BodyState state, const Vector3d& turn) {
      ContactLoad of;
      loads(state, turn, of);
      VectorXd f(n);
      if (free) f.head<6>() << of.force, of.torque;
      f.tail(3) = of.modal;
      return f;
    };
    MatrixXd by_place(n, n), by_rate(n, n);
    const double h = 1e-8, u = 1e-4;
    const auto moved = [&](Index k, double by) {
      BodyState state = at;
      if (k < n - 3 && k < 3) state.c[k] += by;
      if (k < n - 3 && k >= 3) state.Q = turned(at.Q, by * Vector3d::Unit(k - 3));
      if (k >= n - 3) state.q[k - n + 3] += by;
      return force(state, spin);
    };
    const auto faster = [&](Index k, double by) {
      BodyState state = at;
      Vector3d turn = spin;
      if (k < n - 3 && k < 3) state.v[k] += by;
      if (k < n - 3 && k >= 3) turn[k - 3] += by;
      if (k >= n - 3) state.p[k - n + 3] += by;
      return force(state, turn);
    };
    for (Index k = 0; k < n; ++k) {
      by_place.col(k) = (moved(k, -h) - moved(k, h)) / (2 * h);
      by_rate.col(k) = (faster(k, -u) - faster(k, u)) / (2 * u);
    }
    // Columns and rows by their own size: turns are levers of 0.05 m beside moves of 1.
    VectorXd scale = VectorXd::Ones(n);
    if (free) scale.segment<3>(3).setConstant(1 / 0.05);
    const auto scaled = [&](const MatrixXd& A) { return MatrixXd(scale.asDiagonal() * A * scale.asDiagonal()); };
    EXPECT_LT(scaled(K - by_place).norm(), 0.05 * scaled(by_place).norm()) << free;
    if (law.damping > 0 || law.friction) {
      EXPECT_LT(scaled(C - by_rate).norm(), 0.05 * scaled(by_rate).norm()) << free;
    } else {
      EXPECT_EQ(C.norm(), 0);
    }
    const double skew = (K - K.transpose()).norm();
    EXPECT_TRUE(law.friction || skew < 1e-12 * K.norm()) << skew;
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
      flat->look(state, Vector3d::Zero()), general->look(state, Vector3d::Zero());
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
