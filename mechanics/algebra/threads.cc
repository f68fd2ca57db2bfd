#include "mechanics/algebra/threads.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace mb {
namespace {

// The BLAS is chosen when the program starts (Debian's alternatives), so OpenBLAS's own switches are looked up by name.
template <typename Function>
Function* find(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

void set_blas_threads(int n) {
  if (n < 1) throw std::invalid_argument("set_blas_threads: at least one thread");
  if (auto* set = find<void(int)>("openblas_set_num_threads")) set(n);
}

int blas_threads() {
  auto* threads = find<int()>("openblas_get_num_threads");
  return threads == nullptr ? 1 : threads();
}

void forbid_openmp() {
  // No parallel region is active at level 0 (OpenMP 5.0).
  if (auto* set = find<void(int)>("omp_set_max_active_levels")) set(0);
}

void use_one_thread() {
  set_blas_threads(1);
  forbid_openmp();
}

std::string blas_description() {
  auto* config = find<char*()>("openblas_get_config");
  auto* threads = find<int()>("openblas_get_num_threads");
  if (config == nullptr || threads == nullptr) return "reference BLAS (slow)";
  const int n = threads();
  return fmt::format("{}, {} thread{}", config(), n, n == 1 ? "" : "s");
}

}  // namespace mb
