#include "mechanics/system/static_response.h"

#include <gtest/gtest.h>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/algebra/noise.h"

namespace mb {
namespace {

using testing::box_system;
using testing::BoxMesh;

// Loads as smooth as tractions are, and one that is rough.
MatrixXd loads(const testing::BoxSystem& box) {
  MatrixXd F = MatrixXd::Zero(box.system.M.rows(), 3);
  for (size_t i = 0; i < box.dof.size(); ++i) {
    if (box.dof[i] < 0) continue;
    const Vector3d x = box.nodes.col(static_cast<Index>(i / 3));
    F(box.dof[i], 0) = i % 3 == 2 ? x[2] * x[2] : 0;
    F(box.dof[i], 1) = i % 3 == 0 ? std::sin(3 * x[2]) * x[1] : 0;
  }
  F.col(2) = uniform_noise(F.rows(), 11);
  return F;
}

struct Named {
  const char* name;
  BoxMesh box;
  Index n_rigid;
};
class StaticResponse : public ::testing::TestWithParam<Named> {};

TEST_P(StaticResponse, SatisfiesItsEquations) {
  const testing::BoxSystem box = box_system(GetParam().box);
  const System& body = box.system;
  ASSERT_EQ(body.R.cols(), GetParam().n_rigid);
  const MatrixXd F = loads(box);
  const double scale = body.K.diagonal().mean() / body.M.diagonal().mean();
  const MatrixXd x = inertia_relief(body, shifted_factor(body, -1e-4 * scale), F);
  const MatrixXd f = F - body.M * body.R * (body.R.transpose() * F);
  for (Index j = 0; j < F.cols(); ++j) {
    EXPECT_LT((body.K * x.col(j) - f.col(j)).norm(), 1e-12 * F.col(j).norm()) << "load " << j;
    if (body.R.cols() == 0) continue;
    const double size = std::sqrt(x.col(j).dot(body.M * x.col(j)));
    EXPECT_LT((body.R.transpose() * (body.M * x.col(j))).norm(), 1e-14 * 100 * size) << "load " << j;
  }
}

TEST_P(StaticResponse, DoesNotDependOnTheShift) {
  const testing::BoxSystem box = box_system(GetParam().box);
  const System& body = box.system;
  const double scale = body.K.diagonal().mean() / body.M.diagonal().mean();
  const MatrixXd x = inertia_relief(body, shifted_factor(body, -1e-5 * scale), loads(box));
  const MatrixXd y = inertia_relief(body, shifted_factor(body, -1e-3 * scale), loads(box));
  EXPECT_LT((x - y).norm(), 1e-9 * x.norm());  // residual 1e-12 times the condition number of K, below 1e3
}

INSTANTIATE_TEST_SUITE_P(
    Supports, StaticResponse,
    ::testing::Values(
        Named{"free", {.cells = {4, 4, 6}, .size = {0.1, 0.1, 0.3}, .E = 2e4, .nu = 0.45, .rho = 1100}, 6},
        Named{"quadratic", {.cells = {2, 2, 3}, .degree = 2, .size = {1, 1, 2}}, 6},
        Named{
            "sliding", {.cells = {3, 3, 4}, .fixed = [](const Vector3d& x, int a) { return a == 2 && x[2] == 0; }}, 3},
        Named{"clamped", {.cells = {3, 3, 4}, .fixed = [](const Vector3d& x, int) { return x[2] == 0; }}, 0}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(StaticResponse, OfAClampedBodyIsTheInverse) {
  const testing::BoxSystem box =
      box_system({.cells = {3, 3, 4}, .fixed = [](const Vector3d& x, int) { return x[2] == 0; }});
  const MatrixXd F = loads(box);
  const MatrixXd expected = MatrixXd(box.system.K).llt().solve(F);
  const MatrixXd x = inertia_relief(box.system, shifted_factor(box.system, -0.01), F);
  EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm());  // condition about 1e3
}

TEST(StaticResponse, ToALoadThatOnlyMovesTheBodyIsZero) {
  const System body = box_system({.cells = {3, 3, 3}}).system;
  const MatrixXd gravity = body.M * body.R;
  EXPECT_EQ(inertia_relief(body, shifted_factor(body, -0.01), gravity).norm(), 0);
  EXPECT_EQ(inertia_relief(body, shifted_factor(body, -0.01), MatrixXd(body.M.rows(), 0)).cols(), 0);
}

TEST(StaticResponse, RefusesBadInput) {
  System body = box_system({.cells = {2, 2, 2}}).system;
  EXPECT_THROW(shifted_factor(body, 0), std::invalid_argument);
  const ShiftedFactor shifted = shifted_factor(body, -1);
  EXPECT_THROW(inertia_relief(body, shifted, MatrixXd::Ones(3, 1)), std::invalid_argument);
  EXPECT_THROW(inertia_relief(body, shifted, MatrixXd::Constant(body.M.rows(), 1, NAN)), std::invalid_argument);
  body.R.conservativeResize(body.R.rows(), 5);  // a rigid mode forgotten: f is outside the range of K
  EXPECT_THROW(inertia_relief(body, shifted, uniform_noise(body.M.rows(), 1)), std::runtime_error);
}

}  // namespace
}  // namespace mb
