// CHOLMOD's views of Eigen's arrays: no value is copied. For the files of this folder alone.
#pragma once

#include <cholmod.h>

#include "mechanics/types.h"

namespace mb::cholmod {

// CHOLMOD's parameters and workspace; silent, since errors are thrown by the callers.
class Common {
 public:
  Common() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
  }
  ~Common() { cholmod_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  cholmod_common* operator&() { return &common_; }
  cholmod_common* operator->() { return &common_; }

 private:
  cholmod_common common_;
};

// Views take const arrays, yet CHOLMOD's structures hold plain pointers: they are only read.
// A: square, compressed, finite; else std::invalid_argument. Entries above the diagonal are ignored by CHOLMOD.
cholmod_sparse lower_triangle(const SparseMatrix& A);
cholmod_dense columns(const double* x, Index n_rows, Index n_columns);

const char* describe(int status);  // CHOLMOD's status in words

}  // namespace mb::cholmod
