#include "harness/analysis/modes_against_steps.h"

#include <cmath>

#include "harness/analysis/modal_body.h"
#include "harness/analysis/stability_grid.h"
#include "modal/bases/eigenmodes.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double step_tolerance = 1e-6;  // [-] of the adaptive steps
constexpr long steps_of_vibration = 1000;
constexpr double below = 0.99, past = 1.01, far_past = 1000;  // [-] steps over the limit of central differences

LinearBody with_histories(LinearBody body, const Scene& scene) {
  for (size_t i = 0; i < scene.loads.size(); ++i) body.system.s[i] = scene.loads[i].history;
  return body;
}

// off and its bar: how far steps of ten times the tolerance are from those that it is held to.
std::pair<double, double> off_steps(const AnalysisContext& context, const SolvedBody& body, const Scene& scene) {
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
  const auto by_steps = [&](double tolerance) {
    settings.relative_tolerance = tolerance;
    return answer(unreduced(body.model).bodies.front(), "sundials", -1);
  };
  const Trajectory steps = by_steps(step_tolerance);
  const auto off = [&](const Trajectory& one) {
    return mark(metric("displacement-error"), one, steps, metric_context).value;
  };
  return {off(reduced), off(by_steps(10 * step_tolerance))};
}

}  // namespace

SolvedBody solved_body(const Scene& scene, int n_modes) {
  Model model = model_of_own_mesh(std::make_shared<const Scene>(scene), own_meshes(scene));
  const System& system = model.bodies.front().full->system();
  const ShiftedFactor shifted = shifted_factor(system, physical_shift(scene.bodies.front()));
  Modes modes = lowest_modes(system, n_modes, shifted);
  MatrixXd at_rest = inertia_relief(system, shifted, system.F);
  return {std::move(model), std::move(modes), std::move(at_rest)};
}

BarredFrequency first_frequency(const SolvedBody& body, const Scene& scene) {
  constexpr int few = 4;  // a square bar's first two are twins
  const double hertz = body.first() / (2 * pi);
  const auto [meshes, bar_per_distance] = another_mesh(scene);
  const double of_other = solved_body(on_meshes(scene, meshes), few).first() / (2 * pi);
  return {hertz,
          bar_per_distance * std::abs(hertz - of_other) + rounding_of_frequency(body.modes, body.first()) * hertz};
}

ModesAgainstSteps modes_against_steps(const AnalysisContext& context, const SolvedBody& body, const Scene& scene) {
  System reduced = project(body.system(), body.modes);
  for (size_t i = 0; i < scene.loads.size(); ++i) reduced.s[i] = scene.loads[i].history;
  const MappedSystem mapped =
      mapped_system(std::move(reduced), sample_times(scene), scene.duration, scene.study.load_tolerance);
  const double limit = predicted_limit(mapped, "central-difference");
  const auto energy = [&](const char* name, double dt) {
    const Integrator& integrator = context.catalogue.integrator(name);
    const StepCell cell = step_cell(mapped, integrator, dt, steps_of_vibration);
    return BarredEnergy{cell.energy, std::isfinite(cell.energy) ? bar_of_energy(mapped, integrator, cell) : 0};
  };
  const auto [off, bar] = off_steps(context, body, scene);
  return {off, bar, energy("newmark", far_past * limit), energy("central-difference", below * limit),
          energy("central-difference", past * limit)};
}

}  // namespace mb
