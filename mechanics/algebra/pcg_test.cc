#include "mechanics/algebra/pcg.h"

#include <gtest/gtest.h>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/algebra/noise.h"

namespace mb {
namespace {

const LinearMap identity = [](const VectorXd& r) { return r; };

SparseMatrix diagonal(const VectorXd& d) { return SparseMatrix(d.asDiagonal()); }

TEST(ConjugateGradients, EndAfterAsManyStepsAsThereAreEigenvalues) {
  const VectorXd d = (VectorXd(9) << 1, 1, 1, 2, 2, 2, 5, 5, 5).finished();
  const VectorXd b = uniform_noise(9, 1);
  const PcgSolution solution = pcg(diagonal(d), b, identity, 1e-13, 20);
  EXPECT_EQ(solution.iterations, 3);
  EXPECT_LT((d.asDiagonal() * solution.x - b).norm(), 1e-13 * b.norm());
}

TEST(ConjugateGradients, EndAtOnceWithTheInverse) {
  const VectorXd d = VectorXd::LinSpaced(50, 1, 1e6);
  const LinearMap inverse = [&](const VectorXd& r) -> VectorXd { return r.cwiseQuotient(d); };
  EXPECT_LE(pcg(diagonal(d), uniform_noise(50, 1), inverse, 1e-12, 5).iterations, 2);
}

TEST(ConjugateGradients, AgreeWithElimination) {
  const auto clamped = [](const Vector3d& x, int) { return x[2] == 0; };
  const System body = testing::box_system({.cells = {3, 3, 4}, .fixed = clamped}).system;
  const VectorXd b = uniform_noise(body.K.rows(), 1);
  const VectorXd inverse_diagonal = body.K.diagonal().cwiseInverse();
  const LinearMap jacobi = [&](const VectorXd& r) -> VectorXd { return inverse_diagonal.cwiseProduct(r); };
  const PcgSolution solution = pcg(body.K, b, jacobi, 1e-12, 1000);
  const VectorXd x = MatrixXd(body.K).llt().solve(b);
  EXPECT_LT((solution.x - x).norm(), 1e-9 * x.norm());  // tolerance times the condition number, about 1e3
  EXPECT_LT(solution.residual, 1e-12);
}

TEST(ConjugateGradients, SayWhyTheyFail) {
  const SparseMatrix A = diagonal(VectorXd::LinSpaced(50, 1, 1e6));
  const VectorXd b = VectorXd::Ones(50);
  EXPECT_THROW(pcg(A, b, identity, 1e-12, 3), std::runtime_error);
  EXPECT_THROW(pcg(SparseMatrix(-A), b, identity, 1e-12, 3), std::runtime_error);
  EXPECT_THROW(pcg(A, VectorXd::Ones(49), identity, 1e-12, 3), std::invalid_argument);
  EXPECT_THROW(pcg(A, NAN * b, identity, 1e-12, 3), std::invalid_argument);
  EXPECT_THROW(pcg(A, b, identity, 0, 3), std::invalid_argument);
}

TEST(ConjugateGradients, RefuseALoadOutsideTheRange) {
  const SparseMatrix A = diagonal(Vector3d(1, 2, 0));
  EXPECT_THROW(pcg(A, Vector3d(1, 1, 1), identity, 1e-10, 50), std::runtime_error);
}

TEST(ConjugateGradients, AnswerZeroWithZero) {
  EXPECT_EQ(pcg(diagonal(Vector3d(1, 2, 3)), Vector3d::Zero(), identity, 1e-10, 5).x, Vector3d::Zero());
}

}  // namespace
}  // namespace mb
