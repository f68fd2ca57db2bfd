// Reconstruction of many frames as one matrix product, u = U q, beside the rate of the BLAS's own on square matrices.
// Rates are the counters `flop/s`; divide one by the other.
#include <benchmark/benchmark.h>

#include "cases/contract/linear.h"

extern "C" void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
                       const int*, const double*, const int*, const double*, double*, const int*);

namespace mb {
namespace {

void blas_product(const MatrixXd& A, const MatrixXd& B, MatrixXd& C) {
  const int m = static_cast<int>(A.rows()), n = static_cast<int>(B.cols()), k = static_cast<int>(A.cols());
  const double one = 1, zero = 0;
  dgemm_("N", "N", &m, &n, &k, &one, A.data(), &m, B.data(), &k, &zero, C.data(), &m);
}

void blas_square(benchmark::State& state) {
  const Index n = state.range(0);
  const MatrixXd A = MatrixXd::Random(n, n), B = MatrixXd::Random(n, n);
  MatrixXd C(n, n);
  for (auto _ : state) blas_product(A, B, C);
  state.counters["flop/s"] =
      benchmark::Counter(2e0 * static_cast<double>(n * n * n), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(blas_square)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);

// Arguments: modes, frames. 500 points, three components.
constexpr Index n_values = 1500;

void count(benchmark::State& state) {
  state.counters["flop/s"] = benchmark::Counter(2e0 * static_cast<double>(n_values * state.range(0) * state.range(1)),
                                                benchmark::Counter::kIsIterationInvariantRate);
}
void reconstruction(benchmark::State& state) {
  const Observation at_points{MatrixXd(MatrixXd::Random(n_values, state.range(0))), {}};
  const MatrixXd q = MatrixXd::Random(state.range(0), state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(observe(at_points, q, {}).data());
  count(state);
}
BENCHMARK(reconstruction)->ArgsProduct({{8, 32, 128}, {300, 3000}})->Unit(benchmark::kMillisecond);

// The same product by the BLAS, the result in memory that is warm.
void blas_reconstruction(benchmark::State& state) {
  const MatrixXd U = MatrixXd::Random(n_values, state.range(0)), q = MatrixXd::Random(state.range(0), state.range(1));
  MatrixXd u(n_values, state.range(1));
  for (auto _ : state) blas_product(U, q, u);
  count(state);
}
BENCHMARK(blas_reconstruction)->ArgsProduct({{8, 32, 128}, {300, 3000}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mb
