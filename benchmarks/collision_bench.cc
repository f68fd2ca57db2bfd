// Signed distances of points from one body: the superquadric itself, its inside-outside function, its polygons one by
// one and down a tree of boxes. Argument of the polygons: k, n = 48 k^2 triangles. The rate is points a second.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "modal/polygons/tree.h"

namespace mb {
namespace {

const Superquadric body{{0.5, 0.4, 0.3}, 0.5, 0.5};
constexpr Index n_points = 1000;

Matrix3Xd points() {  // inside and outside, the same for all
  std::srand(1);
  return 0.6 * Matrix3Xd::Random(3, n_points);
}

void count(benchmark::State& state, Index n) {
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}

template <class Query>
void run(benchmark::State& state, Index n, const Query& query) {
  const Matrix3Xd x = points().leftCols(n);
  for (auto _ : state) benchmark::DoNotOptimize(query(x).value.data());
  count(state, n);
}

void collision_distance(benchmark::State& state) {
  run(state, n_points, [](const Matrix3Xd& x) { return distances_by_surface(body, x); });
}
BENCHMARK(collision_distance)->Unit(benchmark::kMicrosecond);

void collision_function(benchmark::State& state) {
  run(state, n_points, [](const Matrix3Xd& x) { return distances_by_function(body, x); });
}
BENCHMARK(collision_function)->Unit(benchmark::kMicrosecond);

void collision_depth_inside(benchmark::State& state) {
  run(state, n_points, [](const Matrix3Xd& x) { return depths_inside(body, x); });
}
BENCHMARK(collision_depth_inside)->Unit(benchmark::kMicrosecond);

void collision_polygons(benchmark::State& state) {
  const Polygons polygons(triangulate(body, static_cast<int>(state.range(0))));
  run(state, 100, [&](const Matrix3Xd& x) { return distances_by_brute_force(polygons, x); });
}
BENCHMARK(collision_polygons)->Arg(4)->Arg(16)->Unit(benchmark::kMicrosecond);

void collision_tree(benchmark::State& state) {
  const Polygons polygons(triangulate(body, static_cast<int>(state.range(0))));
  const PolygonTree tree(polygons);
  run(state, n_points, [&](const Matrix3Xd& x) { return tree.distances(x); });
}
BENCHMARK(collision_tree)->Arg(4)->Arg(16)->Arg(32)->Unit(benchmark::kMicrosecond);

void collision_tree_building(benchmark::State& state) {
  const Polygons polygons(triangulate(body, static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(PolygonTree(polygons).bytes());
}
BENCHMARK(collision_tree_building)->Arg(4)->Arg(16)->Arg(32)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mb
