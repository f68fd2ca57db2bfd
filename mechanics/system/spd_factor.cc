#include "mechanics/system/spd_factor.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "mechanics/system/symmetric_product.h"

namespace mb {

SpdFactor::SpdFactor(const SparseMatrix& A) {
  if (A.rows() != A.cols()) throw std::invalid_argument("SpdFactor: the matrix is not square");
  if (mb::is_diagonal(A))
    invert(A.diagonal());
  else
    factor_.emplace(A);
}

void SpdFactor::refactor(const SparseMatrix& A) {
  if (factor_)
    factor_->refactor(A);
  else
    *this = SpdFactor(A);
}

void SpdFactor::invert(const VectorXd& diagonal) {
  for (Index i = 0; i < diagonal.size(); ++i)
    if (!(diagonal[i] > 0 && std::isfinite(diagonal[i])))
      throw std::runtime_error(fmt::format("diagonal matrix of {} rows: entry {} is {:.6g}, must be positive",
                                           diagonal.size(), i, diagonal[i]));
  inverse_ = diagonal.cwiseInverse();
}

void SpdFactor::solve(const double* b, double* x) const {
  if (factor_) {
    factor_->solve(b, x);
    return;
  }
  const Index n = inverse_.size();
  Eigen::Map<VectorXd>(x, n) = inverse_.cwiseProduct(Eigen::Map<const VectorXd>(b, n));
}

VectorXd SpdFactor::solve(const VectorXd& b) const {
  if (factor_) return factor_->solve(b);
  if (b.size() != inverse_.size()) throw std::invalid_argument("SpdFactor::solve: right-hand side of another size");
  return inverse_.cwiseProduct(b);
}

MatrixXd SpdFactor::solve(const MatrixXd& b) const {
  if (factor_) return factor_->solve(b);
  if (b.rows() != inverse_.size()) throw std::invalid_argument("SpdFactor::solve: right-hand side of another size");
  return inverse_.asDiagonal() * b;
}

}  // namespace mb
