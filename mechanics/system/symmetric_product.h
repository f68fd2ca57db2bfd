// y = A x for the symmetric matrices of a System, in the cheapest way their form allows:
//
//   diagonal (reduced systems, lumped mass)                        y_i = a_i x_i
//   M = m (x) I_3 (consistent mass, three components a node)       y_a = sum_b m_ab x_b  (3-vectors)
//   3 x 3 blocks, nearly all full (stiffness of solids)            y_a += A_ab x_b, y_b += A_ab^T x_a for a < b
//   any other                                                      as it is
//
// Reading m once serves three rows: about three times less memory traffic. Of blocks half are read, each with one
// index for nine entries and for the two products it has a part in: as much less.
#pragma once

#include <vector>

#include "mechanics/types.h"

namespace mb {

bool is_diagonal(const SparseMatrix& A);  // to exact zeros

class SymmetricProduct {
 public:
  explicit SymmetricProduct(const SparseMatrix& A);       // symmetric, full storage, compressed; it must outlive this
  void operator()(const VectorXd& x, VectorXd& y) const;  // y = A x; y has the size of x, and is not x

 private:
  // Of the pairs of nodes a < b, column b after column b, nine entries each, by columns.
  struct Blocks {
    std::vector<int> start, row;
    std::vector<double> above, diagonal;
  };
  static Blocks blocks_of(const SparseMatrix& A);  // empty where A is not nearly full of such
  void by_nodes(const double* x, double* y) const;
  void by_blocks(const double* x, double* y) const;  // y: zeros

  const SparseMatrix* A_;
  bool is_diagonal_;
  VectorXd diagonal_;
  SparseMatrix m_;  // 0 x 0 where A is not of that form
  Blocks blocks_;
};

}  // namespace mb
