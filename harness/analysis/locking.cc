// What nearly incompressible material does to elements of each degree: the body's static answer and its first frequency
// over Poisson's ratio (poisson_sweep.h). Hughes 1987, The Finite Element Method, ch. 4: trilinear elements lock, their
// error grows without bound as nu -> 1/2.
#include <fmt/format.h>

#include <cmath>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/modes_against_steps.h"
#include "harness/analysis/poisson_sweep.h"
#include "harness/analysis/told.h"

namespace mb {

namespace {

constexpr double ratios[] = {0.3, 0.49, 0.499, 0.4999};  // [-]
constexpr int n_modes = 24;

Finding locking_table() {
  return table(
      "locking", "locking", "Static answers and first frequencies over Poisson's ratio",
      "The body with other ratios of Poisson, on meshes of about as many unknowns as its own. Truth: elements "
      "of degree 4 on half as many cells again as the finer mesh's. Static error: displacement under all loads at "
      "their full size, M norm; frequency error: of the first elastic mode, positive where the mesh is too stiff.",
      {{"element", ""}, {"nu", "-"}, {"cells", ""}, {"unknowns", ""}, {"static error", "-"}, {"frequency error", "-"}});
}

Finding growth_table() {
  return table("locking", "locking-growth", "What the ratio 0.4999 does to elements of each degree",
               "Errors of the table before at the smallest and the largest ratio, and the one over the other: 1 does "
               "not lock.",
               {{"element", ""},
                {"static error at 0.3", "-"},
                {"static error at 0.4999", "-"},
                {"growth of static error", "-"},
                {"frequency error at 0.3", "-"},
                {"frequency error at 0.4999", "-"},
                {"growth of frequency error", "-"}});
}

Finding dynamics_table() {
  return table(
      "locking", "locking-dynamics", "Modes and steps over Poisson's ratio",
      "The body on its own mesh with other ratios of Poisson, under the case's loads. Modes against steps: 24 modes "
      "with static correction in closed form against all unknowns by adaptive steps at rtol 1e-6, displacement, M "
      "norm; its bar, how far steps at 1e-5 are from those. Bar of a frequency: twice the distance to that of the "
      "finer mesh of the case. Energies: the largest over the first of free vibration within 1000 steps, by average "
      "acceleration at 1000 times the limit of central differences, by these at 0.99 and at 1.01 of it.",
      {{"nu", ""},
       {"unknowns", ""},
       {"first frequency", "Hz"},
       {"modes against steps", "-"},
       {"energy, newmark", "-"},
       {"energy below the limit", "-"},
       {"energy past the limit", "-"}});
}

Finding dynamics(const AnalysisContext& context) {
  Finding found = dynamics_table();
  for (const double nu : ratios) {
    Scene scene = *context.scene;
    scene.bodies.front().material.poissons_ratio = nu;
    const SolvedBody body = solved_body(scene, n_modes);
    const ModesAgainstSteps seen = modes_against_steps(context, body, scene);
    const BarredFrequency first = first_frequency(body, scene);
    found.rows.push_back({nu, count(body.system().M.rows()), first.hertz, seen.off, seen.newmark_far_past.value,
                          seen.central_below.value, seen.central_past.value});
    bar_last_row(found, {{"first frequency", first.bar},
                         {"modes against steps", seen.bar},
                         {"energy, newmark", seen.newmark_far_past.bar},
                         {"energy below the limit", seen.central_below.bar},
                         {"energy past the limit", seen.central_past.bar}});
  }
  return found;
}

std::vector<Finding> tables(const PoissonSweep& all, const std::vector<SweptAnswer>& truths) {
  Finding errors = locking_table(), growth = growth_table();
  for (const auto& [degree, answers] : all.answers) {
    const std::string element = fmt::format("Q{}", degree);
    std::vector<LockingError> found;
    for (size_t i = 0; i < answers.size(); ++i) {
      found.push_back(locking_error(answers[i], truths[i], all.weights));
      errors.rows.push_back({element, all.ratios[i], to_string(answers[i].mesh), count(answers[i].n),
                             found[i].of_displacement, found[i].of_frequency});
    }
    const auto [first_u, first_f] = found.front();
    const auto [last_u, last_f] = found.back();
    growth.rows.push_back({element, first_u, last_u, last_u / first_u, first_f, last_f, last_f / first_f});
  }
  return {errors, growth};
}

}  // namespace

std::vector<Finding> locking(const AnalysisContext& context) {
  const PoissonSweep all = poisson_sweep(*context.scene, {std::begin(ratios), std::end(ratios)});
  std::vector<Finding> found = tables(all, all.truths);
  add_bars(found, tables(all, all.beside), PerDistance(safety_of_meshes));  // cells of half the size: q > 2
  found.push_back(dynamics(context));
  return found;
}

}  // namespace mb
