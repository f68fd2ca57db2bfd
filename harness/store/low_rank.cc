#include "harness/store/low_rank.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {

namespace {

constexpr Index block = 32;     // columns that are taken up at once
constexpr double share = 0.25;  // [-] of the error allowed is what the basis may leave out, the rest is what is cut

Svd svd_of_tall(const MatrixXd& A) {
  const Index n = A.cols();
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  Svd svd = thin_svd(qr.matrixQR().topRows(n).triangularView<Eigen::Upper>());
  MatrixXd U = MatrixXd::Zero(A.rows(), n);
  U.topRows(n) = svd.U;
  U.applyOnTheLeft(qr.householderQ());
  svd.U = std::move(U);
  return svd;
}

MatrixXd orthonormal(const MatrixXd& A) {
  MatrixXd Q = MatrixXd::Identity(A.rows(), A.cols());
  Q.applyOnTheLeft(Eigen::HouseholderQR<MatrixXd>(A).householderQ());
  return Q;
}

// |A|_2 from below, |A^T A x| / |A x|, x made of the largest column by one step more: within some percent of it.
double largest_stretch(const MatrixXd& A) {
  Index at;
  A.colwise().squaredNorm().maxCoeff(&at);
  const VectorXd x = A.transpose() * A.col(at).stableNormalized();
  const VectorXd y = A * x.stableNormalized();
  return (A.transpose() * y.stableNormalized()).norm();
}

// An orthonormal basis of all of A's columns but for what is at most `error` in |.|_2; nothing from `most` columns on.
std::optional<MatrixXd> basis_of(const MatrixXd& A, double error, Index most) {
  const double of_block = error / std::sqrt(std::ceil(static_cast<double>(A.cols()) / block));
  MatrixXd Q(A.rows(), 0);
  for (Index from = 0; from < A.cols(); from += block) {
    MatrixXd rest = A.middleCols(from, std::min(block, A.cols() - from));
    for (int twice = 0; twice < 2; ++twice) rest -= Q * (Q.transpose() * rest).eval();
    if (rest.norm() <= of_block) continue;
    const Svd svd = svd_of_tall(rest);
    const Index more = (svd.sigma.array() > of_block).count(), before = Q.cols();
    if (before + more >= most) return std::nullopt;
    // What is left of Q in the block, rounding of the whole of it, is more of its small vectors than of the large.
    MatrixXd U = svd.U.leftCols(more);
    for (int twice = 0; twice < 2; ++twice) U = orthonormal(U - Q * (Q.transpose() * U));
    Q.conservativeResize(Eigen::NoChange, before + more);
    Q.rightCols(more) = U;
  }
  return Q;
}

// Of a tall matrix, m >= n.
std::optional<LowRank> low_rank_of_tall(const MatrixXd& A, double tolerance) {
  const Index m = A.rows(), n = A.cols();
  const double size = largest_stretch(A);
  if (!std::isfinite(size)) return std::nullopt;  // entries beyond 1e154 overflow in the norms
  if (size == 0) return LowRank{MatrixXd::Zero(m, 1), MatrixXd::Zero(1, n)};
  const auto Q = basis_of(A, share * tolerance * size, m * n / (m + n) + 1);
  if (!Q || Q->cols() == 0) return std::nullopt;  // squares of entries below 1e-162 are none

  const Svd svd = svd_of_tall(A.transpose() * *Q);  // A = Q (V S U^T)
  const Index rank = std::max<Index>(1, (svd.sigma.array() > (1 - share) * tolerance * svd.sigma(0)).count());
  if (rank * (m + n) >= m * n) return std::nullopt;
  return LowRank{*Q * (svd.V.leftCols(rank) * svd.sigma.head(rank).asDiagonal()), svd.U.leftCols(rank).transpose()};
}

}  // namespace

std::optional<LowRank> low_rank(const MatrixXd& A, double tolerance) try {
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
} catch (const std::runtime_error&) {  // a decomposition that does not converge: A is kept as it is
  return std::nullopt;
}

}  // namespace mb
