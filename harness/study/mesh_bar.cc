#include "harness/study/mesh_bar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>

#include "mechanics/history/history.h"

namespace mb {

namespace {

constexpr double regular = 1;  // [-] order where loads and contacts end

bool is_clamped(const Scene& scene, const Body& body) {
  return std::ranges::any_of(
             body.supports,
             [](const Support& s) { return s.kind == Support::Kind::fixed || s.kind == Support::Kind::driven; }) ||
         std::ranges::any_of(scene.contacts, [&](const ContactPair& pair) {
           return pair.friction > 0 && (pair.body == body.name || pair.obstacle == body.name);
         });
}

double order_of_modes(const Scene& scene, const Body& body) {
  if (body.theory != Theory::solid) return regular;
  double least = body.material.inclusions.empty() ? regular : order_at_a_soft_part;
  if (is_clamped(scene, body))
    least = std::min(least, order_at_a_clamp(body.material.orthotropy ? 0.5 : body.material.poissons_ratio));
  return least;
}

}  // namespace

double order_at_a_clamp(double poissons_ratio) {
  const double nu = poissons_ratio;
  if (nu <= 0) return regular;
  const auto excess = [nu](double p) {  // ascends: from below 0 at 1/2 to (4 nu (1 - nu))/(3 - 4 nu) at 1
    const double s = std::sin(p * pi / 2);
    return s * s - (4 * (1 - nu) * (1 - nu) - p * p) / (3 - 4 * nu);
  };
  double low = 0.5, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) < 0 ? low : high) = middle;
  }
  return high;
}

double order_of_modes(const Scene& scene) {
  double least = regular;
  for (const Body& body : scene.bodies) least = std::min(least, order_of_modes(scene, body));
  return least;
}

namespace {

bool has_fronts(const Scene& scene) {
  const auto passes_on = [&](const std::string& name) {
    return std::ranges::any_of(scene.bodies,
                               [&](const Body& body) { return body.name == name && !(body.damping.beta > 0); });
  };
  return std::ranges::any_of(scene.loads, [&](const Load& load) {
    return std::ranges::any_of(load.tractions, [&](const Traction& on) { return passes_on(on.body); }) &&
           jumps(load.history, scene.duration);
  });
}

int least_degree(const Resolution& meshes) {
  int least = meshes.degree;
  for (const Resolution& other : meshes.others) least = std::min(least, other.degree);
  return least;
}

Order least(const Order& a, const Order& b) {
  return {std::min(a.in_size, b.in_size), std::min(a.in_degree, b.in_degree)};
}

}  // namespace

Orders orders_of_motion(const Scene& scene) {
  const double p = order_of_modes(scene);
  if (!has_fronts(scene)) return {p, 2 * p};
  const double n = std::min(least_degree(scene.truth.coarser), least_degree(own_meshes(scene)));
  const double of_fronts = n / (2 * n + 1);
  return {least(p, {of_fronts, of_fronts}), least(2 * p, {3 * of_fronts, 3 * of_fronts})};
}

bool is_of_least_order(const Metric& metric) {
  constexpr std::string_view strain = "strain-error";
  return metric.name == strain || (metric.whole && metric.whole == strain) || metric.name == "surface-deviation" ||
         metric.name == "truth-rotation";
}

double bar_per_distance(const Resolution& finer, const Resolution& coarser, const Order& order) {
  const double fall = fall_of_errors(finer, coarser, order);
  return fall > 1 ? safety_of_meshes * std::max(1.0, 1 / (fall - 1)) : std::numeric_limits<double>::infinity();
}

PerDistance bars_per_distance(const Scene& scene) {
  const auto& [finer, coarser] = std::tie(scene.truth.finer, scene.truth.coarser);
  const auto [local, mean] = orders_of_motion(scene);
  return {bar_per_distance(finer, coarser, mean), bar_per_distance(finer, coarser, local)};
}

}  // namespace mb
