#include "mechanics/algebra/dense_eigen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb {
namespace {

const MatrixXd K{{3, -1, 0}, {-1, 2, -1}, {0, -1, 1}};
const MatrixXd M{{2, 0.5, 0}, {0.5, 1, 0.25}, {0, 0.25, 3}};

TEST(DenseEigen, PairsSolveTheirProblem) {
  const EigenPairs one = symmetric_eigen(K), two = generalized_eigen(K, M).value();
  EXPECT_LT((K * one.vectors - one.vectors * one.values.asDiagonal()).norm(), 1e-14);
  EXPECT_LT((K * two.vectors - M * two.vectors * two.values.asDiagonal()).norm(), 1e-14);
  EXPECT_LT((two.vectors.transpose() * M * two.vectors - MatrixXd::Identity(3, 3)).norm(), 1e-14);
  EXPECT_LT(two.values[0], two.values[1]);
  EXPECT_LT(two.values[1], two.values[2]);
  EXPECT_LT((symmetric_eigenvalues(K) - one.values).norm(), 1e-14);
  EXPECT_LT((generalized_eigenvalues(K, M).value() - two.values).norm(), 1e-14);
}

TEST(DenseEigen, TakesTheLowerTriangle) {
  MatrixXd lower = K;
  lower(0, 2) = 7;
  EXPECT_EQ(symmetric_eigenvalues(lower), symmetric_eigenvalues(K));
  EXPECT_EQ(generalized_eigenvalues(lower, M).value(), generalized_eigenvalues(K, M).value());
}

TEST(DenseEigen, OfAQuarterTurnIsImaginary) {
  const Eigen::VectorXcd mu = general_eigenvalues(MatrixXd{{0, -1}, {1, 0}});
  EXPECT_NEAR(std::abs(mu[0] - std::conj(mu[1])), 0, 1e-15);
  EXPECT_NEAR(std::abs(mu[0].imag()), 1, 1e-15);
}

TEST(DenseEigen, NormsAndSingularValuesAgree) {
  const MatrixXd A{{3, 0, 4}, {0, 2, 0}};
  EXPECT_LT((singular_values(A) - Eigen::Vector2d(5, 2)).norm(), 1e-14);
  EXPECT_NEAR(spectral_norm(A), 5, 1e-14);
  const Svd svd = thin_svd(A);
  EXPECT_LT((svd.U * svd.sigma.asDiagonal() * svd.V.transpose() - A).norm(), 1e-14);
  EXPECT_EQ(svd.V.cols(), 2);
  const std::complex<double> i(0, 1);
  const Eigen::MatrixXcd unitary{{0.6, 0.8 * i}, {0.8 * i, 0.6}};
  EXPECT_LT(
      (singular_values(Eigen::MatrixXcd(unitary * Eigen::Vector2cd(3, 2.0 * i).asDiagonal())) - Eigen::Vector2d(3, 2))
          .norm(),
      1e-14);
  EXPECT_EQ(spectral_norm(MatrixXd(0, 4)), 0);
}

VectorXd sizes_of(const Eigen::VectorXcd& values) {
  VectorXd sizes = values.cwiseAbs();
  std::ranges::sort(sizes);
  return sizes;
}

// Two libraries: LAPACK and Eigen. Both are backward stable, their eigenvalues off by some ten roundings of |A|; those
// of A, which is not symmetric, by its condition more.
TEST(DenseEigen, AgreesWithEigensOwn) {
  srand(1);  // NOLINT: of Eigen's Random
  const MatrixXd A = MatrixXd::Random(120, 120);
  const VectorXd scale = VectorXd::LinSpaced(120, 0, -4).unaryExpr([](double e) { return std::pow(10.0, e); });
  const MatrixXd graded =
      scale.asDiagonal() * (A + A.transpose() + 30 * MatrixXd::Identity(120, 120)) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> other(graded);
  const EigenPairs pairs = symmetric_eigen(graded);
  EXPECT_LT((pairs.values - other.eigenvalues()).cwiseAbs().maxCoeff(), 1e-13 * other.eigenvalues().maxCoeff());
  EXPECT_LT((graded * pairs.vectors - pairs.vectors * pairs.values.asDiagonal()).norm(), 1e-13 * graded.norm());
  EXPECT_LT((pairs.vectors.transpose() * pairs.vectors - MatrixXd::Identity(120, 120)).norm(), 1e-12);
  const VectorXd seen = sizes_of(general_eigenvalues(A)),
                 known = sizes_of(Eigen::EigenSolver<MatrixXd>(A, false).eigenvalues());
  EXPECT_LT((seen - known).cwiseAbs().maxCoeff(), 1e-11 * known.maxCoeff());
}

// Triangles as QR leaves them, rows falling by up to a decade from each to the next, columns by half of it.
// For about one in fifty such matrices Eigen's BDCSVD says success, and V is not orthonormal. Errors are rounding times
// some power of n.
TEST(DenseEigen, SingularValuesOfGradedTrianglesAreThoseOfTheMatrix) {
  srand(1);  // NOLINT: of Eigen's Random
  for (const Index n : {16, 20, 32, 64})
    for (int k = 0; k <= 50; ++k) {
      const double decades = 0.02 * k * static_cast<double>(n - 1);
      const VectorXd scale = VectorXd::LinSpaced(n, 0, -decades).unaryExpr([](double x) { return std::pow(10.0, x); });
      const MatrixXd full = scale.asDiagonal() * MatrixXd::Random(n, n) * scale.cwiseSqrt().asDiagonal();
      const MatrixXd A = full.triangularView<Eigen::Upper>();
      const Svd svd = thin_svd(A);
      EXPECT_LT((svd.U * svd.sigma.asDiagonal() * svd.V.transpose() - A).norm(), 1e-13 * A.norm()) << n << " " << k;
      EXPECT_LT((svd.U.transpose() * svd.U - MatrixXd::Identity(n, n)).norm(), 1e-12);
      EXPECT_LT((svd.V.transpose() * svd.V - MatrixXd::Identity(n, n)).norm(), 1e-12);
      EXPECT_LT((singular_values(A) - svd.sigma).cwiseAbs().maxCoeff(), 1e-13 * svd.sigma[0]);
    }
}

TEST(DenseEigen, OfNothingIsNothingAndOfNoSquareNone) {
  EXPECT_EQ(thin_svd(MatrixXd(0, 4)).V.cols(), 0);
  EXPECT_EQ(singular_values(MatrixXd(3, 0)).size(), 0);
  EXPECT_EQ(symmetric_eigen(MatrixXd(0, 0)).values.size(), 0);
  EXPECT_EQ(general_eigenvalues(MatrixXd(0, 0)).size(), 0);
  EXPECT_EQ(generalized_eigenvalues(MatrixXd(0, 0), MatrixXd(0, 0)).value().size(), 0);
  EXPECT_THROW(symmetric_eigen(MatrixXd::Zero(2, 3)), std::invalid_argument);
  EXPECT_THROW(general_eigenvalues(MatrixXd::Zero(3, 2)), std::invalid_argument);
}

TEST(DenseEigen, NamesWhatHasNone) {
  MatrixXd broken = K;
  broken(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(symmetric_eigen(broken), std::runtime_error);
  EXPECT_THROW(symmetric_eigenvalues(broken), std::runtime_error);
  EXPECT_THROW(general_eigenvalues(broken), std::runtime_error);
  EXPECT_THROW(thin_svd(broken), std::runtime_error);
  EXPECT_THROW(singular_values(broken), std::runtime_error);
  EXPECT_FALSE(generalized_eigen(broken, M));
  EXPECT_FALSE(generalized_eigen(K, broken));
  EXPECT_FALSE(generalized_eigen(K, -M));
  EXPECT_FALSE(generalized_eigenvalues(K, MatrixXd::Zero(3, 3)));
}

}  // namespace
}  // namespace mb
