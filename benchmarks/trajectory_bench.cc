// What every full-order run ends with: displacement and strain read off at points, and their compression.
#include <benchmark/benchmark.h>

#include <cmath>

#include "cases/contract/linear.h"
#include "harness/store/low_rank.h"

namespace mb {
namespace {

// Of `waves` shapes whose sizes fall by a tenth each; values, times.
MatrixXd motion(Index n_values, Index n_times, int waves) {
  MatrixXd A = MatrixXd::Zero(n_values, n_times);
  for (int k = 1; k <= waves; ++k) {
    const auto x = VectorXd::LinSpaced(n_values, 0, 3).array(), t = VectorXd::LinSpaced(n_times, 0, 3).array();
    A += std::pow(0.9, k) * (k * x).sin().matrix() * (1.3 * k * t).cos().matrix().transpose();
  }
  return A;
}

// Arguments: times, waves. 3000 values.
void compression(benchmark::State& state) {
  const MatrixXd A = motion(3000, state.range(0), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(low_rank(A, 1e-12));
}
BENCHMARK(compression)->ArgsProduct({{240, 960}, {10, 100}})->Unit(benchmark::kMillisecond);

// Argument: times. Six rows a point, of 27 nodes each, as of a mesh of second degree.
SparseMatrix of_mesh(Index n_points, Index n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index p = 0; p < n_points; ++p)
    for (Index row = 0; row < 6; ++row)
      for (Index k = 0; k < 54; ++k) entries.emplace_back(6 * p + row, (3 * p + 37 * k) % n, 1.0);
  SparseMatrix U(6 * n_points, n);
  U.setFromTriplets(entries.begin(), entries.end());
  return U;
}
void reading_off(benchmark::State& state) {
  const Observation at_points{of_mesh(500, 3000), {}};
  const MatrixXd q = MatrixXd::Random(3000, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(observe(at_points, q, {}).data());
}
BENCHMARK(reading_off)->Arg(480)->Unit(benchmark::kMillisecond);

// The same, time by time: the ratio of the two is what taking sixteen at once is worth.
void reading_off_one_by_one(benchmark::State& state) {
  const SparseMatrix U = of_mesh(500, 3000);
  const MatrixXd q = MatrixXd::Random(3000, state.range(0));
  MatrixXd seen(U.rows(), q.cols());
  for (auto _ : state) {
    for (Index k = 0; k < q.cols(); ++k) seen.col(k).noalias() = U * q.col(k);
    benchmark::DoNotOptimize(seen.data());
  }
}
BENCHMARK(reading_off_one_by_one)->Arg(480)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mb
