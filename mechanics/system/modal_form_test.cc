#include "mechanics/system/modal_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mechanics/system/small_test_systems.h"

namespace mb {
namespace {

using testing::small_box;
using testing::with_all_damping;

void expect_diagonal(const System& s) {
  const ModalForm form = modal_form(s);
  const Index n = s.M.rows();
  const MatrixXd Phi = form.Phi.size() > 0 ? form.Phi : MatrixXd::Identity(n, n);
  const MatrixXd I = Phi.transpose() * (s.M * Phi), K = Phi.transpose() * (s.K * Phi);
  MatrixXd C(n, n);
  for (Index i = 0; i < n; ++i) C.col(i) = Phi.transpose() * apply_damping(s, Phi.col(i));
  EXPECT_LE((I - MatrixXd::Identity(n, n)).norm(), 1e-12);
  EXPECT_LE((K - MatrixXd(form.lambda.asDiagonal())).norm(), 1e-12 * K.norm());
  EXPECT_LE((C - MatrixXd(form.c.asDiagonal())).norm(), 1e-12 * C.norm());
  EXPECT_GE(form.c.minCoeff(), 0);
  EXPECT_TRUE(form.c.head(s.R.cols()).isZero(0));
}

TEST(ModalForm, DiagonalisesModalDamping) {
  for (const bool is_clamped : {false, true}) expect_diagonal(with_all_damping(small_box(is_clamped)));
  const System free = with_all_damping(small_box(false));
  const System reduced = testing::in_modal_coordinates(free, modal_form(free));
  EXPECT_EQ(modal_form(reduced).Phi.size(), 0);
  expect_diagonal(reduced);
}

TEST(ModalForm, GivesEveryModeItsRatio) {
  System s = small_box(false);
  const ModalForm form = modal_form(s);
  s.damping = {0.1, 0.02};
  s.modal_damping.W = s.M * form.Phi.middleCols(6, 4);
  const VectorXd zeta{{0.02, 0, 0.3, 0.001}}, lambda = form.lambda.segment(6, 4);
  s.modal_damping.d = 2 * zeta.array() * lambda.array().sqrt() - s.damping.alpha - s.damping.beta * lambda.array();
  const VectorXd c = modal_form(s).c;
  for (Index i = 0; i < 4; ++i) EXPECT_NEAR(c[6 + i], 2 * zeta[i] * std::sqrt(lambda[i]), 1e-12) << i;
  EXPECT_GE(c.minCoeff(), 0);  // of c[7] too: rounding below 0 would be no damping that a closed form accepts
  EXPECT_NEAR(c[10], 0.1 + 0.02 * form.lambda[10], 1e-12);
}

// A cube's modes come in threes: ratios given to any one of three leave the damping diagonal in another basis.
TEST(ModalForm, TurnsRepeatedModesUntilTheyDecouple) {
  System s = testing::box_system({.cells = {2, 2, 2}}).system;
  const ModalForm form = modal_form(s);
  Index first = 6;
  while (form.lambda[first + 2] - form.lambda[first] > 1e-10 * form.lambda[first]) ++first;
  const MatrixXd three = form.Phi.middleCols(first, 3);
  s.modal_damping.W = s.M * (three * Vector3d(0.6, 0, 0.8));
  s.modal_damping.d = VectorXd::Constant(1, 0.5);
  expect_diagonal(s);
  EXPECT_NEAR(modal_form(s).c.sum(), 0.5, 1e-12);
  // The same in modal coordinates, where the identity would not do.
  System reduced = testing::in_modal_coordinates(s, form);
  expect_diagonal(reduced);
}

TEST(ModalForm, SaysWhichDampingCouplesModes) {
  System s = small_box(true);
  const ModalForm form = modal_form(s);
  EXPECT_EQ(form.C.size(), 0);
  s.modal_damping.W = s.M * (form.Phi.col(2) + form.Phi.col(5));
  s.modal_damping.d = VectorXd::Constant(1, 0.5);
  const ModalForm coupled = modal_form(s);
  ASSERT_EQ(coupled.C.rows(), s.M.rows());
  EXPECT_NEAR(coupled.C(2, 5), 0.5, 1e-12);  // phi_2^T W d W^T phi_5, to the signs, which are those of `form`
  EXPECT_LT((VectorXd(coupled.C.diagonal()) - coupled.c).cwiseAbs().maxCoeff(), 1e-12 * coupled.c.maxCoeff());
  s.modal_damping.W = s.M * (form.Phi.col(2) + 1e-7 * form.Phi.col(5));
  EXPECT_GT(modal_form(s).C.size(), 0);
  s.modal_damping.W = s.M * (form.Phi.col(2) + 1e-9 * form.Phi.col(5));
  EXPECT_EQ(modal_form(s).C.size(), 0);
}

TEST(ModalForm, RefusesSizesThatDisagree) {
  const auto fails = [](auto change) {
    System s = with_all_damping(small_box(true));
    change(s);
    EXPECT_THROW(modal_form(s), std::invalid_argument);
  };
  fails([](System& s) { s.modal_damping.d.conservativeResize(2); });
  fails([](System& s) { s.modal_damping.W.conservativeResize(5, Eigen::NoChange); });
  fails([](System& s) { s.lumped_mass.resize(3, 3); });
  fails([](System& s) { s.K.resize(3, 3); });
  fails([](System& s) { s.v0.conservativeResize(5); });
}

}  // namespace
}  // namespace mb
