// What slenderness and flatness alone do: the case's box at aspects from compact to its own and beyond, everything else
// of the case kept, times as many periods of the lowest elastic mode, damping in proportion.
#include <cmath>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/modes_against_steps.h"
#include "harness/analysis/stretched_scene.h"

namespace mb {

namespace {

constexpr double aspects[] = {1, 4, 14, 50, 200};  // [-]
constexpr int n_modes = 24, few_modes = 4;         // four: a square bar's first two are twins

Finding aspect_table() {
  return table(
      "aspect", "aspect", "From compact to slender or flat",
      "The case's box with its longer extents changed, so that the longest is `aspect` times the shortest; number of "
      "cells, material and loads kept, times and damping in proportion to the period of the lowest elastic mode. Modes "
      "against steps: 24 modes with static correction in closed form against all unknowns by adaptive steps at rtol "
      "1e-6, displacement, M norm; its bar, how far steps at 1e-5 are from those. Bar of a frequency: twice the "
      "distance to that of the finer mesh of the case. Energies: of these 24 modes the largest over the first of free "
      "vibration within 1000 steps, by average acceleration at 1000 times the limit of central differences, by these "
      "at 0.99 and at 1.01 of it.",
      {{"aspect", ""},
       {"unknowns", ""},
       {"first frequency", "Hz"},
       {"largest residual", "-"},
       {"modes against steps", "-"},
       {"energy, newmark", "-"},
       {"energy below the limit", "-"},
       {"energy past the limit", "-"}});
}

// Its damping ratios are what they were: alpha/(2 omega) + beta omega/2.
Scene damped_in_proportion(Scene scene, double slowing) {
  Rayleigh& damping = scene.bodies.front().damping;
  damping = {damping.alpha / slowing, damping.beta * slowing};
  return scene;
}

void add_row(Finding& found, const AnalysisContext& context, double aspect, double own_omega) {
  const Scene changed = proportioned(*context.scene, aspect);
  const double slowing = own_omega / solved_body(changed, few_modes).first();
  const Scene scene = slowed(damped_in_proportion(changed, slowing), slowing);
  const SolvedBody body = solved_body(scene, n_modes);
  const ModesAgainstSteps seen = modes_against_steps(context, body, scene);
  const BarredFrequency first = first_frequency(body, scene);
  found.rows.push_back({count(std::lround(aspect)), count(body.system().M.rows()), first.hertz,
                        body.modes.residual.tail(body.modes.size() - body.modes.n_rigid).maxCoeff(), seen.off,
                        seen.newmark_far_past.value, seen.central_below.value, seen.central_past.value});
  bar_last_row(found, {{"first frequency", first.bar},
                       {"modes against steps", seen.bar},
                       {"energy, newmark", seen.newmark_far_past.bar},
                       {"energy below the limit", seen.central_below.bar},
                       {"energy past the limit", seen.central_past.bar}});
}

}  // namespace

std::vector<Finding> aspect(const AnalysisContext& context) {
  Finding found = aspect_table();
  const double own = solved_body(*context.scene, few_modes).first();
  for (const double ratio : aspects) add_row(found, context, ratio, own);
  return {found};
}

}  // namespace mb
