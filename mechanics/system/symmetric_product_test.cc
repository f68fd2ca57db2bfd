#include "mechanics/system/symmetric_product.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

SparseMatrix kronecker(const SparseMatrix& m) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index b = 0; b < m.cols(); ++b)
    for (SparseMatrix::InnerIterator it(m, b); it; ++it)
      for (Index i = 0; i < 3; ++i) entries.emplace_back(3 * it.row() + i, 3 * b + i, it.value());
  SparseMatrix M(3 * m.rows(), 3 * m.cols());
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

void expect_product(const SparseMatrix& M) {
  const VectorXd x = VectorXd::LinSpaced(M.rows(), -1, 2), expected = M * x;
  VectorXd y = VectorXd::Constant(M.rows(), 7);  // what was there must not matter
  const SymmetricProduct product(M);
  product(x, y);
  EXPECT_LE((y - expected).lpNorm<Eigen::Infinity>(), 1e-14 * expected.lpNorm<Eigen::Infinity>());
}

TEST(SymmetricProduct, KnowsDiagonalMatrices) {
  SparseMatrix A(3, 3);
  A.insert(0, 0) = 2;
  EXPECT_TRUE(is_diagonal(A));
  A.insert(1, 0) = 0;
  EXPECT_TRUE(is_diagonal(A));
  A.coeffRef(1, 0) = 1e-300;
  EXPECT_FALSE(is_diagonal(A));
}

TEST(SymmetricProduct, EqualsTheMatrixWhateverItsForm) {
  SparseMatrix m(4, 4);
  const std::vector<Eigen::Triplet<double>> entries = {{0, 0, 4}, {1, 1, 3}, {2, 2, 5},  {3, 3, 2},
                                                       {0, 2, 1}, {2, 0, 1}, {1, 3, -1}, {3, 1, -1}};
  m.setFromTriplets(entries.begin(), entries.end());
  SparseMatrix M = kronecker(m);
  expect_product(M);
  M.coeffRef(4, 4) += 1;  // one component heavier: no longer one mass a node
  expect_product(M);
  M.coeffRef(0, 1) = M.coeffRef(1, 0) = 0.5;  // components coupled
  M.makeCompressed();
  expect_product(M);
  expect_product(m);  // four degrees of freedom: no nodes of three
  expect_product(kronecker(SparseMatrix(m.topLeftCorner(2, 2))));
  m.prune([](Index i, Index j, double) { return i == j; });
  expect_product(m);
  expect_product(kronecker(m));
  m.coeffRef(0, 3) = m.coeffRef(3, 0) = 0;  // zeros that are stored
  m.makeCompressed();
  expect_product(m);
  expect_product(SparseMatrix(0, 0));
}

// Of nodes that all three components couple, as in a solid, in rows that come in any order and with a few that are not
// stored.
TEST(SymmetricProduct, EqualsAMatrixOfBlocks) {
  constexpr Index n = 7;
  MatrixXd dense = MatrixXd::Zero(3 * n, 3 * n);
  const auto entry = [](Index i, Index j) {
    return std::sin(static_cast<double>(1 + 3 * std::min(i, j) + 7 * std::max(i, j)));
  };
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b < n; ++b)
      if ((a + b) % 3 != 1 || a == b)
        for (Index i = 3 * a; i < 3 * a + 3; ++i)
          for (Index j = 3 * b; j < 3 * b + 3; ++j) dense(i, j) = entry(i, j);
  expect_product(dense.sparseView());
  dense(0, 4) = dense(4, 0) = dense(7, 7) = 0;
  expect_product(dense.sparseView());
  expect_product(dense.topLeftCorner(3 * n - 1, 3 * n - 1).sparseView());  // a node of two components
}

}  // namespace
}  // namespace mb
