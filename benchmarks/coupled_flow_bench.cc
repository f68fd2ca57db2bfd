// One step of rotation and r modes that are coupled (modal/frame/coupled_flow.h), beside the flops of its products
// with matrices: five evaluations of twelve r x r.
#include <benchmark/benchmark.h>

#include "modal/frame/coupled_flow.h"

namespace mb {
namespace {

constexpr double step = 1e-4;  // [s]

// r modes at 300 ... 3000 rad/s of 500 points of a kilogram.
FloatingBody body(Index r) {
  const Index m = 500;
  const Matrix3Xd X = 0.1 * Matrix3Xd::Random(3, m);
  const VectorXd masses = VectorXd::Constant(m, 1.0 / m);
  FloatingBody one{true, 1, 0.007 * Eigen::Matrix3d::Identity(), Vector3d::Zero(), {}, VectorXd::Zero(r), {}, {}};
  for (Index i = 0; i < r; ++i)
    one.modes.push_back(roots({std::pow(300 + 2700.0 * static_cast<double>(i) / static_cast<double>(r), 2), 1}));
  one.coupling = std::make_shared<const SpinCoupling>(spin_coupling(X, masses, MatrixXd::Random(3 * m, r)));
  return one;
}

void coupled_step(benchmark::State& state) {
  const Index r = state.range(0);
  const FloatingBody one = body(r);
  const CoupledFlow flow(one, step);
  BodyState at{Vector3d::Zero(),
               Vector3d::Zero(),
               Eigen::Quaterniond::Identity(),
               Vector3d(0.01, 0.02, 0.03),
               VectorXd::Constant(r, 1e-5),
               VectorXd::Zero(r),
               VectorXd(0)};
  for (auto _ : state) {
    at = flow.advance(std::move(at));
    benchmark::DoNotOptimize(at.q.data());
  }
  state.counters["flop/s"] =
      benchmark::Counter(static_cast<double>(state.iterations() * 5 * 12 * 2 * r * r), benchmark::Counter::kIsRate);
}
BENCHMARK(coupled_step)->Arg(8)->Arg(32)->Arg(64)->Arg(128)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mb
