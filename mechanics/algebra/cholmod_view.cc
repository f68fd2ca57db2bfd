#include "mechanics/algebra/cholmod_view.h"

#include "mechanics/algebra/factorisable.h"

namespace mb::cholmod {

cholmod_sparse lower_triangle(const SparseMatrix& A) {
  require_factorisable(A);
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<size_t>(A.cols());
  view.nzmax = static_cast<size_t>(A.nonZeros());
  view.p = const_cast<int*>(A.outerIndexPtr());
  view.i = const_cast<int*>(A.innerIndexPtr());
  view.x = const_cast<double*>(A.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

cholmod_dense columns(const double* x, Index n_rows, Index n_columns) {
  cholmod_dense view{};
  view.nrow = view.d = static_cast<size_t>(n_rows);
  view.ncol = static_cast<size_t>(n_columns);
  view.nzmax = view.nrow * view.ncol;
  view.x = const_cast<double*>(x);
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

const char* describe(int status) {
  switch (status) {
    case CHOLMOD_OK:
      return "ok";
    case CHOLMOD_NOT_INSTALLED:
      return "method not installed";
    case CHOLMOD_OUT_OF_MEMORY:
      return "out of memory";
    case CHOLMOD_TOO_LARGE:
      return "more entries than 32-bit indices can count";
    case CHOLMOD_INVALID:
      return "invalid input";
    case CHOLMOD_NOT_POSDEF:
      return "not positive definite";
    case CHOLMOD_DSMALL:
      return "a pivot is tiny";
    default:
      return "unknown status";
  }
}

}  // namespace mb::cholmod
