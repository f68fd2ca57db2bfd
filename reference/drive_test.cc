#include <gtest/gtest.h>

#include "mechanics/system/newmark.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using testing::face;
using testing::static_answer;
using testing::static_solution;
using testing::support;

const Box column{{0.2, 0.3, 0.8}};
const Material cork{2e7, 0, 240};  // nu = 0: a column under its weight is one-dimensional

Scene driven(const Material& material, const Drive& drive, const Resolution& resolution) {
  Scene scene = one_body(column, material, resolution);
  scene.bodies[0].supports = {{Support::Kind::driven, face("z-min"), drive}};
  return scene;
}

// Constant acceleration a of the base, static limit: E u'' = rho a, u(0) = 0, u'(L) = 0, hence u = -rho a/E (L z -
// z^2/2).
TEST(Drive, ASteadyAccelerationShortensTheColumn) {
  for (int degree = 2; degree <= 4; ++degree) {  // the parabola is in the space: rounding and the solver's 1e-12
    const auto answer = static_answer(driven(cork, {Vector3d::UnitZ(), Step{30}}, {degree, {1, 1, 3}}));
    const Eigen::ArrayXd z = answer.points.row(2).transpose().array() + 0.4;
    Matrix3Xd expected = Matrix3Xd::Zero(3, z.size());
    expected.row(2) = -240 / 2e7 * (0.8 * z - z.square() / 2);  // per unit of the history
    EXPECT_LT((answer.displacement - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
  }
}

// Base moved along y, no bending since the faces across y carry the shear stress: mu u'' = rho a, for any nu.
TEST(Drive, ASidewaysAccelerationShearsTheColumn) {
  Scene scene = driven({2e7, 0.3, 240}, {Vector3d::UnitY(), Step{30}}, {2, {1, 1, 3}});
  for (const char* name : {"y-min", "y-max"})
    scene.bodies[0].supports.push_back(support(Support::Kind::diaphragm, face(name)));
  const auto answer = static_answer(scene);
  const double mu = 2e7 / 2.6;
  const Eigen::ArrayXd z = answer.points.row(2).transpose().array() + 0.4;
  Matrix3Xd expected = Matrix3Xd::Zero(3, z.size());
  expected.row(1) = -240 / mu * (0.8 * z - z.square() / 2);
  EXPECT_LT((answer.displacement - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
}

TEST(Drive, IsOneMoreColumnAfterTheLoads) {
  Scene scene = driven(cork, {Vector3d::UnitX(), Pulse{0.5, 3}}, {1, {1, 1, 2}});
  scene.bodies[0].supports.push_back({Support::Kind::driven, face("z-max"), scene.bodies[0].supports[0].drive});
  testing::load(scene, "x-max", {0, 1, 0});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& s = model->system();
  ASSERT_EQ(s.F.cols(), 2);
  ASSERT_EQ(s.s.size(), 2u);
  EXPECT_EQ(s.s[0], History(Step{}));
  EXPECT_EQ(s.s[1], History(Pulse{0.5, 3}));
  EXPECT_EQ(s.F.rows(), 12);  // both ends ride on the base
  // Half of the mass belongs to the middle's shape functions.
  EXPECT_NEAR(s.F.col(1).sum(), -0.5 * 240 * 0.2 * 0.3 * 0.8, 1e-12);
}

// A base that moves slowly against the first period T1 of the block takes it along: the relative displacement is the
// static one up to s''/omega1^2 <= (T1/T)^2/2, and a free oscillation of that size from either end of the pulse. With
// T1 of a steel block near 4 ms: 3 x 8e-4.
TEST(Drive, AStiffBlockFollowsASlowBase) {
  const double T = 0.1;
  Scene scene = driven({2e11, 0.3, 7800}, {Vector3d(0.6, 0, 0.8), Pulse{T, 9.81}}, {2, {1, 1, 2}});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const System& s = model->system();
  const VectorXd steady = static_solution(scene, s);
  const VectorXd t = VectorXd::LinSpaced(21, 0, T);
  const States states = newmark(s, T / 400)->run(t);
  for (Index k = 0; k < t.size(); ++k) {
    const VectorXd error = states.u.col(k) - value(s.s[0], t[k]) * steady;
    EXPECT_LT(error.norm(), 2.4e-3 * 9.81 * steady.norm()) << t[k];
  }
}

TEST(Drive, RefusesWhatIsNoSingleBase) {
  const Drive along_x{Vector3d::UnitX(), Step{}};
  const auto model = [](const std::vector<Support>& supports) {
    Scene scene = one_body(column, cork, {1, {1, 1, 2}});
    scene.bodies[0].supports = supports;
    return full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  };
  using K = Support::Kind;
  EXPECT_NO_THROW(model({{K::driven, face("z-min"), along_x}}));
  EXPECT_THROW(model({{K::driven, face("z-min"), {}}}), std::invalid_argument);
  EXPECT_THROW(model({{K::fixed, face("z-min"), along_x}}), std::invalid_argument);
  EXPECT_THROW(model({{K::driven, face("z-min"), Drive{{1, 1, 0}, Step{}}}}), std::invalid_argument);
  EXPECT_THROW(model({{K::driven, face("z-min"), Drive{{std::nan(""), 0, 0}, Step{}}}}), std::invalid_argument);
  EXPECT_THROW(model({{K::driven, face("z-min"), along_x}, {K::driven, face("z-max"), Drive{{1, 0, 0}, Step{2}}}}),
               std::invalid_argument);
  EXPECT_THROW(model({{K::driven, face("z-min"), along_x}, {K::driven, face("z-max"), Drive{{0, 1, 0}, Step{}}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace mb
