#include "harness/study/plan.h"

#include <fmt/format.h>

namespace mb {

namespace {

std::vector<Contender> reduced(const Scene& scene) {
  std::vector<Contender> all;
  for (const auto& method : scene.study.methods)
    for (const int modes : scene.study.modes) {
      Contender contender{method, "exact", scene.bodies.front().resolution, {}};
      contender.settings.modes = modes;
      contender.settings.load_tolerance = scene.study.load_tolerance;
      all.push_back(contender);
    }
  return all;
}

std::vector<Contender> full_order(const Rival& rival) {
  std::vector<Contender> all;
  for (const auto& cells : rival.cells)
    for (const int degree : rival.degrees)
      for (const double step : rival.time_steps) {
        Contender contender{"full-order", rival.integrator, {degree, cells}, {}};
        contender.settings.time_step = step;
        all.push_back(contender);
      }
  return all;
}

}  // namespace

std::vector<Contender> contenders(const Scene& scene) {
  std::vector<Contender> all = reduced(scene);
  for (const Rival& rival : scene.study.rivals) {
    const auto more = full_order(rival);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::vector<Contender> truth_contenders(const Scene& scene) {
  std::vector<Contender> all;
  for (const Resolution& resolution : {scene.truth.finer, scene.bodies.front().resolution}) {
    all.push_back({"full-order", "sundials", resolution, {}});
    all.back().settings.relative_tolerance = scene.truth.relative_tolerance;
  }
  return all;
}

bool is_full_order(const Contender& contender) { return contender.method == "full-order"; }

std::string label(const Contender& c) {
  std::string text = c.method;
  if (!is_full_order(c)) text += fmt::format(" r={}", c.settings.modes);
  text += " " + c.integrator;
  if (c.settings.time_step > 0) text += fmt::format(" dt={:.3g} s", c.settings.time_step);
  if (c.integrator == "sundials") text += fmt::format(" rtol={:.0e}", c.settings.relative_tolerance);
  return text + " " + to_string(c.resolution);
}

}  // namespace mb
