// Threads of the BLAS in use. Timed parts run on one thread on both sides unless stated.
#pragma once

#include <string>

namespace mb {

void set_blas_threads(int n);    // n >= 1; does nothing where the BLAS has no such switch
std::string blas_description();  // e.g. "OpenBLAS 0.3.21 ... 1 thread", "reference BLAS (slow)"

}  // namespace mb
