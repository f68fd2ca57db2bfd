#include "mechanics/algebra/complex_lu.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

namespace mb {
namespace {

using Eigen::MatrixXcd;

// A tridiagonal matrix with one long row, unsymmetric, not diagonally dominant.
SparseMatrixXcd random_matrix(Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto entry = [&] { return Complex(unit(random), unit(random)); };
  SparseMatrixXcd A(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      if (std::abs(i - j) <= 1 || i == n / 2) A.insert(i, j) = entry();
  A.makeCompressed();
  return A;
}

VectorXcd random_vector(Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  return VectorXcd::NullaryExpr(n, [&] { return Complex(unit(random), unit(random)); });
}

TEST(ComplexLuTest, MatchesDenseSolve) {
  for (const Index n : {1, 2, 7, 60}) {
    const SparseMatrixXcd A = random_matrix(n, 1);
    const VectorXcd b = random_vector(n, 2), x = ComplexLu(A).solve(b);
    const VectorXcd dense = MatrixXcd(A).fullPivLu().solve(b);
    EXPECT_LT((x - dense).norm(), 1e-11 * dense.norm()) << n;  // random matrices: condition below 1e4
    EXPECT_LT((A * x - b).norm(), 1e-13 * (A.norm() * x.norm() + b.norm())) << n;
  }
}

TEST(ComplexLuTest, RefactorsAnotherMatrixOfThePattern) {
  const SparseMatrixXcd A = random_matrix(40, 3), B = random_matrix(40, 4);
  const VectorXcd b = random_vector(40, 5);
  ComplexLu lu(A);
  const VectorXcd first = lu.solve(b);
  lu.refactor(B);
  EXPECT_LT((B * lu.solve(b) - b).norm(), 1e-11 * b.norm());
  lu.refactor(A);
  EXPECT_EQ(lu.solve(b), first);  // the same ordering, the same arithmetic
  const ComplexLu moved = std::move(lu);
  EXPECT_EQ(moved.solve(b), first);
}

TEST(ComplexLuTest, SingularIsRefused) {
  SparseMatrixXcd A = random_matrix(10, 6);
  ComplexLu lu(A);
  for (SparseMatrixXcd::InnerIterator entry(A, 4); entry; ++entry) entry.valueRef() = 0;
  EXPECT_THROW(ComplexLu{A}, std::runtime_error);
  EXPECT_THROW(lu.refactor(A), std::runtime_error);
  EXPECT_THROW(lu.solve(random_vector(10, 7)), std::runtime_error);  // the factor is lost
  lu.refactor(random_matrix(10, 6));                                 // and made anew
  EXPECT_TRUE(lu.solve(random_vector(10, 7)).allFinite());

  const double delta = 1e-16;  // rows that agree to rounding: no pivot is exactly zero
  SparseMatrixXcd nearly(2, 2);
  nearly.insert(0, 0) = 1, nearly.insert(1, 0) = 1, nearly.insert(0, 1) = Complex(0.5, 0.1);
  nearly.insert(1, 1) = Complex(0.5 + delta, 0.1 + delta);
  nearly.makeCompressed();
  EXPECT_THROW(ComplexLu{nearly}, std::runtime_error);
}

TEST(ComplexLuTest, BadInput) {
  EXPECT_THROW(ComplexLu{SparseMatrixXcd(0, 0)}, std::invalid_argument);
  EXPECT_THROW(ComplexLu{SparseMatrixXcd(2, 3)}, std::invalid_argument);
  SparseMatrixXcd A = random_matrix(5, 8);
  ComplexLu lu(A);
  EXPECT_THROW(lu.solve(random_vector(4, 9)), std::invalid_argument);
  EXPECT_THROW(lu.refactor(random_matrix(6, 8)), std::invalid_argument);
  SparseMatrixXcd other = A;
  other.prune([](Index row, Index column, Complex) { return row <= column; });
  EXPECT_THROW(lu.refactor(other), std::invalid_argument);
  A.valuePtr()[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ComplexLu{A}, std::invalid_argument);
  EXPECT_THROW(lu.refactor(A), std::invalid_argument);
  A.valuePtr()[3] = 1;
  A.uncompress();
  EXPECT_THROW(ComplexLu{A}, std::invalid_argument);
}

}  // namespace
}  // namespace mb
