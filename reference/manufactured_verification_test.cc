// Manufactured solutions of the dynamic reference (fem/manufactured_motion_test.h): orders in the step, against the
// closed form of the same mesh. Orders in the mesh: fem/manufactured_orders_verification_test.cc.
#include <gtest/gtest.h>

#include "mechanics/algebra/fitted_order_test.h"
#include "mechanics/system/central_difference.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/explicit_euler.h"
#include "mechanics/system/newmark.h"
#include "mechanics/system/symplectic_euler.h"
#include "mechanics/verified_test.h"
#include "reference/fem/manufactured_motion_test.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

using testing::expect_verified;

using testing::at_the_end;
using testing::ManufacturedMotion;
constexpr double end = testing::manufactured_end;

// Order of steps h, h/2, h/4 against the closed form of the same mesh.
template <typename Make>
double order_in_time(const System& system, const VectorXd& truth, double h, Make make) {
  const std::vector<double> steps{h, h / 2, h / 4};
  std::vector<double> errors;
  for (const double step : steps) errors.push_back((at_the_end(*make(system, step)) - truth).norm());
  return testing::fitted_order(steps, errors);
}

TEST(ManufacturedVerification, ConvergesInTimeAtTheOrderOfTheScheme) {
  const ManufacturedMotion motion({2, {2, 2, 3}});
  const System& system = motion.system();
  const VectorXd truth = at_the_end(*exact(system, end));
  const auto by_newmark = [](const System& s, double h) { return newmark(s, h); };
  const auto by_differences = [](const System& s, double h) { return central_difference(s, h); };
  Vector3d off;
  off[0] = order_in_time(system, truth, end / 400, by_newmark) - 2;
  System lumped = system;  // what central differences step; their damping lags by half a step, which is of order 1
  lumped.M = lumped.lumped_mass;
  off[1] = order_in_time(system, at_the_end(*exact(lumped, end)), end / 800, by_differences) - 1;
  lumped.damping = {};
  System undamped = system;
  undamped.damping = {};
  off[2] = order_in_time(undamped, at_the_end(*exact(lumped, end)), end / 800, by_differences) - 2;
  expect_verified(
      {.quantity = "distance of the order in the step from theory's, absolute: 2 of average acceleration "
                   "and undamped central differences, 1 of damped ones; displacement of a linear box",
       .reference = "manufactured solution",
       .source = "body force of a field of sines; errors are against the closed form of all modes of the mesh",
       .uncertainty = "rounding",
       .tolerance = 0.05,
       .why = "The error's next term, which bends a fit over two halvings, is smaller at these steps."},
      off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  // Adaptive: the error follows the tolerance. Its order: SundialsVerification.OrderFiveInTheMeanStep.
  const auto error = [&](double rtol) { return (at_the_end(*sundials(system, rtol, end)) - truth).norm(); };
  const double loose = error(1e-4), tight = error(1e-7);
  EXPECT_LT(tight, 1e-5 * truth.norm());
  EXPECT_GT(std::log10(loose / tight), 2) << "three decades of tolerance";
}

TEST(ManufacturedVerification, ConvergesInTimeByEitherEulerAtOrderOne) {
  const ManufacturedMotion motion({2, {2, 2, 3}});
  const System& system = motion.system();
  System lumped = system;
  lumped.M = lumped.lumped_mass;
  const VectorXd truth = at_the_end(*exact(lumped, end));
  const auto symplectic = [](const System& s, double h) { return symplectic_euler(s, h); };
  const auto expl = [](const System& s, double h) { return explicit_euler(s, h); };
  const Eigen::Vector2d off(order_in_time(system, truth, end / 1600, symplectic) - 1,
                            order_in_time(system, truth, end / 12800, expl) - 1);
  expect_verified(
      {.quantity = "distance of the order in the step from 1, absolute, of symplectic and explicit Euler; "
                   "displacement of a linear box, its mass lumped",
       .reference = "manufactured solution",
       .source = "body force of a field of sines; errors are against the closed form of all modes of the mesh",
       .uncertainty = "rounding",
       .tolerance = 0.05,
       .why = "The error's next term, which bends a fit over two halvings, is smaller at these steps."},
      off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

// Two routes to one answer: closed form of all modes, adaptive Runge-Kutta, average acceleration extrapolated.
TEST(ManufacturedVerification, ThreeIntegratorsAgree) {
  const ManufacturedMotion motion({2, {2, 2, 3}});
  const System& system = motion.system();
  const VectorXd closed = at_the_end(*exact(system, end));
  const double adaptive = (at_the_end(*sundials(system, 1e-9, end)) - closed).norm() / closed.norm();
  const VectorXd h = at_the_end(*newmark(system, end / 2000)), half = at_the_end(*newmark(system, end / 4000));
  const double extrapolated = ((4 * half - h) / 3 - closed).norm() / closed.norm();
  expect_verified(
      {.quantity = "displacement of a linear box after 1.5 periods of its load, by adaptive Runge-Kutta and "
                   "by average acceleration extrapolated",
       .reference = "second route",
       .source = "closed form of all modes of the same mesh",
       .uncertainty = "rounding of a dense eigenproblem",
       .tolerance = 1e-6,
       .why = "A thousand times the tolerance of a step, 1e-9; of the other route order 4 in 2000 steps is "
              "left."},
      Eigen::Vector2d(adaptive, extrapolated).maxCoeff<Eigen::PropagateNaN>());
}

}  // namespace
}  // namespace mb
