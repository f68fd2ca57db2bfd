#include "harness/analysis/two_solvers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mb {
namespace {

// Two rigid modes, then 1 of eigenvalue 4, 2 of 9, 1 of 9.1, 1 of 16, none of unit mass.
const VectorXd masses{{2, 3, 5, 7, 11, 13, 17}}, omega{{0, 0, 2, 3, 3, std::sqrt(9.1), 4}};

struct Found {
  SparseMatrix M{masses.asDiagonal()};
  MatrixXd Phi = masses.cwiseSqrt().cwiseInverse().asDiagonal().toDenseMatrix();
  VectorXd lambda = omega.cwiseAbs2();
  Modes modes{2, omega, Phi, {}, 16};
  std::vector<TwiceFound> compared() const { return twice_found(M, modes, lambda, Phi); }
};

TEST(TwoSolvers, AgreeWhereTheySpanTheSame) {
  Found found;  // another basis of the pair, other signs
  found.modes.Phi.col(3) = std::cos(0.3) * found.Phi.col(3) + std::sin(0.3) * found.Phi.col(4);
  found.modes.Phi.col(4) = std::sin(0.3) * found.Phi.col(3) - std::cos(0.3) * found.Phi.col(4);
  found.modes.Phi.col(6) *= -1;
  const std::vector<TwiceFound> all = found.compared();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[1].multiplet.first, 3);
  EXPECT_EQ(all[1].multiplet.n, 2);
  EXPECT_DOUBLE_EQ(all[1].omega, 3);
  EXPECT_NEAR(all[1].gap, 0.1 / 9, 1e-15);
  for (const TwiceFound& each : all) {
    EXPECT_EQ(each.difference, 0);
    EXPECT_LT(each.distance, 1e-15);
  }
}

TEST(TwoSolvers, ShowAVectorTurnedByAKnownAngle) {
  Found found;
  found.modes.Phi.col(2) = std::cos(1e-7) * found.Phi.col(2) + std::sin(1e-7) * found.Phi.col(6);
  EXPECT_NEAR(found.compared()[0].distance, 1e-7, 1e-15);
}

TEST(TwoSolvers, ShowVectorsSwapped) {
  Found found;  // between neighbours whose frequencies are all but the same
  found.modes.Phi.col(4).swap(found.modes.Phi.col(5));
  const std::vector<TwiceFound> all = found.compared();
  EXPECT_LT(all[0].distance, 1e-15);
  EXPECT_NEAR(all[1].distance, 1, 1e-15);
  EXPECT_NEAR(all[2].distance, 1, 1e-15);
}

TEST(TwoSolvers, ShowAVectorThatStandsTwice) {
  Found found;
  found.modes.Phi.col(4) = found.modes.Phi.col(3);
  EXPECT_NEAR(found.compared()[1].distance, 1, 1e-15);
}

TEST(TwoSolvers, ShowAModeThatWasMissed) {
  Found found;  // the second of the pair: all above move down
  found.modes.omega = omega({0, 1, 2, 3, 5, 6});
  found.modes.Phi = found.Phi(Eigen::all, std::vector<Index>{0, 1, 2, 3, 5, 6}).eval();
  const std::vector<TwiceFound> all = found.compared();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_NEAR(all[2].distance, 1, 1e-15);
  EXPECT_NEAR(all[3].difference, 4 / std::sqrt(9.1) - 1, 1e-15);
}

TEST(TwoSolvers, RefuseBadInput) {
  Found found;
  found.modes.Phi(3, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(found.compared(), std::invalid_argument);
  found = {};
  found.modes.omega[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(found.compared(), std::invalid_argument);
  found = {};
  found.lambda = found.lambda.head(6).eval();  // fewer by the other solver
  EXPECT_THROW(found.compared(), std::invalid_argument);
  found = {};
  found.modes.Phi = found.modes.Phi.leftCols(5).eval();
  EXPECT_THROW(found.compared(), std::invalid_argument);
}

}  // namespace
}  // namespace mb
