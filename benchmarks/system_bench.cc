// Offline work on the mesh: assembly, factor, solves, modes. Arguments: splits of the cylinder (bodies.h).
#include <benchmark/benchmark.h>

#include "benchmarks/bodies.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/system/symmetric_product.h"
#include "modal/bases/eigenmodes.h"
#include "modal/bases/largest_eigenvalue.h"

namespace mb {
namespace {

void assembly(benchmark::State& state) {
  Index n = 0;
  for (auto _ : state) n = cylinder(static_cast<int>(state.range(0)))->system().M.rows();
  state.counters["unknowns"] = static_cast<double>(n);
}
BENCHMARK(assembly)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

void factor(benchmark::State& state) {
  const auto model = cylinder(static_cast<int>(state.range(0)));
  double nonzeros = 0;
  for (auto _ : state) nonzeros = shifted_factor(model->system(), cylinder_shift).factor.nonzeros();
  state.counters["nonzeros"] = nonzeros;
}
BENCHMARK(factor)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

// Second argument: right-hand sides at once. A solve reads the factor twice.
void solve(benchmark::State& state) {
  const auto model = cylinder(static_cast<int>(state.range(0)));
  const ShiftedFactor shifted = shifted_factor(model->system(), cylinder_shift);
  const Index n = shifted.factor.size(), columns = state.range(1);
  const MatrixXd b = uniform_noise(n * columns, 1).reshaped(n, columns);
  for (auto _ : state) benchmark::DoNotOptimize(shifted.factor.solve(b));
  state.SetItemsProcessed(state.iterations() * columns);
  state.SetBytesProcessed(state.iterations() * static_cast<long>(16 * shifted.factor.nonzeros()));
}
BENCHMARK(solve)->ArgsProduct({{2, 4}, {1, 8, 32}})->Unit(benchmark::kMillisecond);

void product(benchmark::State& state, bool mass) {
  const auto model = cylinder(static_cast<int>(state.range(0)));
  const SymmetricProduct multiply(mass ? model->system().M : model->system().K);
  const VectorXd x = uniform_noise(model->system().M.rows(), 1);
  VectorXd y = x;
  for (auto _ : state) {
    multiply(x, y);
    benchmark::DoNotOptimize(y.data());
  }
}
BENCHMARK_CAPTURE(product, stiffness, false)->Arg(4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(product, mass, true)->Arg(4)->Unit(benchmark::kMillisecond);

// Second argument: elastic modes. Factor and gate not included.
void eigensolve(benchmark::State& state) {
  const auto model = cylinder(static_cast<int>(state.range(0)));
  const ShiftedFactor shifted = shifted_factor(model->system(), cylinder_shift);
  const int n_elastic = static_cast<int>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(elastic_modes(model->system(), n_elastic, shifted).lambda.data());
}
BENCHMARK(eigensolve)->ArgsProduct({{2, 4}, {8, 24, 128}})->Unit(benchmark::kMillisecond);

// What the gate adds: the largest eigenvalue, residuals, the count by an LDL^T.
void gate(benchmark::State& state) {
  const auto model = cylinder(static_cast<int>(state.range(0)));
  const System& system = model->system();
  const ElasticModes modes = elastic_modes(system, 24, shifted_factor(system, cylinder_shift));
  for (auto _ : state) {
    Modes found = with_rigid(system, modes);
    found.lambda_max = largest_eigenvalue(system);
    check_modes(system, found, found.n_rigid + 25);  // the 24th has a twin
  }
}
BENCHMARK(gate)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mb
