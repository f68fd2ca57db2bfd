// Threads of the libraries in use. Timed parts run on one thread on both sides unless stated.
#pragma once

#include <string>

namespace mb {

void set_blas_threads(int n);    // n >= 1; does nothing where the BLAS has no such switch
int blas_threads();              // 1 where the BLAS does not tell
std::string blas_description();  // e.g. "OpenBLAS 0.3.21 ... 1 thread", "reference BLAS (slow)"

// OpenMP in the calling thread: CHOLMOD asks it for four threads in every factorisation, which OMP_NUM_THREADS does not
// forbid and which on two cores costs half as much time again.
void forbid_openmp();
void use_one_thread();  // BLAS in the whole process, OpenMP in the calling thread

}  // namespace mb
