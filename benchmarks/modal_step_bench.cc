// Online work: one step of r uncoupled modes, beside a loop of the STREAM kind that moves as many bytes,
//
//   a_i = b_i + s c_i        McCalpin 1995, IEEE TCCA Newsletter: "triad"
//
// A closed-form step reads eight coefficients, q and v, and writes q and v: twelve numbers a mode.
#include <benchmark/benchmark.h>

#include "mechanics/system/central_difference.h"
#include "mechanics/system/exact.h"

namespace mb {
namespace {

constexpr long numbers_a_mode = 12;
constexpr Index n_steps = 1000;
constexpr double step = 1e-3;  // [s]

// r modes at 1 ... 100 rad/s, lightly damped, one load.
System modes(Index r) {
  System system;
  const VectorXd omega = VectorXd::LinSpaced(r, 1, 100), ones = VectorXd::Ones(r);
  system.M = SparseMatrix(ones.asDiagonal());
  system.K = SparseMatrix(VectorXd(omega.array().square()).asDiagonal());
  system.damping = {0.1, 1e-4};
  system.R = MatrixXd(r, 0);
  system.F = ones;
  system.s = {Step{}};
  system.u0 = system.v0 = VectorXd::Zero(r);
  return system;
}

void run_stepper(benchmark::State& state, const Stepper& stepper, long bytes_a_mode) {
  const VectorXd times = VectorXd::LinSpaced(n_steps + 1, 0, step * static_cast<double>(n_steps));
  for (auto _ : state) benchmark::DoNotOptimize(stepper.run(times).u.data());
  state.SetItemsProcessed(state.iterations() * n_steps * state.range(0));  // modes stepped
  if (bytes_a_mode > 0) state.SetBytesProcessed(state.iterations() * n_steps * state.range(0) * bytes_a_mode);
}

void closed_form_step(benchmark::State& state) {
  run_stepper(state, *exact(modes(state.range(0)), step * static_cast<double>(n_steps)), 8 * numbers_a_mode);
}
BENCHMARK(closed_form_step)->Arg(32)->Arg(128)->Arg(1024)->Unit(benchmark::kMicrosecond);

void central_difference_step(benchmark::State& state) {
  const System system = modes(state.range(0));
  run_stepper(state, *central_difference(system, step), 0);
}
BENCHMARK(central_difference_step)->Arg(32)->Arg(128)->Arg(1024)->Unit(benchmark::kMicrosecond);

// As many bytes as n_steps closed-form steps of r modes.
void triad(benchmark::State& state) {
  const Index n = state.range(0) * numbers_a_mode / 3;
  VectorXd a = VectorXd::Zero(n), b = VectorXd::Ones(n), c = VectorXd::Ones(n);
  for (auto _ : state)
    for (Index repeat = 0; repeat < n_steps; ++repeat) {
      a.noalias() = b + 3.0 * c;
      benchmark::DoNotOptimize(a.data());
      benchmark::ClobberMemory();
    }
  state.SetItemsProcessed(state.iterations() * n_steps * state.range(0));
  state.SetBytesProcessed(state.iterations() * n_steps * n * 24);
}
BENCHMARK(triad)->Arg(32)->Arg(128)->Arg(1024)->Arg(1 << 20)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mb
