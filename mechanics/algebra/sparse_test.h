// Small matrices for tests of factorisations.
#pragma once

#include "mechanics/system/system.h"
#include "mechanics/types.h"

namespace mb::testing {

inline SparseMatrix shifted(const System& system, double sigma) { return system.K - sigma * system.M; }

inline SparseMatrix diagonal(const VectorXd& d) {
  SparseMatrix A(d.size(), d.size());
  for (Index i = 0; i < d.size(); ++i) A.insert(i, i) = d(i);
  A.makeCompressed();
  return A;
}

}  // namespace mb::testing
