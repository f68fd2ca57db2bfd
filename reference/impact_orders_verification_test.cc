// Whole meshes that meet an obstacle, by explicit steps of their lumped mass: what is left as the step falls.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/verified_test.h"
#include "reference/above_floor_test.h"
#include "reference/full_model.h"
#include "reference/full_order.h"
#include "reference/integrators_test.h"

namespace mb {
namespace {

using testing::expect_verified;

// Falls for 14 ms, is pressed for 15, and flies again.
Scene dropped_ball() {
  Scene scene = one_body(Sphere{0.06}, {1e6, 0.3, 1100, {}}, {2, {1}});
  scene.bodies[0].damping = Rayleigh{0, 1e-4};
  return testing::above_floor(scene, {0, 0, 0.061}, 0.04);
}

// The strains, of which the fall and the flight are no part.
MatrixXd strains(const Model& model, double duration, const Integrator& scheme, double h) {
  const Trajectory answer =
      full_order()->prepare(model, {.time_step = h}, scheme)->simulate({VectorXd::LinSpaced(41, 0, duration)});
  EXPECT_EQ(answer.status, Status::ok);
  return answer.bodies[0].strain;
}

// Against one limit, that of central differences, by which all three are of order one: velocities that damp lag by half
// a step, and the layer opens within one.
TEST(ImpactOrdersVerification, ExplicitStepsOfAWholeMeshHaveOneLimit) {
  const auto scene = std::make_shared<const Scene>(dropped_ball());
  const Model model = build_model(scene);
  constexpr double h = 5e-6;  // [s]
  const auto by = [&](const Integrator& scheme, double step) { return strains(model, scene->duration, scheme, step); };
  const Integrator differences = testing::explicit_steps();
  const MatrixXd limit = 2 * by(differences, h / 32) - by(differences, h / 16);
  ASSERT_GT(limit.norm(), 0);
  double off = 0;
  for (const Integrator& scheme :
       {differences, testing::explicit_steps<&symplectic_euler>(), testing::explicit_steps<&explicit_euler>()}) {
    const double coarse = (by(scheme, h) - limit).norm(), fine = (by(scheme, h / 8) - limit).norm();
    ASSERT_GT(fine, 0);
    off = std::max(off, std::abs(std::log2(coarse / fine) / 3 - 1));
  }
  expect_verified(
      {.quantity = "distance of the order in the step from 1, absolute: strains of a damped ball that drops "
                   "on a floor, a whole mesh by central differences, symplectic and explicit Euler",
       .reference = "converged numbers",
       .source = "central differences at a thirty-second of the step, extrapolated",
       .uncertainty = "4e-6 of the strains, by symplectic Euler; the least error is 5e-5",
       .tolerance = 0.2,
       .why = "Explicit Euler's next term, which makes its orders 1.57, 1.75 and 1.42 from eight times the "
              "step to it, and what the layer that opens within a step leaves."},
      off);
}

}  // namespace
}  // namespace mb
