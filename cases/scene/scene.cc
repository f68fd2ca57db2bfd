#include "cases/scene/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
  return a.degree == b.degree && a.cells == b.cells && a.graded == b.graded && a.bias == b.bias &&
         a.distorted == b.distorted && a.others == b.others;
}

std::string to_string(const Resolution& resolution) {
  std::string all = fmt::format("Q{} {}", resolution.degree, fmt::join(resolution.cells, "x"));
  if (resolution.graded > 0) all += fmt::format(" graded {}", resolution.graded);
  if (!resolution.bias.empty()) all += fmt::format(" bias {}", fmt::join(resolution.bias, "x"));
  if (resolution.distorted > 0) all += fmt::format(" distorted {}", resolution.distorted);
  for (const Resolution& other : resolution.others) all += " + " + to_string(other);
  return all;
}

Resolution of_body(const Resolution& scene_mesh, std::size_t body) {
  if (body > 0) {
    if (body > scene_mesh.others.size()) throw std::invalid_argument("a mesh of the scene has none for every body");
    return scene_mesh.others[body - 1];
  }
  Resolution first = scene_mesh;
  first.others.clear();
  return first;
}

std::string runs_of(const Check& check) {
  std::string all = check.method;
  if (!check.rotation.empty()) all += " " + check.rotation;
  if (!check.method.empty() && check.method != "full-order") all += fmt::format(" r={}", check.modes);
  if (!check.integrator.empty()) all += " " + check.integrator;
  if (check.time_step) all += fmt::format(" dt={:g} s", *check.time_step);
  return all;
}

const char* to_string(Theory theory) {
  static constexpr const char* names[] = {"solid", "euler-bernoulli", "kirchhoff"};
  return names[static_cast<std::size_t>(theory)];
}

const char* to_string(Kinematics kinematics) { return kinematics == Kinematics::finite ? "finite" : "linear"; }

const char* to_string(RotationCoupling rotation) {
  switch (rotation) {
    case RotationCoupling::rigid:
      return "rigid";
    case RotationCoupling::coupled:
      return "coupled";
    case RotationCoupling::unstiffened:
      return "unstiffened";
  }
  return "unknown";
}

bool is_held(const Body& body) { return !body.supports.empty() || body.theory != Theory::solid; }

const Obstacle* striker_of(const Scene& scene, const Body& body) {
  for (const ContactPair& pair : scene.contacts)
    for (const Obstacle& obstacle : scene.obstacles)
      if (pair.body == body.name && pair.obstacle == obstacle.name && obstacle.striker) return &obstacle;
  return nullptr;
}

const Body* partner_of(const Scene& scene, const ContactPair& pair) {
  for (const Body& body : scene.bodies)
    if (body.name == pair.obstacle) return &body;
  return nullptr;
}

Resolution own_meshes(const Scene& scene) {
  Resolution all = scene.bodies.at(0).resolution;
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) all.others.push_back(scene.bodies[i].resolution);
  return all;
}

Scene on_meshes(Scene scene, Resolution meshes) {
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) scene.bodies[i].resolution = meshes.others.at(i - 1);
  meshes.others.clear();
  scene.bodies.at(0).resolution = std::move(meshes);
  return scene;
}

VectorXd frame_times(const Scene& scene) { return times_at(scene.frame_rate, scene.duration); }

VectorXd sample_times(const Scene& scene) {
  const VectorXd t = times_at(scene.samples_per_second, scene.duration);
  return t.tail((t.array() >= scene.samples_from).count());
}

}  // namespace mb
