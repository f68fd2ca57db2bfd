// What slenderness and flatness alone do: the case's box at aspects from compact to its own and beyond, everything else
// of the case kept, times as many periods of the lowest elastic mode, damping in proportion.
//
//   modes against steps = |u_r - u| / |u|,   both on one mesh
//
// u_r: modes with static correction in closed form; u: all unknowns by adaptive steps. Energies: E(t)/E(0) at most, of
// free vibration of the modes, all alike.
#include <cmath>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/stability_grid.h"
#include "harness/analysis/stretched_scene.h"
#include "modal/bases/eigenmodes.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double aspects[] = {1, 14, 200};  // [-]
constexpr int n_modes = 24, few_modes = 4;  // four: a square bar's first two are twins
constexpr double step_tolerance = 1e-6;     // [-] of the adaptive steps
constexpr long steps_of_vibration = 1000;
constexpr double below = 0.99, past = 1.01, far_past = 1000;  // [-] steps over the limit of central differences

Finding aspect_table() {
  return table(
      "aspect", "aspect", "From compact to slender or flat",
      "The case's box with its longer extents changed, so that the longest is `aspect` times the shortest; number of "
      "cells, material and loads kept, times and damping in proportion to the period of the lowest elastic mode. Modes "
      "against steps: 24 modes with static correction in closed form "
      "against all unknowns by adaptive steps at rtol 1e-6, displacement, M norm; its bar, the distance to the same at "
      "1e-5. Energies: the largest over the first "
      "of free vibration within 1000 steps, by average acceleration at 1000 times the limit of central differences, by "
      "these at 0.99 and at 1.01 of it.",
      {{"aspect", ""},
       {"unknowns", ""},
       {"first frequency", "Hz"},
       {"largest residual", "-"},
       {"modes against steps", "-"},
       {"energy, newmark", "-"},
       {"energy below the limit", "-"},
       {"energy past the limit", "-"}});
}

struct Solved {
  Model model;
  Modes modes;
  MatrixXd at_rest;  // [m] n x loads
  const System& system() const { return model.bodies.front().full->system(); }
  double first() const { return modes.omega(modes.n_rigid); }  // [rad/s]
};

Solved solved(const Scene& scene, const Resolution& mesh, int n) {
  Model model = model_of_own_mesh(std::make_shared<const Scene>(scene), mesh);
  const System& system = model.bodies.front().full->system();
  const ShiftedFactor shifted = shifted_factor(system, physical_shift(scene.bodies.front()));
  Modes modes = lowest_modes(system, n, shifted);
  MatrixXd at_rest = inertia_relief(system, shifted, system.F);
  return {std::move(model), std::move(modes), std::move(at_rest)};
}

LinearBody with_histories(LinearBody body, const Scene& scene) {
  for (size_t i = 0; i < scene.loads.size(); ++i) body.system.s[i] = scene.loads[i].history;
  return body;
}

struct Barred {
  double value, bar;
};

// The bar: how far off that is against steps of ten times the tolerance.
Barred modes_against_steps(const AnalysisContext& context, const Solved& body, const Scene& scene) {
  Settings settings;
  settings.load_tolerance = scene.study.load_tolerance;
  const auto answer = [&](LinearBody linear, const char* integrator, int used) {
    return prepare_linear({with_histories(std::move(linear), scene)}, context.catalogue.integrator(integrator),
                          settings, scene.duration, used)
        ->simulate({.t = sample_times(scene)});
  };
  const MatrixXd rest = residual_flexibility(body.modes, body.system().F, body.at_rest);
  const int used = static_cast<int>(body.modes.size() - body.modes.n_rigid);
  const MetricContext metric_context{scene, 0, body.model.bodies.front().points, is_free(context)};
  const Trajectory reduced = answer(reduce(body.model.bodies.front(), body.modes, rest), "exact", used);
  const auto against_steps = [&](double tolerance) {
    settings.relative_tolerance = tolerance;
    return mark(metric("displacement-error"), reduced, answer(unreduced(body.model).bodies.front(), "sundials", -1),
                metric_context)
        .value;
  };
  const double value = against_steps(step_tolerance);
  return {value, std::abs(against_steps(10 * step_tolerance) - value)};
}

double energy(const MappedSystem& mapped, const AnalysisContext& context, const char* integrator, double dt) {
  return step_cell(mapped, context.catalogue.integrator(integrator), dt, steps_of_vibration).energy;
}

// Its damping ratios are what they were: alpha/(2 omega) + beta omega/2.
Scene damped_in_proportion(Scene scene, double slowing) {
  Rayleigh& damping = scene.bodies.front().damping;
  damping = {damping.alpha / slowing, damping.beta * slowing};
  return scene;
}

void add_row(Finding& found, const AnalysisContext& context, double aspect, double own_omega) {
  const Scene changed = proportioned(*context.scene, aspect);
  const double slowing = own_omega / solved(changed, own_meshes(changed), few_modes).first();
  const Scene scene = slowed(damped_in_proportion(changed, slowing), slowing);
  const Solved body = solved(scene, own_meshes(scene), n_modes);
  System reduced = project(body.system(), body.modes);
  for (size_t i = 0; i < scene.loads.size(); ++i) reduced.s[i] = scene.loads[i].history;
  const MappedSystem mapped =
      mapped_system(std::move(reduced), sample_times(scene), scene.duration, scene.study.load_tolerance);
  const double limit = predicted_limit(mapped, "central-difference");
  const auto [off, bar] = modes_against_steps(context, body, scene);
  const std::size_t column = 4;
  found.rows.push_back({count(std::lround(aspect)), count(body.system().M.rows()), body.first() / (2 * pi),
                        body.modes.residual.tail(body.modes.size() - body.modes.n_rigid).maxCoeff(), off,
                        energy(mapped, context, "newmark", far_past * limit),
                        energy(mapped, context, "central-difference", below * limit),
                        energy(mapped, context, "central-difference", past * limit)});
  found.bars.emplace_back(found.columns.size(), std::nan(""));
  found.bars.back()[column] = bar;
}

}  // namespace

std::vector<Finding> aspect(const AnalysisContext& context) {
  Finding found = aspect_table();
  const double own = solved(*context.scene, own_meshes(*context.scene), few_modes).first();
  for (const double ratio : aspects) add_row(found, context, ratio, own);
  return {found};
}

}  // namespace mb
