// y = A x for the symmetric matrices of a System, in the cheapest way their form allows:
//
//   diagonal (reduced systems, lumped mass)                        y_i = a_i x_i
//   M = m (x) I_3 (consistent mass, three components a node)       y_a = sum_b m_ab x_b  (3-vectors)
//   any other                                                      as it is
//
// Reading m once serves three rows: about three times less memory traffic.
#pragma once

#include "mechanics/types.h"

namespace mb {

bool is_diagonal(const SparseMatrix& A);  // to exact zeros

class SymmetricProduct {
 public:
  explicit SymmetricProduct(const SparseMatrix& A);       // symmetric, full storage, compressed; it must outlive this
  void operator()(const VectorXd& x, VectorXd& y) const;  // y = A x; y has the size of x, and is not x

 private:
  const SparseMatrix* A_;
  bool is_diagonal_;
  VectorXd diagonal_;
  SparseMatrix m_;  // 0 x 0 where A is not of that form
};

}  // namespace mb
