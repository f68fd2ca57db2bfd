#include "harness/store/low_rank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {
namespace {

// Standing waves: three shapes, three frequencies.
MatrixXd motion(Index n_values, Index n_times) {
  MatrixXd values = MatrixXd::Zero(n_values, n_times);
  for (int k = 1; k <= 3; ++k) {
    const auto x = VectorXd::LinSpaced(n_values, 0, 1).array(), t = VectorXd::LinSpaced(n_times, 0, 1).array();
    values += std::pow(10.0, -3 * k) * (k * x).sin().matrix() * (7 * k * t).cos().matrix().transpose();
  }
  return values;
}

TEST(LowRank, RankIsThatOfTheMotionTallOrWide) {
  for (const auto& [m, n] : {std::pair<Index, Index>{300, 40}, {40, 300}, {50, 50}}) {
    const MatrixXd A = motion(m, n);
    const auto factors = low_rank(A, 1e-12);
    ASSERT_TRUE(factors);
    EXPECT_EQ(factors->left.cols(), 3);
    EXPECT_EQ(factors->right.rows(), 3);
    // Rounding of the decomposition: some ulp of the largest singular value.
    EXPECT_LT((factors->left * factors->right - A).norm(), 1e-14 * A.norm());
  }
}

TEST(LowRank, ErrorStaysBelowTheTolerance) {
  const MatrixXd A = motion(300, 40);
  const auto factors = low_rank(A, 1e-4);  // drops the waves that are 1e-6 of the largest, at most
  ASSERT_TRUE(factors);
  EXPECT_EQ(factors->left.cols(), 2);
  EXPECT_LT((factors->left * factors->right - A).norm(), 1e-4 * A.norm());
}

// 200 waves whose sizes fall to 1e-20 of the first: more columns than are taken up at once, a rank that only the
// tolerance decides. The best of that error, by Eckart & Young, is the singular value decomposition's.
TEST(LowRank, OfManyColumnsIsNearlyTheBest) {
  MatrixXd A = MatrixXd::Zero(500, 300);
  for (int k = 1; k <= 200; ++k) {
    const auto x = VectorXd::LinSpaced(500, 0, 3).array(), t = VectorXd::LinSpaced(300, 0, 3).array();
    A += std::pow(10.0, -0.1 * k) * (k * x).sin().matrix() * (1.3 * k * t).cos().matrix().transpose();
  }
  const VectorXd sigma = singular_values(A);
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto factors = low_rank(A, tolerance), of_times = low_rank(A.transpose(), tolerance);
    ASSERT_TRUE(factors && of_times);
    const Index best = (sigma.array() > tolerance * sigma[0]).count();
    for (const auto& found : {*factors, *of_times}) {
      EXPECT_GE(found.left.cols(), best);
      EXPECT_LE(found.left.cols(), best + 2);  // a quarter of the error is kept for the basis
    }
    const double rounding = 1e-14;
    EXPECT_LT(spectral_norm(factors->left * factors->right - A), (tolerance + rounding) * sigma[0]);
    EXPECT_LT(spectral_norm(of_times->left * of_times->right - A.transpose()), (tolerance + rounding) * sigma[0]);
  }
}

// Each wave a third of the one before: a block holds sizes from its largest to the tolerance, and what is left of the
// blocks before it in the small ones is rounding of the large.
TEST(LowRank, OfAMotionThatFallsSteeplyIsNearlyTheBest) {
  const auto shapes = [](Index n) {
    MatrixXd all(n, 60);
    for (Index k = 0; k < 60; ++k)
      all.col(k) = (static_cast<double>(k + 1) * VectorXd::LinSpaced(n, 0, 3).array()).sin();
    return all;
  };
  const VectorXd fall = VectorXd::LinSpaced(60, 0, -29.5).unaryExpr([](double e) { return std::pow(10.0, e); });
  const MatrixXd A = shapes(600) * fall.asDiagonal() * shapes(320).transpose();
  const VectorXd sigma = singular_values(A);
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    const auto factors = low_rank(A, tolerance);
    ASSERT_TRUE(factors) << tolerance;
    EXPECT_LE(factors->left.cols(), (sigma.array() > tolerance * sigma[0]).count() + 2);
    EXPECT_LT(spectral_norm(factors->left * factors->right - A), (tolerance + 1e-14) * sigma[0]);
  }
}

TEST(LowRank, OfEntriesWhoseSquaresUnderflowIsNone) {
  EXPECT_FALSE(low_rank(VectorXd::Constant(30, 1e-81) * VectorXd::Constant(20, 1e-81).transpose(), 1e-12));
}

TEST(LowRank, ZeroHasRankOneAndStaysZero) {
  const auto factors = low_rank(MatrixXd::Zero(30, 20), 1e-12);
  ASSERT_TRUE(factors);
  EXPECT_EQ(factors->left * factors->right, MatrixXd::Zero(30, 20));
}

TEST(LowRank, NothingWhereFactorsDoNotPayOrDoNotExist) {
  EXPECT_FALSE(low_rank(MatrixXd::Random(30, 20), 1e-12));
  EXPECT_FALSE(low_rank(MatrixXd(0, 5), 1e-12));
  MatrixXd A = motion(300, 40);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    A(17, 3) = bad;
    EXPECT_FALSE(low_rank(A, 1e-12));
  }
  EXPECT_FALSE(low_rank(1e200 * motion(300, 40), 1e-12));  // squares overflow: kept as they are
}

}  // namespace
}  // namespace mb
