#include "cases/scene/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace mb {

namespace {

// i / rate for i = 0, 1, ...; a last time that misses the duration by rounding alone is the duration.
VectorXd times_at(double rate, double duration) {
  const auto n = static_cast<Index>(std::floor(duration * rate * (1 + 1e-12)));
  VectorXd t(n + 1);
  for (Index i = 0; i <= n; ++i) t[i] = std::min(static_cast<double>(i) / rate, duration);
  return t;
}

}  // namespace

bool operator==(const Resolution& a, const Resolution& b) {
  return a.degree == b.degree && a.cells == b.cells && a.graded == b.graded;
}

std::string to_string(const Resolution& resolution) {
  const std::string even = fmt::format("Q{} {}", resolution.degree, fmt::join(resolution.cells, "x"));
  return resolution.graded == 0 ? even : fmt::format("{} graded {}", even, resolution.graded);
}

const char* to_string(Theory theory) {
  static constexpr const char* names[] = {"solid", "euler-bernoulli", "kirchhoff"};
  return names[static_cast<std::size_t>(theory)];
}

const char* to_string(Kinematics kinematics) { return kinematics == Kinematics::finite ? "finite" : "linear"; }

bool is_held(const Body& body) { return !body.supports.empty() || body.theory != Theory::solid; }

const Obstacle* striker_of(const Scene& scene, const Body& body) {
  for (const ContactPair& pair : scene.contacts)
    for (const Obstacle& obstacle : scene.obstacles)
      if (pair.body == body.name && pair.obstacle == obstacle.name && obstacle.striker) return &obstacle;
  return nullptr;
}

VectorXd frame_times(const Scene& scene) { return times_at(scene.frame_rate, scene.duration); }

VectorXd sample_times(const Scene& scene) {
  const VectorXd t = times_at(scene.samples_per_second, scene.duration);
  return t.tail((t.array() >= scene.samples_from).count());
}

}  // namespace mb
