#include "harness/analysis/dropped_coupling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/catalogue.h"
#include "mechanics/system/oscillators_test.h"

namespace mb {
namespace {

constexpr double duration = 2;      // [s]
constexpr double steps_off = 1e-5;  // [-] of adaptive steps at rtol 1e-8, whose errors add up over ten periods
const VectorXd times = VectorXd::LinSpaced(101, 0, duration);

DroppedCoupling dropped(const System& system) {
  const Catalogue catalogue = default_catalogue();
  return dropped_coupling(system, damping_matrix(system), catalogue.integrator("exact"),
                          catalogue.integrator("sundials"), times, duration, 1e-6);
}

// The first pulled aside; a damper between them.
System two_masses(const VectorXd& omega, const Rayleigh& damping, double damper) {
  System system = test::oscillators(omega, damping);
  system.u0 = VectorXd::Unit(2, 0);
  system.modal_damping = {VectorXd{{1, -1}}, VectorXd::Constant(1, damper)};
  return system;
}

TEST(DroppedCoupling, OfDiagonalDampingIsNone) {
  System system = test::oscillators(VectorXd{{7, 11, 30}}, {0.9, 2e-3});
  system.u0 = VectorXd{{1, -0.5, 0.2}};
  const MatrixXd C = damping_matrix(system);
  EXPECT_EQ(largest_coupling(C), 0);
  EXPECT_NEAR(C(1, 1), 0.9 + 2e-3 * 121, 1e-14);
  const DroppedCoupling found = dropped(system);
  EXPECT_LT(found.error, 1e-13);
  EXPECT_LT(found.closed_form_against_steps, steps_off);
}

// q'' + c q' + w^2 q = 0 from rest at 1
double decaying(double w, double c, double t) {
  const double h = c / 2, mu = std::sqrt(w * w - h * h);
  return std::exp(-h * t) * (std::cos(mu * t) + h / mu * std::sin(mu * t));
}

// Of two equal masses a damper between them brakes what they do against each other by 2 c and their common motion not
// at all, whereas the diagonal of C brakes the first by c and leaves the second at rest.
TEST(DroppedCoupling, OfTwoEqualMassesIsThatOfTheirClosedForms) {
  const double w = 9, c = 1.7;
  const System system = two_masses(VectorXd{{w, w}}, {}, c);
  EXPECT_NEAR(largest_coupling(damping_matrix(system)), 1, 1e-15);
  double off = 0, size = 0;
  for (const double t : times) {
    const double common = std::cos(w * t) / 2, against = decaying(w, 2 * c, t) / 2;
    const Eigen::Vector2d u(common + against, common - against), diagonal(decaying(w, c, t), 0);
    off += (diagonal - u).squaredNorm();
    size += u.squaredNorm();
  }
  const DroppedCoupling found = dropped(system);
  EXPECT_NEAR(found.error, std::sqrt(off / size), 1e-12);
  EXPECT_GT(found.error, 0.5);
  EXPECT_LT(found.closed_form_against_steps, steps_off);
}

// The diagonal leaves the second mode at rest; what it does is of first order in the damper.
TEST(DroppedCoupling, OfModesFarApartGrowsWithTheDamper) {
  const double weak = dropped(two_masses(VectorXd{{9, 40}}, {1, 0}, 0.01)).error;
  const double twice = dropped(two_masses(VectorXd{{9, 40}}, {1, 0}, 0.02)).error;
  EXPECT_LT(weak, 1e-3);
  EXPECT_NEAR(twice / weak, 2, 0.05);
}

// Roundings of a large entry are no coupling of modes that next to nothing damps.
TEST(DroppedCoupling, OfRoundingIsNone) {
  MatrixXd C = VectorXd{{1e10, 1e-6, 4}}.asDiagonal();
  C(0, 1) = C(1, 0) = 5e-4;
  EXPECT_EQ(largest_coupling(C), 0);
  C(0, 2) = C(2, 0) = 2e4;
  EXPECT_EQ(couplings(C), (VectorXd{{0.1, 0, 0.1}}));
  EXPECT_EQ(largest_coupling(MatrixXd(0, 0)), 0);
  C(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(couplings(C).array().isNaN().all() && std::isnan(largest_coupling(C)));
}

TEST(DroppedCoupling, RefusesBadInput) {
  System still = two_masses(VectorXd{{7, 11}}, {1, 0}, 0.5);
  still.u0.setZero();
  EXPECT_THROW(dropped(still), std::invalid_argument);
  const System system = two_masses(VectorXd{{7, 11}}, {1, 0}, 0.5);
  class Failing : public Stepper {
    States run(const VectorXd&) const override {
      States none;
      none.status = Status::no_convergence;
      return none;
    }
  };
  const Integrator failing{"failing", "", [](const System&, const Settings&, double) -> std::unique_ptr<Stepper> {
                             return std::make_unique<Failing>();
                           }};
  try {
    dropped_coupling(system, damping_matrix(system), default_catalogue().integrator("exact"), failing, times, duration,
                     1e-6);
    FAIL() << "a run that failed was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("failing: "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mb
