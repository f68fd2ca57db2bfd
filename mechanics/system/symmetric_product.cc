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

SymmetricProduct::Blocks SymmetricProduct::blocks_of(const SparseMatrix& A) {
  constexpr double most_filled_up = 1.25;  // [-] entries of the blocks, of those that A has
  if (A.rows() % 3 != 0) return {};
  const Index n = A.rows() / 3;
  Blocks all{{0}, {}, {}, std::vector<double>(9 * static_cast<size_t>(n), 0.0)};
  std::vector<int> place(static_cast<size_t>(n), -1);  // of the block in row a, of the last column that had one
  for (Index b = 0; b < n; ++b) {
    for (Index j = 0; j < 3; ++j)
      for (SparseMatrix::InnerIterator entry(A, 3 * b + j); entry && entry.row() < 3 * b + 3; ++entry) {
        const Index a = entry.row() / 3, within = 3 * j + entry.row() % 3;
        if (a == b) {
          all.diagonal[static_cast<size_t>(9 * b + within)] = entry.value();
          continue;
        }
        int& at = place[static_cast<size_t>(a)];
        if (at < all.start.back()) {
          at = static_cast<int>(all.row.size());
          all.row.push_back(static_cast<int>(a));
          all.above.resize(all.above.size() + 9, 0.0);
        }
        all.above[static_cast<size_t>(9 * Index{at} + within)] = entry.value();
      }
    all.start.push_back(static_cast<int>(all.row.size()));
  }
  const auto entries = static_cast<double>(2 * all.above.size() + all.diagonal.size());
  return entries <= most_filled_up * static_cast<double>(A.nonZeros()) ? all : Blocks{};
}

SymmetricProduct::SymmetricProduct(const SparseMatrix& A) : A_(&A), is_diagonal_(is_diagonal(A)) {
  if (is_diagonal_) {
    diagonal_ = A.diagonal();
    return;
  }
  m_ = per_node(A);
  if (m_.rows() == 0) blocks_ = blocks_of(A);
}

void SymmetricProduct::operator()(const VectorXd& x, VectorXd& y) const {
  if (is_diagonal_) {
    y.noalias() = diagonal_.cwiseProduct(x);
  } else if (m_.rows() > 0) {
    by_nodes(x.data(), y.data());
  } else if (!blocks_.start.empty()) {
    y.setZero();
    by_blocks(x.data(), y.data());
  } else {
    y.noalias() = A_->transpose() * x;  // symmetric: the transposed product gathers, which is faster
  }
}

void SymmetricProduct::by_nodes(const double* x, double* y) const {
  const int* const row = m_.innerIndexPtr();
  const int* const start = m_.outerIndexPtr();
  const double* const value = m_.valuePtr();
  for (Index b = 0; b < m_.cols(); ++b) {
    double sum[3] = {0, 0, 0};
    for (int k = start[b]; k < start[b + 1]; ++k) {
      const double* const xa = x + 3 * row[k];
      for (int i = 0; i < 3; ++i) sum[i] += value[k] * xa[i];
    }
    for (int i = 0; i < 3; ++i) y[3 * b + i] = sum[i];
  }
}

void SymmetricProduct::by_blocks(const double* x, double* y) const {
  const int* const row = blocks_.row.data();
  const int* const start = blocks_.start.data();
  const Index n = std::ssize(blocks_.start) - 1;
  for (Index b = 0; b < n; ++b) {
    const double x0 = x[3 * b], x1 = x[3 * b + 1], x2 = x[3 * b + 2];
    double sum[3] = {0, 0, 0};
    for (int k = start[b]; k < start[b + 1]; ++k) {
      const double* const B = blocks_.above.data() + 9 * Index{k};
      const double* const xa = x + 3 * row[k];
      double* const ya = y + 3 * row[k];
      for (int i = 0; i < 3; ++i) ya[i] += B[i] * x0 + B[3 + i] * x1 + B[6 + i] * x2;
      for (int j = 0; j < 3; ++j) sum[j] += B[3 * j] * xa[0] + B[3 * j + 1] * xa[1] + B[3 * j + 2] * xa[2];
    }
    const double* const D = blocks_.diagonal.data() + 9 * b;
    for (int i = 0; i < 3; ++i) y[3 * b + i] += sum[i] + D[i] * x0 + D[3 + i] * x1 + D[6 + i] * x2;
  }
}

}  // namespace mb
