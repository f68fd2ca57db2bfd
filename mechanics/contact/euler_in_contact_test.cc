#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "mechanics/contact/contact_steppers.h"
#include "mechanics/contact/spring_on_floor_test.h"

namespace mb {
namespace {

using namespace spring_on_floor;

using Make = std::unique_ptr<Stepper> (*)(const System&, const std::vector<Contact>&, double);
constexpr Make explicit_steps = explicit_euler, symplectic_steps = symplectic_euler;

TEST(EulerInContact, IsOfOrderOneOnASpring) {
  for (const Make make : {explicit_steps, symplectic_steps}) {
    const double coarse = largest_error(make, 900), fine = largest_error(make, 3600);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(4), 1, 0.02);
    EXPECT_LT(fine, 2e-3);
  }
}

// Of fifty steps a bounce off the bare floor: in eigenvalues 1 +- i x, x = omega h, explicit Euler gains 1 + x^2 of the
// energy a step while it presses; symplectic Euler gives back what it took, to the share of a step at either end.
TEST(EulerInContact, ExplicitGainsByTheoryAndSymplecticBouncesBack) {
  System system = spring(0);
  system.v0[2] = -1.5;
  const std::vector<Contact> contacts{on_floor(0)};
  const double omega = std::sqrt(area * k_n / mass), half = pi / omega, x = pi / 50;
  const auto energy = [&](Make make) {
    const States states = make(system, contacts, half / 50)->run(VectorXd{{2 * half}});
    EXPECT_EQ(states.contact.touches.size(), 1u);
    return kinetic_energy(system, states.v.col(0)) / kinetic_energy(system, system.v0);
  };
  EXPECT_NEAR(energy(explicit_steps), std::pow(1 + x * x, 50), 0.02);
  EXPECT_NEAR(energy(symplectic_steps), 1, x * x);
}

// What it writes down of the touch is the motion's: impulse and losses.
TEST(EulerInContact, ImpulseAndLossesAreAccountedFor) {
  System system = spring(0);
  system.v0[2] = -1.5;
  const std::vector<Contact> contacts{on_floor(0, {k_n, 0.3, {}})};
  const double half = pi / std::sqrt(area * k_n / mass), start = kinetic_energy(system, system.v0);
  for (const Make make : {explicit_steps, symplectic_steps}) {
    const States states = make(system, contacts, half / 5000)->run(VectorXd{{2 * half}});
    ASSERT_EQ(states.contact.touches.size(), 1u);
    EXPECT_NEAR(states.contact.touches[0].impulse.z(), mass * (states.v(2, 0) + 1.5), 1e-3 * mass);
    const double lost = states.contact.dissipated[0];
    EXPECT_GT(lost, 0.2 * start);
    EXPECT_NEAR(kinetic_energy(system, states.v.col(0)) + lost, start, 3e-3 * start);
  }
}

TEST(EulerInContact, GrowsPastItsLimitAndSaysSo) {
  System system = spring(k);
  system.v0[2] = -1.5;
  const std::vector<Contact> contacts{on_floor(0)};
  for (const Make make : {explicit_steps, symplectic_steps}) {
    const double past = 2.2 / std::sqrt(k / mass);  // the spring's own, beyond contact's
    EXPECT_EQ(make(system, contacts, past)->run(VectorXd{{2000 * past}}).status, Status::not_finite);
    EXPECT_THROW(make(system, contacts, 0), std::invalid_argument);
    EXPECT_THROW(make(system, contacts, std::nan("")), std::invalid_argument);
  }
}

}  // namespace
}  // namespace mb
