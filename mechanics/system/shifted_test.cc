#include "mechanics/system/shifted.h"

#include <gtest/gtest.h>

#include "mechanics/system/small_test_systems.h"

namespace mb {
namespace {

using testing::small_box;
using testing::with_all_damping;

MatrixXd dense_damping(const System& s) {
  const MatrixXd M = s.M, MR = s.M * s.R;
  const auto& [W, d] = s.modal_damping;
  MatrixXd C = s.damping.alpha * (M - MR * MR.transpose()) + s.damping.beta * MatrixXd(s.K);
  if (d.size() > 0) C += W * d.asDiagonal() * W.transpose();
  return C;
}

std::vector<System> systems() {
  System coupled = small_box(true);  // W is no modes at all
  coupled.modal_damping = {MatrixXd(uniform_noise(24, 1)), VectorXd::Ones(1)};
  System modal_only = with_all_damping(small_box(false));
  modal_only.damping = {};
  modal_only.modal_damping.d = VectorXd{{0.3, 0, 2}};
  System free = with_all_damping(small_box(false));
  System none = small_box(false);
  System rayleigh = none;
  rayleigh.damping = {0.7, 0.03};
  return {none,
          rayleigh,
          free,
          with_all_damping(small_box(true)),
          modal_only,
          coupled,
          testing::in_modal_coordinates(free, modal_form(free))};
}

TEST(Damping, IsWhatItsFormulaSays) {
  for (const System& s : systems()) {
    const VectorXd v = uniform_noise(s.M.rows(), 7), expected = dense_damping(s) * v;
    EXPECT_LE((apply_damping(s, v) - expected).norm(), 1e-14 * expected.norm());
    EXPECT_EQ(is_damped(s), expected.norm() > 0);
  }
}

TEST(Damping, OfRigidMotionIsNone) {
  for (const System& s : systems()) {
    if (s.R.cols() == 0) continue;
    const double scale = dense_damping(s).norm() * s.R.norm();
    for (Index i = 0; i < s.R.cols(); ++i) EXPECT_LE(apply_damping(s, s.R.col(i)).norm(), 1e-13 * scale);
  }
}

TEST(Damping, OfLowRankIsTheRest) {
  for (const System& s : systems()) {
    const VectorXd v = uniform_noise(s.M.rows(), 8);
    VectorXd y = s.damping.alpha * (s.M * v) + s.damping.beta * (s.K * v);
    LowRankDamping(s.damping.alpha, s.M * s.R, s.modal_damping).add_product(1, v, y);
    EXPECT_LE((y - apply_damping(s, v)).norm(), 1e-14 * (s.M * v).norm());
  }
  const System reduced = systems().back();
  const LowRankDamping low_rank(reduced.damping.alpha, reduced.M * reduced.R, reduced.modal_damping);
  EXPECT_EQ(low_rank.rank(), 0);  // columns of one entry: kept as a diagonal
  EXPECT_EQ(low_rank.diagonal().size(), 36);
  EXPECT_EQ(LowRankDamping(0, reduced.R, {}).diagonal().size(), 0);  // no damping costs nothing
}

// A x = b with C as apply_damping has it, before and after gamma changes.
TEST(Shifted, InvertsItsOperator) {
  for (const System& s : systems()) {
    Shifted A(s, 0.3);
    const VectorXd b = uniform_noise(s.M.rows(), 9);
    VectorXd x(b.size());
    for (const double gamma : {0.3, 1e-3, 20.0, 0.3}) {
      if (gamma != A.gamma()) A.set_gamma(gamma);
      A.solve(b, x);
      const VectorXd residual = s.M * x + gamma * apply_damping(s, x) + gamma * gamma * (s.K * x) - b;
      EXPECT_LE(residual.norm(), 1e-12 * b.norm()) << gamma;  // condition up to 1e3
    }
    const Shifted without_stiffness(s, 0.3, 0);
    x = b;
    without_stiffness.solve(x, x);  // in place
    EXPECT_LE((s.M * x + 0.3 * apply_damping(s, x) - b).norm(), 1e-13 * b.norm());
  }
}

TEST(Shifted, IsDiagonalInModalCoordinates) {
  EXPECT_TRUE(Shifted(systems().back(), 0.1).is_diagonal());
  EXPECT_FALSE(Shifted(systems().front(), 0.1).is_diagonal());
}

TEST(Shifted, RefusesBadInput) {
  const System s = small_box(true);
  for (const double gamma : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(Shifted(s, gamma), std::invalid_argument) << gamma;
  System heavy = s;
  heavy.M *= -1;
  EXPECT_THROW(Shifted(heavy, 1e-3), std::runtime_error);
}

TEST(SpdFactor, SolvesDiagonalAndOtherMatrices) {
  const System s = testing::lumped(small_box(true));
  for (const SparseMatrix& A : {s.M, s.lumped_mass}) {
    SpdFactor factor(A);
    const VectorXd b = uniform_noise(A.rows(), 2);
    EXPECT_LE((A * factor.solve(b) - b).norm(), 1e-13 * b.norm());
    EXPECT_LE((factor.solve(MatrixXd(b)) - factor.solve(b)).norm(), 1e-13 * b.norm());
    factor.refactor(2 * A);
    VectorXd x = b;
    factor.solve(x.data(), x.data());
    EXPECT_LE((2 * A * x - b).norm(), 1e-13 * b.norm());
    EXPECT_THROW(factor.solve(VectorXd(VectorXd::Ones(3))), std::invalid_argument);
  }
  EXPECT_EQ(SpdFactor(SparseMatrix(0, 0)).solve(VectorXd()).size(), 0);
}

TEST(SpdFactor, RefusesWhatIsNotPositiveDefinite) {
  SparseMatrix A(2, 2);
  A.insert(0, 0) = 1;
  for (const double last : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    A.coeffRef(1, 1) = last;
    EXPECT_THROW(SpdFactor{A}, std::runtime_error) << last;
  }
  EXPECT_THROW(SpdFactor{SparseMatrix(2, 3)}, std::invalid_argument);
}

}  // namespace
}  // namespace mb
