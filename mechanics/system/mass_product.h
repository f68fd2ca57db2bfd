// y = M x for a consistent mass matrix. On a mesh whose degrees of freedom are the three components of each node,
//
//   M = m (x) I_3,   y_a = sum_b m_ab x_b  (3-vectors),
//
// reading m once serves three rows: about three times less memory traffic. Any other M is used as it is.
#pragma once

#include "mechanics/types.h"

namespace mb {

class MassProduct {
 public:
  explicit MassProduct(const SparseMatrix& M);  // symmetric, full storage; it must outlive this
  void operator()(const VectorXd& x, VectorXd& y) const;  // y = M x; y has the size of x, and is not x

 private:
  const SparseMatrix* M_;
  SparseMatrix m_;  // 0 x 0 where M is not of that form
};

}  // namespace mb
