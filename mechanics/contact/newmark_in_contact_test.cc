#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/contact/contact_steppers.h"
#include "mechanics/contact/spring_on_floor_test.h"

namespace mb {
namespace {

using namespace spring_on_floor;

const auto average_acceleration = [](const System& system, const std::vector<Contact>& contacts, double h) {
  return newmark(system, contacts, h);
};

TEST(NewmarkInContact, IsOfOrderTwoOnASpring) {
  const double coarse = largest_error(average_acceleration, 90), fine = largest_error(average_acceleration, 360);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4), 2, 0.02);
  EXPECT_LT(fine, 1e-4);
}

// Average acceleration keeps the energy of what is linear, to the tolerance of its stages: 1e-9 of the speed a step.
TEST(NewmarkInContact, KeepsEnergyWhilePressed) {
  System system = spring(k);
  system.v0[2] = -1.5;
  const std::vector<Contact> contacts{on_floor(0)};
  const double omega = std::sqrt((k + area * k_n) / mass), T = 0.9 * pi / omega;
  const VectorXd times = VectorXd::LinSpaced(100, 0, T);
  const States states = newmark(system, contacts, T / 99)->run(times);
  const double start = kinetic_energy(system, system.v0);
  for (Index i = 0; i < 100; ++i) {
    const double energy =
        kinetic_energy(system, states.v.col(i)) + strain_energy(system, states.u.col(i)) + states.contact.stored[i];
    EXPECT_NEAR(energy, start, 1e-6 * start) << i;
  }
  EXPECT_GT(states.contact.stored.maxCoeff(), 0.9 * start * area * k_n / (k + area * k_n));
}

// It bounces: the touch, its peak, its impulse and the free swing after it, by hand.
TEST(NewmarkInContact, WritesDownTheTouch) {
  System system = spring(0);
  system.v0[2] = -1.5;
  const std::vector<Contact> contacts{on_floor(0)};
  const double omega = std::sqrt(area * k_n / mass), half = pi / omega;
  const States states = newmark(system, contacts, half / 500)->run(VectorXd{{2 * half, 3 * half}});
  ASSERT_EQ(states.contact.touches.size(), 1u);
  const Touch& touch = states.contact.touches[0];
  EXPECT_NEAR(touch.start, 0, 1e-15);
  EXPECT_NEAR(touch.end, half, 1e-4 * half);
  EXPECT_NEAR(touch.peak_time, half / 2, 1e-4 * half);
  EXPECT_NEAR(touch.peak_force, 1.5 * mass * omega, 1e-4 * touch.peak_force);
  EXPECT_NEAR(touch.impulse.z(), mass * (states.v(2, 0) + 1.5), 1e-9 * mass);  // by its own quadrature
  EXPECT_NEAR(states.v(2, 0), 1.5, 1e-4 * 1.5);
  EXPECT_EQ(states.v.col(0), states.v.col(1));
  EXPECT_EQ(states.contact.force.col(0), Vector3d::Zero());
  EXPECT_EQ(states.work.factorisations, 1);
  EXPECT_GE(states.work.solves, states.work.steps);
}

// What the layer loses is what is missing.
TEST(NewmarkInContact, LossesAreAccountedFor) {
  const auto defect = [](int n) {
    System system = spring(0);
    system.v0[2] = -1.5;
    const std::vector<Contact> contacts{on_floor(0, {k_n, 0.3, {}})};
    const double half = pi / std::sqrt(area * k_n / mass);
    const States states = newmark(system, contacts, half / n)->run(VectorXd{{2 * half}});
    const double start = kinetic_energy(system, system.v0), lost = states.contact.dissipated[0];
    EXPECT_GT(lost, 0.2 * start);
    return std::abs(kinetic_energy(system, states.v.col(0)) + lost - start) / start;
  };
  const double coarse = defect(50), fine = defect(400);
  EXPECT_LT(fine, 2e-5);
  EXPECT_LT(fine, coarse / 20);  // 64 but for the kinks at the ends
}

// A stage that cannot be solved is reported, not passed over: the load is no number from half way on.
TEST(NewmarkInContact, WhatDoesNotConvergeIsReported) {
  System system = spring(k);
  system.v0[2] = -1.5;
  const std::vector<Contact> contacts{on_floor(0, {std::numeric_limits<double>::max(), 0, {}})};
  const States states = newmark(system, contacts, 1e-4)->run(VectorXd{{1e-3}});
  EXPECT_NE(states.status, Status::ok);
  EXPECT_THROW(newmark(system, contacts, 0), std::invalid_argument);
  EXPECT_THROW(newmark(system, contacts, std::nan("")), std::invalid_argument);
}

TEST(NewmarkInContact, WithoutTouchIsFree) {
  System system = spring(k);
  system.u0[2] = 1e-3;
  const std::vector<Contact> contacts{on_floor(0.01)};
  const VectorXd times = VectorXd::LinSpaced(5, 0, 0.05);
  const States states = newmark(system, contacts, 1e-5)->run(times);
  const double omega = std::sqrt(k / mass);
  EXPECT_TRUE(states.contact.touches.empty());
  for (Index i = 0; i < 5; ++i) EXPECT_NEAR(states.u(2, i), 1e-3 * std::cos(omega * times[i]), 1e-7);
}

}  // namespace
}  // namespace mb
