#include "benchmarks/one_thread.h"

#include <dlfcn.h>

#include "mechanics/algebra/threads.h"

namespace mb {

void on_one_thread() {
  set_blas_threads(1);
  // OpenMP 5.0: no parallel region is active at level 0. By name, since nothing here is compiled with OpenMP.
  if (void* const set = dlsym(RTLD_DEFAULT, "omp_set_max_active_levels")) reinterpret_cast<void (*)(int)>(set)(0);
}

}  // namespace mb
