// Bodies whose rotation and modes are coupled, through an impact.
#include <gtest/gtest.h>

#include <cmath>

#include "modal/contact/floating_bodies_test.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::coupling_of;
using testing::floating;
using testing::ground;
using testing::momentless_modes;
using testing::plan_of;
using testing::samples_of;

const Shape block = Box{{0.1, 0.06, 0.2}};
const Vector3d down(0, 0, -9.81);

// A block that spins comes down on a corner; so soft a layer that steps resolve every mode.
ImpactPlan corner_first(double step, bool coupled) {
  const PolynomialBasis modes = momentless_modes(block, 2, 6, 5);
  std::vector<Roots> frequencies;
  for (int i = 0; i < 6; ++i) frequencies.push_back(roots({std::pow(500.0 + 150 * i, 2), 0}));
  FloatingBody body = floating(block, frequencies, down);
  if (coupled) body.coupling = coupling_of(block, modes);
  body.contacts.push_back({samples_of(block, modes, {0.01, 0.02, 0.5, 2}), ground, {3e7, 0, {}}});
  BodyState start = at_rest(body, {0, 0, 0.14}, {0.3, 0, -2});
  start.Q = Eigen::Quaterniond(0.8, 0.3, -0.4, 0.2).normalized();
  start.L = body.inertia * Vector3d(20, 14, -10);
  return plan_of(body, block, modes, start, ContactScheme::exact, step);
}

struct End {
  BodyState state;
  double energy_error;  // [-]
  Vector3d impulse;     // [N s]
};
End end_of(double step, bool coupled) {
  const VectorXd times = VectorXd::LinSpaced(2, 0, 0.06);
  const ImpactPlan plan = corner_first(step, coupled);
  const ImpactMotion motion = impact_motion(plan, times);
  EXPECT_EQ(motion.status, Status::ok);
  EXPECT_EQ(motion.contact.touches.size(), 1u);
  const double before = mechanical_energy(plan.body, plan.start), after = motion.energy[1];
  return {motion.states.back(), std::abs(after / before - 1), motion.contact.impulse.col(1)};
}
double apart(const BodyState& a, const BodyState& b) {
  return (a.c - b.c).norm() + 0.1 * a.Q.angularDistance(b.Q) + (a.q - b.q).norm();
}

TEST(CoupledImpact, ConvergesWithOrderTwo) {
  const End truth = end_of(2.5e-6, true), fine = end_of(2e-5, true), coarse = end_of(4e-5, true);
  EXPECT_NEAR(std::log2(apart(coarse.state, truth.state) / apart(fine.state, truth.state)), 2, 0.5);
  EXPECT_LT(fine.energy_error, 1e-5);
  EXPECT_LT(truth.energy_error, fine.energy_error / 16);  // order 2 gives 64
  const ImpactPlan plan = corner_first(2e-5, true);
  const Vector3d gained = plan.body.mass * (fine.state.v - plan.start.v - 0.06 * down);
  EXPECT_LT((gained - fine.impulse).norm(), 1e-10 * fine.impulse.norm());
  EXPECT_GT(apart(end_of(2.5e-6, false).state, truth.state), 10 * apart(fine.state, truth.state));  // it matters
}

// Momenta are no velocities there.
TEST(CoupledImpact, MovesBetweenStepsByItsVelocities) {
  const double h = 2e-5, d = h / 100;
  const ImpactPlan plan = corner_first(h, true);
  const double t = impact_motion(plan, VectorXd::Constant(1, 0.06)).contact.touches.front().start + 20 * h;
  const ImpactMotion motion = impact_motion(plan, VectorXd{{t - d, t, t + d}});
  const VectorXd moved = (motion.states[2].q - motion.states[0].q) / (2 * d), rate = rates(plan.body, motion.states[1]);
  EXPECT_LT((moved - rate).norm(), 0.01 * (motion.states[1].p - rate).norm());
}

TEST(CoupledImpact, HasStepsOfOneSchemeOnly) {
  for (const ContactScheme scheme : {ContactScheme::newmark, ContactScheme::symplectic_euler,
                                     ContactScheme::central_difference, ContactScheme::explicit_euler}) {
    ImpactPlan plan = corner_first(1e-4, true);
    plan.scheme = scheme;
    EXPECT_THROW(impact_motion(plan, VectorXd::Zero(1)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace mb
