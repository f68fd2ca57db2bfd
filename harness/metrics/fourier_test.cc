#include "harness/metrics/fourier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <stdexcept>

namespace mb {
namespace {

Eigen::VectorXcd summed(const MatrixXd& x, Index N, Index k) {
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(x.rows());
  for (Index j = 0; j < x.cols(); ++j)
    sum += std::polar(1.0, -2 * pi * static_cast<double>(j * k % N) / static_cast<double>(N)) * x.col(j);
  return sum;
}

TEST(FourierTest, OfAnyEvenLengthIsTheSum) {
  for (const Index n : {1, 2, 7, 33, 100, 257})
    for (const Index N : {2 * n, 2 * n + 6}) {
      const MatrixXd x = MatrixXd::Random(19, n);
      const MatrixXcd X = real_fourier(x, N);
      ASSERT_EQ(X.cols(), N / 2 + 1);
      for (const Index k : {Index{0}, N / 4, N / 2})
        EXPECT_LT((X.col(k) - summed(x, N, k)).norm(), 1e-14 * std::sqrt(static_cast<double>(N)) * x.norm())
            << n << " " << N << " " << k;
    }
}

TEST(FourierTest, OfAPowerOfTwoIsTheSum) {
  const MatrixXd x = MatrixXd::Random(19, 64);
  const MatrixXcd X = fourier(x.cast<std::complex<double>>());
  for (const Index k : {0, 1, 31, 63}) EXPECT_LT((X.col(k) - summed(x, 64, k)).norm(), 1e-13 * x.norm());
}

TEST(FourierTest, RefusesOtherLengths) {
  EXPECT_THROW(fourier(MatrixXcd::Ones(1, 6)), std::invalid_argument);
  EXPECT_THROW(real_fourier(MatrixXd::Ones(1, 8), 7), std::invalid_argument);
  EXPECT_THROW(real_fourier(MatrixXd::Ones(1, 8), 6), std::invalid_argument);
  EXPECT_THROW(real_fourier(MatrixXd(1, 0), 2), std::invalid_argument);
}

}  // namespace
}  // namespace mb
