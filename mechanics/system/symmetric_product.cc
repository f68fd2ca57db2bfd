#include "mechanics/system/symmetric_product.h"

namespace mb {

namespace {

// m with M = m (x) I_3, or 0 x 0.
SparseMatrix per_node(const SparseMatrix& M) {
  if (M.rows() % 3 != 0) return {};
  const Index n = M.rows() / 3;
  SparseMatrix m(n, n);
  m.reserve(M.nonZeros() / 3);
  for (Index b = 0; b < n; ++b) {
    m.startVec(b);
    SparseMatrix::InnerIterator x(M, 3 * b), y(M, 3 * b + 1), z(M, 3 * b + 2);
    for (; x && y && z; ++x, ++y, ++z) {
      const bool alike = x.row() % 3 == 0 && y.row() == x.row() + 1 && z.row() == x.row() + 2 &&
                         x.value() == y.value() && x.value() == z.value();
      if (!alike) return {};
      m.insertBack(x.row() / 3, b) = x.value();
    }
    if (x || y || z) return {};
  }
  m.finalize();
  return m;
}

}  // namespace

bool is_diagonal(const SparseMatrix& A) {
  for (Index j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
      if (entry.row() != entry.col() && entry.value() != 0) return false;
  return true;
}

SymmetricProduct::SymmetricProduct(const SparseMatrix& A) : A_(&A), is_diagonal_(is_diagonal(A)) {
  if (is_diagonal_)
    diagonal_ = A.diagonal();
  else
    m_ = per_node(A);
}

void SymmetricProduct::operator()(const VectorXd& x, VectorXd& y) const {
  if (is_diagonal_) {
    y.noalias() = diagonal_.cwiseProduct(x);
    return;
  }
  if (m_.rows() == 0) {
    y.noalias() = A_->transpose() * x;  // symmetric: the transposed product gathers, which is faster
    return;
  }
  const int* const row = m_.innerIndexPtr();
  const int* const start = m_.outerIndexPtr();
  const double* const value = m_.valuePtr();
  for (Index b = 0; b < m_.cols(); ++b) {
    double sum[3] = {0, 0, 0};
    for (int k = start[b]; k < start[b + 1]; ++k) {
      const double* const xa = x.data() + 3 * row[k];
      for (int i = 0; i < 3; ++i) sum[i] += value[k] * xa[i];
    }
    for (int i = 0; i < 3; ++i) y[3 * b + i] = sum[i];
  }
}

}  // namespace mb
