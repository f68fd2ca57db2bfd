#include "harness/analysis/beyond_linear.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases/contract/physical_shift.h"
#include "harness/analysis/context_test.h"
#include "mechanics/system/stored_energy.h"
#include "reference/finite_bodies_test.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

constexpr double length = 0.3;  // [m] the extent

Scene bent_bar() {  // and drawn a little
  Scene scene = testing::finite_body(Box{{length, 0.05, 0.06}}, {1e6, 0.3, 1100}, {2, {3, 1, 1}});
  scene.bodies[0].supports = {testing::support(Support::Kind::fixed, testing::face("x-min"))};
  testing::load(scene, "x-max", {3e3, 0, 1e3});
  return scene;
}

struct Bent {
  Scene scene = bent_bar();
  std::shared_ptr<const FullModel> model = testing::model_of(scene);
  const System& system = model->system();
  ShiftedFactor shifted = shifted_factor(system, physical_shift(scene.bodies[0]));
  VectorXd u = testing::static_solution(scene, system);
  BeyondLinear beyond(const VectorXd& by) const { return beyond_linear(system, shifted, by, length); }
};

// With both terms the equilibrium is off by the fourth power of the amplitude, with one by the third, with none by the
// second: the force is that of the finite body itself.
TEST(BeyondLinear, BalancesTheLoadToFourthOrder) {
  const Bent bent;
  const VectorXd u = bent.u * (length / bent.u.cwiseAbs().maxCoeff());
  const BeyondLinear terms = bent.beyond(u);
  const auto unbalanced = [&](double e, int n_terms) {
    VectorXd f(u.size()), x = e * u;
    if (n_terms > 1) x += e * e * terms.v2;
    if (n_terms > 2) x += e * e * e * terms.v3;
    EXPECT_TRUE(bent.system.stored_energy->force(x, VectorXd::Zero(u.size()), f));
    return (f - e * (bent.system.K * u)).norm();
  };
  for (const int n_terms : {1, 2, 3})  // the next order adds a few per cent of the amplitude to the slope
    EXPECT_NEAR(std::log2(unbalanced(0.02, n_terms) / unbalanced(0.01, n_terms)), n_terms + 1, 0.1) << n_terms;
}

TEST(BeyondLinear, IsNothingAtTinyLoadsAndGrowsAsItsOrder) {
  const Bent bent;
  const BeyondLinear large = bent.beyond(bent.u), tiny = bent.beyond(1e-6 * bent.u);
  EXPECT_GT(large.v2.norm(), 1e-3 * bent.u.norm());
  EXPECT_LT((tiny.v2 + tiny.v3).norm(), 1e-5 * (1e-6 * bent.u).norm());
  // Both are found at one amplitude: what the factor rounds is left, 1e-3 of it squared away in v2 and cubed in v3.
  EXPECT_LT((1e12 * tiny.v2 - large.v2).norm(), 1e-8 * large.v2.norm());
  EXPECT_LT((1e18 * tiny.v3 - large.v3).norm(), 1e-5 * large.v3.norm());
}

TEST(BeyondLinear, RefusesBadInput) {
  const Bent bent;
  EXPECT_THROW(bent.beyond(0 * bent.u), std::invalid_argument);
  EXPECT_THROW(bent.beyond(std::numeric_limits<double>::quiet_NaN() * bent.u), std::invalid_argument);
  EXPECT_THROW(bent.beyond(bent.u.head(6)), std::invalid_argument);
  const System linear = testing::without_energy(bent.system);
  EXPECT_THROW(beyond_linear(linear, bent.shifted, bent.u, length), std::invalid_argument);
}

TEST(Linearity, IsRefusedOfLinearAndOfFreeBodies) {
  Scene scene = bent_bar();
  scene.duration = scene.samples_per_second = scene.frame_rate = 1;
  scene.bodies[0].kinematics = Kinematics::linear;
  EXPECT_THROW(test::analysed("linearity", scene), std::invalid_argument);
  scene.bodies[0].kinematics = Kinematics::finite;
  scene.bodies[0].supports.clear();
  EXPECT_THROW(test::analysed("linearity", scene), std::invalid_argument);
}

}  // namespace
}  // namespace mb
