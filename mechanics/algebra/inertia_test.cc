#include "mechanics/algebra/inertia.h"

#include <gtest/gtest.h>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/sparse_test.h"

namespace mb {
namespace {

using testing::box_system;
using testing::diagonal;
using testing::shifted;

TEST(InertiaOfAMatrix, CountsEigenvaluesBelowAShift) {
  const System body = box_system({.cells = {3, 3, 2}, .size = {1, 0.9, 0.7}}).system;
  const VectorXd lambda = generalized_eigenvalues(MatrixXd(body.K), MatrixXd(body.M)).value();
  for (const Index below : {6, 7, 20, 60, 107}) {
    const Inertia count = inertia(shifted(body, 0.5 * (lambda(below - 1) + lambda(below))));
    EXPECT_EQ(count.negative, below);
    EXPECT_EQ(count.positive, lambda.size() - below);
    EXPECT_EQ(count.zero, 0);
    EXPECT_LT(count.residual, 1e-10);
  }
}

TEST(InertiaOfAMatrix, IsNotBelievedWhereAPivotVanishes) {
  SparseMatrix A(2, 2);  // eigenvalues -1 and 1, but no L D L^T with diagonal D
  A.insert(1, 0) = 1;
  A.insert(0, 1) = 1;
  A.makeCompressed();
  EXPECT_GT(inertia(A).residual, 1e-8);
  EXPECT_GT(inertia(diagonal(Vector3d(1, 0, -2))).residual, 1e-8);
  EXPECT_THROW(inertia(diagonal(Vector3d(1, INFINITY, 1))), std::invalid_argument);
  EXPECT_THROW(inertia(SparseMatrix(0, 0)), std::invalid_argument);
}

// The lower triangle is the matrix, and pivots are taken on the diagonal where another entry of the row is 1e9 times as
// large: eigenvalues are -1e3, all but exactly, and 1e3.
TEST(InertiaOfAMatrix, IsOfTheLowerTriangleAndOfSmallPivots) {
  SparseMatrix A(2, 2);
  A.insert(0, 0) = 1e-6;
  A.insert(1, 0) = 1e3;
  A.makeCompressed();
  const Inertia count = inertia(A);
  EXPECT_EQ(count.negative, 1);
  EXPECT_EQ(count.positive, 1);
}

// D of every scale: shifts next to an eigenvalue, where a pivot all but vanishes.
TEST(InertiaOfAMatrix, ChangesWithinRoundingOfAnEigenvalue) {
  const System body = box_system({.cells = {3, 3, 2}, .size = {1, 0.9, 0.7}}).system;
  const VectorXd lambda = generalized_eigenvalues(MatrixXd(body.K), MatrixXd(body.M)).value();
  const double rounding = 1e-13 * lambda(lambda.size() - 1);
  for (const Index i : {6, 7, 20}) {
    EXPECT_EQ(inertia(shifted(body, lambda(i) - rounding)).negative, i);
    EXPECT_EQ(inertia(shifted(body, lambda(i) + rounding)).negative, i + 1);
  }
}

}  // namespace
}  // namespace mb
