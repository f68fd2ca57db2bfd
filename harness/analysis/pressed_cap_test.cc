#include "harness/analysis/pressed_cap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/contact/first_touch_support.h"
#include "mechanics/geometry/graded_rule.h"
#include "mechanics/geometry/superquadric.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

const Superquadric quartic{{0.5, 0.4, 0.3}, 0.5, 0.5};
const Vector3d down(0.3, -0.5, -0.8);

// The integral knows no spheres: as a superquadric one is integrated, as a sphere it has a closed form.
TEST(PressedCapVerification, OfASphereIsTheClosedForm) {
  for (const double depth : {1e-4, 0.05, 0.3}) {
    const PressedCap exact = pressed_cap(Sphere{0.5}, down, depth);
    const PressedCap found = pressed_cap(Superquadric{{0.5, 0.5, 0.5}, 1, 1}, down, depth);
    const double tolerance = 1e-15 / depth + 1e-12;  // heights are known to rounding of the body's size
    EXPECT_NEAR(found.contact.area, exact.contact.area, tolerance * exact.contact.area);
    EXPECT_NEAR(found.contact.force, exact.contact.force, tolerance * exact.contact.force);
    EXPECT_NEAR(found.contact.energy, exact.contact.energy, tolerance * exact.contact.energy);
    EXPECT_NEAR(found.reach, exact.reach, tolerance * exact.reach);
    EXPECT_LT(found.error, tolerance);
  }
}

// Another rule on another parametrisation.
TEST(PressedCapVerification, OfASuperquadricIsWhatAGradedRuleSums) {
  const double depth = 0.03;
  const PressedCap cap = pressed_cap(quartic, down, depth);
  const Vector3d y = support_point(quartic, down), n = -down.normalized();
  const GradedRule rule = graded_rule(quartic, {y}, {2e-3, 1, 0.0, 2}, 1.01 * cap.reach);
  const HeightSamples samples(((rule.points.colwise() - y).transpose() * n).eval(), rule.weights);
  const PlaneContact sum = samples.at(depth);
  EXPECT_NEAR(sum.area, cap.contact.area, 2e-3 * cap.contact.area);  // cells that the rim cuts
  testing::expect_verified(
      {.quantity =
           "force of a layer on a superquadric of semi-axes 0.5, 0.4 and 0.3 and exponents 0.5, 0.03 deep, relative",
       .reference = "second route",
       .source = "a graded rule on the patches of the surface (mechanics/geometry/graded_rule.h)",
       .uncertainty = "up to 5e-5, cells that the rim cuts",
       .tolerance = 5e-5,
       .why = "Cells of 2e-3 in which the integrand has a kink at the rim, where it is small."},
      sum.force / cap.contact.force - 1);
  EXPECT_NEAR(sum.energy, cap.contact.energy, 1e-5 * cap.contact.energy);
  EXPECT_LT(cap.error, 1e-5);
  EXPECT_LT((rule.points.colwise() - y).colwise().norm().maxCoeff(), 2 * cap.reach);
}

// Curvatures are right in the limit: the paraboloid's error falls with the depth.
TEST(PressedCapVerification, TendsToTheParaboloidOfItsCurvatures) {
  const PrincipalCurvatures k = principal_curvatures(quartic, support_point(quartic, down));
  double before = 0;
  for (const double depth : {4e-3, 2e-3, 1e-3}) {
    const double exact = pressed_cap(quartic, down, depth).contact.force;
    const double error = std::abs(contact_by_curvatures(k.values[0], k.values[1], depth).force / exact - 1);
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / error), 1, 0.15);  // depth^1, and part of depth^2
    }
    before = error;
  }
  EXPECT_LT(before, 0.05);
}

TEST(PressedCap, BadInputIsRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(pressed_cap(Box{{1, 1, 1}}, down, 0.1), std::invalid_argument);
  EXPECT_THROW(pressed_cap(quartic, Vector3d::Zero(), 0.1), std::invalid_argument);
  EXPECT_THROW(pressed_cap(quartic, Vector3d(nan, 0, 1), 0.1), std::invalid_argument);
  for (const double bad : {nan, 0.0, -0.1, 0.6}) EXPECT_THROW(pressed_cap(quartic, down, bad), std::invalid_argument);
}

}  // namespace
}  // namespace mb
