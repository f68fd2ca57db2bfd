#include "modal/bases/subspaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mb {
namespace {

// Unit vectors over sqrt(m): M-orthonormal where M = diag(m).
const VectorXd masses{{2, 3, 5, 7, 11}};
const SparseMatrix M(masses.asDiagonal());
MatrixXd basis() { return masses.cwiseSqrt().cwiseInverse().asDiagonal().toDenseMatrix(); }

TEST(Clusters, EndWhereTheGapIsWider) {
  const VectorXd lambda{{0, 0, 1, 1 + 1e-7, 2, 2.1, 2.2, 5}};
  const std::vector<Cluster> found = clusters(lambda, 2, 0.05);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].first, 2);
  EXPECT_EQ(found[0].n, 2);
  EXPECT_EQ(found[1].first, 4);
  EXPECT_EQ(found[1].n, 3);  // neighbour by neighbour, although its ends are further apart
  EXPECT_EQ(found[2].n, 1);
  EXPECT_DOUBLE_EQ(gap_around(lambda, 2, found[0]), 2 / (1 + 1e-7) - 1);  // rigid modes are no neighbours
  EXPECT_DOUBLE_EQ(gap_around(lambda, 2, found[1]), 1 - (1 + 1e-7) / 2);
  EXPECT_DOUBLE_EQ(gap_around(lambda, 2, found[2]), 1 - 2.2 / 5);
  EXPECT_TRUE(std::isinf(gap_around(VectorXd{{3}}, 0, {0, 1})));
  EXPECT_TRUE(clusters(lambda, 8, 0.05).empty());
}

TEST(Clusters, RefuseWhatIsNoSpectrum) {
  EXPECT_THROW(clusters(VectorXd{{2, 1}}, 0, 0.1), std::invalid_argument);
  EXPECT_THROW(clusters(VectorXd{{1, NAN}}, 0, 0.1), std::invalid_argument);
}

TEST(SubspaceDistance, IsTheSineOfTheLargestAngle) {
  const MatrixXd e = basis();
  for (const double angle : {1e-9, 1e-3, 0.4, pi / 2}) {
    MatrixXd turned = e.leftCols(2);
    turned.col(0) = std::cos(angle) * e.col(0) + std::sin(angle) * e.col(3);
    EXPECT_NEAR(subspace_distance(M, e.leftCols(2), turned), std::sin(angle), 1e-15);
  }
}

TEST(SubspaceDistance, DoesNotSeeTheBasis) {
  const MatrixXd e = basis();
  MatrixXd turned(5, 2);
  turned.col(0) = std::cos(0.7) * e.col(0) + std::sin(0.7) * e.col(1);
  turned.col(1) = std::sin(0.7) * e.col(0) - std::cos(0.7) * e.col(1);
  EXPECT_LT(subspace_distance(M, e.leftCols(2), turned), 1e-15);
}

TEST(SubspaceDistance, SeesWhatStandsTwiceFromEitherSide) {
  const MatrixXd e = basis();
  MatrixXd twice = e.leftCols(2);
  twice.col(1) = twice.col(0);
  EXPECT_NEAR(subspace_distance(M, twice, e.leftCols(2)), 1, 1e-15);
  EXPECT_NEAR(subspace_distance(M, e.leftCols(2), twice), 1, 1e-15);
}

TEST(SubspaceDistance, RefusesBadInput) {
  const MatrixXd e = basis();
  EXPECT_THROW(subspace_distance(M, e.leftCols(2), e.leftCols(3)), std::invalid_argument);
  EXPECT_THROW(subspace_distance(M, e.topRows(3), e.topRows(3)), std::invalid_argument);
  EXPECT_THROW(subspace_distance(M, MatrixXd(5, 0), MatrixXd(5, 0)), std::invalid_argument);
  MatrixXd broken = e;
  broken(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(subspace_distance(M, e, broken), std::invalid_argument);
}

}  // namespace
}  // namespace mb
