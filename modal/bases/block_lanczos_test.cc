#include "modal/bases/block_lanczos.h"

#include <gtest/gtest.h>

#include "mechanics/algebra/noise.h"
#include "modal/bases/arpack.h"

namespace mb {
namespace {

MatrixXd noise(Index rows, Index columns, unsigned seed) {
  return uniform_noise(rows * columns, seed).reshaped(rows, columns);
}

// T = M^-1 A with diagonal M and A, so that the eigenvectors are unit vectors over the root of M.
struct Diagonal {
  VectorXd theta, mass;
  explicit Diagonal(VectorXd values) : theta(std::move(values)), mass(uniform_noise(theta.size(), 9).array() + 2) {}
  BlockOperator T() const {
    return [this](const MatrixXd& MX) -> MatrixXd { return theta.cwiseQuotient(mass).asDiagonal() * MX; };
  }
  BlockProduct M() const {
    return [this](const MatrixXd& X) -> MatrixXd { return mass.asDiagonal() * X; };
  }
  MatrixXd eigenvector(Index i) const { return VectorXd::Unit(mass.size(), i) / std::sqrt(mass(i)); }
  MatrixXd gram(const MatrixXd& X) const { return X.transpose() * mass.asDiagonal() * X; }
};
auto until(Index n_wanted) {
  return [n_wanted](const VectorXd& theta) { return n_wanted - theta.size(); };
}
MatrixXd nothing(Index n) { return MatrixXd(n, 0); }

// A spectrum like that of a shift-inverted body: 1/(1 + i), its top taken three times each.
VectorXd triplets(Index n) {
  return VectorXd::NullaryExpr(n, [](Index i) { return 1. / (1 + static_cast<double>(i / 3)); });
}

TEST(BlockLanczos, FindsEveryCopy) {
  const Diagonal problem(triplets(900));
  for (const Index block : {1, 2, 3, 5, 8}) {
    const LargestPairs top =
        largest_pairs(problem.T(), problem.M(), nothing(900), noise(900, block, 1), until(12), {200, 1e-10});
    ASSERT_GE(top.theta.size(), 12);
    // Copies beyond the width of the block come through rounding alone and may be late: at most one a column is sure.
    if (block < 3) continue;
    EXPECT_LT((top.theta - problem.theta.head(top.theta.size())).cwiseAbs().maxCoeff(), 1e-12) << block;
    const MatrixXd gram = problem.gram(top.vectors);
    EXPECT_LT((gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(BlockLanczos, RestartsWhereVectorsAreFew) {
  const Diagonal problem(triplets(900));
  const auto run = [&](Index n_vectors) {
    return largest_pairs(problem.T(), problem.M(), nothing(900), noise(900, 4, 1), until(9), {n_vectors, 1e-10});
  };
  const LargestPairs ample = run(300), tight = run(32);
  EXPECT_LT((tight.theta.head(9) - ample.theta.head(9)).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_GT(tight.n_columns, ample.n_columns);
  EXPECT_LT(tight.n_columns, 4 * ample.n_columns);
}

TEST(BlockLanczos, StaysAwayFromWhatIsKnown) {
  const Diagonal problem(triplets(900));
  MatrixXd known(900, 4);
  for (Index i = 0; i < 4; ++i) known.col(i) = problem.eigenvector(i);
  const LargestPairs top = largest_pairs(problem.T(), problem.M(), known, noise(900, 4, 1), until(6), {120, 1e-10});
  EXPECT_LT((top.theta.head(6) - problem.theta.segment(4, 6)).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((known.transpose() * problem.mass.asDiagonal() * top.vectors).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(BlockLanczos, AgreesWithArpack) {
  const Diagonal problem(uniform_noise(500, 3).array() + 1.5);
  const Operator apply = [&](const VectorXd& x, const VectorXd&) -> VectorXd { return problem.theta.cwiseProduct(x); };
  const InnerProduct inner = [&](const VectorXd& x) -> VectorXd { return problem.mass.cwiseProduct(x); };
  const RitzPairs expected = largest_ritz(apply, inner, 6, 40, 0, uniform_noise(500, 1));
  const LargestPairs top =
      largest_pairs(problem.T(), problem.M(), nothing(500), noise(500, 4, 1), until(6), {160, 1e-12});
  EXPECT_LT((top.theta.head(6) - expected.theta).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(BlockLanczos, EndsWhereTheSpaceDoes) {
  // Ten different eigenvalues: a single vector sees ten, and the space is exhausted before 40 are found.
  const Diagonal problem(VectorXd::NullaryExpr(90, [](Index i) { return 1. + static_cast<double>(i % 10); }));
  const LargestPairs one =
      largest_pairs(problem.T(), problem.M(), nothing(90), noise(90, 1, 1), until(40), {80, 1e-10});
  ASSERT_EQ(one.theta.size(), 10);
  EXPECT_LT((one.theta - VectorXd::LinSpaced(10, 10, 1)).cwiseAbs().maxCoeff(), 1e-12);
  const LargestPairs all =
      largest_pairs(problem.T(), problem.M(), nothing(90), noise(90, 15, 1), until(90), {90, 1e-10});
  ASSERT_EQ(all.theta.size(), 90);
  VectorXd expected = problem.theta;
  std::sort(expected.begin(), expected.end(), std::greater());
  EXPECT_LT((all.theta - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BlockLanczos, BearsAStartThatIsNearlyDependent) {
  const Diagonal problem(triplets(900));
  MatrixXd start = noise(900, 4, 1);
  start.col(2) = start.col(1) + 1e-9 * start.col(2);
  start.col(3) = start.col(0);
  const LargestPairs top = largest_pairs(problem.T(), problem.M(), nothing(900), start, until(6), {200, 1e-10});
  EXPECT_LT((top.theta.head(6) - problem.theta.head(6)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BlockLanczos, RepeatsItself) {
  const Diagonal problem(triplets(300));
  const auto run = [&] {
    return largest_pairs(problem.T(), problem.M(), nothing(300), noise(300, 4, 1), until(6), {120, 1e-10}).vectors;
  };
  EXPECT_EQ(run(), run());
}

TEST(BlockLanczos, RefusesBadInput) {
  const Diagonal problem(triplets(300));
  const auto run = [&](const MatrixXd& known, const MatrixXd& start, const Krylov& krylov) {
    return largest_pairs(problem.T(), problem.M(), known, start, until(3), krylov);
  };
  const MatrixXd start = noise(300, 4, 1);
  EXPECT_THROW(run(nothing(300), start, {8, 1e-10}), std::invalid_argument);
  EXPECT_THROW(run(nothing(300), start, {301, 1e-10}), std::invalid_argument);
  EXPECT_THROW(run(nothing(300), start, {60, 0}), std::invalid_argument);
  EXPECT_THROW(run(nothing(300), MatrixXd(300, 0), {60, 1e-10}), std::invalid_argument);
  EXPECT_THROW(run(nothing(300), NAN * start, {60, 1e-10}), std::invalid_argument);
  EXPECT_THROW(run(nothing(300), 0 * start, {60, 1e-10}), std::invalid_argument);
  EXPECT_THROW(run(MatrixXd(299, 1), start, {60, 1e-10}), std::invalid_argument);
  const BlockOperator broken = [](const MatrixXd& MX) -> MatrixXd { return NAN * MX; };
  EXPECT_THROW(largest_pairs(broken, problem.M(), nothing(300), start, until(3), {60, 1e-10}), std::runtime_error);
  // A spectrum crowded beyond all resolution at its top, and three vectors to find it with.
  const Diagonal crowded(1 - VectorXd::LinSpaced(3000, 0, 1).array().square() * 1e-9);
  EXPECT_THROW(largest_pairs(crowded.T(), crowded.M(), nothing(3000), noise(3000, 1, 1), until(3), {5, 1e-13}),
               std::runtime_error);
}

}  // namespace
}  // namespace mb
