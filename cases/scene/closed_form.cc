#include "cases/scene/closed_form.h"

#include "cases/exact/exact.h"

namespace mb {

std::vector<std::string> closed_form_names() {
  std::vector<std::string> names;
  for (const ExactSolution& solution : exact_solutions()) names.push_back(solution.name);
  return names;
}

std::string closed_form_problem(const Scene& scene) {
  if (!scene.truth.exact.empty() && scene.bodies.front().kinematics == Kinematics::finite)
    return "closed forms are of linear kinematics";
  return scene.truth.exact.empty() ? "" : exact_solution(scene.truth.exact).problem(scene);
}

}  // namespace mb
