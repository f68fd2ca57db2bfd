#include "harness/store/low_rank.h"

#include <algorithm>
#include <cmath>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {

namespace {

// Of a tall matrix, m >= n.
std::optional<LowRank> low_rank_of_tall(const MatrixXd& A, double tolerance) {
  const Index m = A.rows(), n = A.cols();
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  const MatrixXd triangle = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  if (!triangle.allFinite()) return std::nullopt;  // entries beyond 1e154 overflow in the norms
  const auto [U, sigma, V] = thin_svd(triangle);

  const Index rank = std::max<Index>(1, (sigma.array() > tolerance * sigma(0)).count());
  if (rank * (m + n) >= m * n) return std::nullopt;
  LowRank factors{MatrixXd::Zero(m, rank), V.leftCols(rank).transpose()};
  factors.left.topRows(n) = U.leftCols(rank) * sigma.head(rank).asDiagonal();
  factors.left.applyOnTheLeft(qr.householderQ());
  return factors;
}

}  // namespace

std::optional<LowRank> low_rank(const MatrixXd& A, double tolerance) {
  if (A.size() == 0 || !A.allFinite()) return std::nullopt;
  std::optional<LowRank> factors;
  if (A.rows() >= A.cols()) {
    factors = low_rank_of_tall(A, tolerance);
  } else if (const auto transposed = low_rank_of_tall(A.transpose(), tolerance)) {
    factors = LowRank{transposed->right.transpose(), transposed->left.transpose()};
  }
  if (!factors) return std::nullopt;
  // |.|_F <= sqrt(min(m, n)) |.|_2; 1e-13 is left for rounding.
  const double bound = (tolerance + 1e-13) * std::sqrt(static_cast<double>(std::min(A.rows(), A.cols()))) * A.norm();
  if (!((factors->left * factors->right - A).norm() <= bound)) return std::nullopt;
  return factors;
}

}  // namespace mb
