#include "cases/contract/kept.h"

#include <fmt/format.h>

#include "cases/contract/model.h"

namespace mb {

Index values_at_a_time(const Scene& scene) {
  constexpr Index in_contact = 15;
  Index n = 1;
  for (const Body& body : scene.bodies) {
    const EvaluationPoints points = evaluation_points(scene, body);
    n += 3 * points.size() + 6 * points.n_strained() + (scene.contacts.empty() ? 0 : in_contact);
  }
  return n;
}

std::string kept_problem(const Scene& scene, Index most) {
  const Index n_times = sample_times(scene).size(), each = values_at_a_time(scene);
  if (n_times <= most / each) return "";
  return fmt::format(
      "a truth keeps {} samples of {} values each, {} in all, and a file of the store takes {}: a lower "
      "samples_per_second or duration keeps fewer, {} samples at most",
      n_times, each, n_times * each, most, most / each);
}

}  // namespace mb
