#include "mechanics/algebra/cholesky.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/algebra/sparse_test.h"
#include "mechanics/algebra/threads.h"

namespace mb {
namespace {

using testing::box_system;
using testing::diagonal;
using testing::shifted;
using ::testing::HasSubstr;

template <typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST(Cholesky, SolvesToWorkingPrecision) {
  const System body = box_system({.cells = {5, 4, 3}}).system;
  const SparseMatrix A = shifted(body, -0.1);
  const Cholesky factor(A);
  ASSERT_EQ(factor.size(), A.rows());
  EXPECT_GT(factor.nonzeros(), static_cast<double>(A.nonZeros()) / 2);
  const VectorXd b = uniform_noise(A.rows(), 7);
  const VectorXd x = factor.solve(b);
  // Backward error of a Cholesky solve: eps times a modest factor.
  EXPECT_LT((A * x - b).norm(), 1e-14 * A.norm() * x.norm());

  VectorXd in_place = b;
  factor.solve(in_place.data(), in_place.data());
  EXPECT_EQ(in_place, x);
  EXPECT_EQ(factor.solve(b), x) << "a solve must not depend on earlier ones";
}

// A row's unit is no matter: a light rigid body beside stiff modes is regular, a body that may move freely is not.
TEST(Cholesky, SingularIsWhatVanishesBesideItsOwnDiagonal) {
  const VectorXd wide{{1e14, 1, 1e-14}};
  EXPECT_NEAR(Cholesky(diagonal(wide)).solve(VectorXd(VectorXd::Ones(3)))(2), 1e14, 1);
  const System body = box_system({.cells = {3, 2, 2}}).system;
  EXPECT_THROW(Cholesky{shifted(body, 0)}, std::runtime_error);
  const SparseMatrix units = diagonal(VectorXd::LinSpaced(body.K.rows(), -6, 6).array().exp().matrix());
  EXPECT_THROW(Cholesky{SparseMatrix(units * body.K * units)}, std::runtime_error);
  EXPECT_NO_THROW(Cholesky{SparseMatrix(units * shifted(body, -1e-6) * units)});
}

TEST(Cholesky, ManyRightHandSidesAreSolvedAsOne) {
  const System body = box_system({.cells = {4, 3, 3}}).system;
  const Cholesky factor(shifted(body, -0.1));
  MatrixXd B(factor.size(), 70);  // more than two blocks of 32
  for (Index j = 0; j < B.cols(); ++j) B.col(j) = uniform_noise(B.rows(), static_cast<unsigned>(j));
  const MatrixXd X = factor.solve(B);
  for (Index j = 0; j < B.cols(); ++j) {
    const VectorXd x = factor.solve(VectorXd(B.col(j)));
    EXPECT_LT((X.col(j) - x).norm(), 1e-12 * x.norm()) << "column " << j;  // condition 1e3, BLAS sums in another order
  }
}

TEST(Cholesky, RefactorEqualsANewFactor) {
  const System body = box_system({.cells = {4, 3, 3}}).system;
  Cholesky factor(shifted(body, -0.1));
  const SparseMatrix A = shifted(body, -5);
  factor.refactor(A);
  const VectorXd b = uniform_noise(A.rows(), 3);
  EXPECT_EQ(factor.solve(b), Cholesky(A).solve(b));
  EXPECT_THROW(factor.refactor(diagonal(VectorXd::Ones(3))), std::invalid_argument);
}

TEST(Cholesky, ReadsOnlyTheLowerTriangle) {
  const System body = box_system({.cells = {2, 2, 2}}).system;
  const SparseMatrix A = shifted(body, -1);
  const SparseMatrix lower = A.triangularView<Eigen::Lower>();
  const VectorXd b = uniform_noise(A.rows(), 3);
  EXPECT_EQ(Cholesky(lower).solve(b), Cholesky(A).solve(b));
}

TEST(Cholesky, OneFactorServesSeveralThreads) {
  const System body = box_system({.cells = {6, 6, 6}}).system;
  const Cholesky factor(shifted(body, -1));
  const VectorXd b = uniform_noise(factor.size(), 1), c = uniform_noise(factor.size(), 2);
  const VectorXd x = factor.solve(b), y = factor.solve(c);
  bool same_x = true, same_y = true;
  {
    const std::jthread first([&] {
      for (int i = 0; i < 50; ++i) same_x &= factor.solve(b) == x;
    });
    const std::jthread second([&] {
      for (int i = 0; i < 50; ++i) same_y &= factor.solve(c) == y;
    });
  }
  EXPECT_TRUE(same_x);
  EXPECT_TRUE(same_y);
}

TEST(Cholesky, NamesTheColumnThatIsNotPositive) {
  VectorXd d = VectorXd::Ones(40);
  d(17) = -1;
  EXPECT_THAT(message_of([&] { Cholesky{diagonal(d)}; }), HasSubstr("not positive definite at column 17"));
}

TEST(Cholesky, RefusesTheStiffnessOfAFreeBody) {
  const System body = box_system({.cells = {5, 5, 5}, .E = 2.1e11, .rho = 7800}).system;
  EXPECT_THROW(Cholesky{body.K}, std::runtime_error);
}

TEST(Cholesky, RefusesBadInput) {
  EXPECT_THROW(Cholesky{SparseMatrix(0, 0)}, std::invalid_argument);
  EXPECT_THROW(Cholesky{SparseMatrix(3, 4)}, std::invalid_argument);
  EXPECT_THAT(message_of([] { Cholesky{diagonal(Vector3d(1, NAN, 1))}; }), HasSubstr("not finite"));
  SparseMatrix loose(2, 2);
  loose.insert(0, 0) = 1;
  loose.insert(1, 1) = 1;
  EXPECT_THROW(Cholesky{loose}, std::invalid_argument);
  const Cholesky identity(diagonal(VectorXd::Ones(3)));
  EXPECT_THROW(identity.solve(VectorXd(VectorXd::Ones(4))), std::invalid_argument);
  EXPECT_THROW(identity.solve(MatrixXd(MatrixXd::Ones(4, 2))), std::invalid_argument);
}

TEST(Threads, OfTheBlasAreDescribedAndSet) {
  set_blas_threads(1);
  EXPECT_THAT(blas_description(), ::testing::AnyOf(HasSubstr(", 1 thread"), HasSubstr("reference BLAS")));
  EXPECT_THROW(set_blas_threads(0), std::invalid_argument);
}

}  // namespace
}  // namespace mb
