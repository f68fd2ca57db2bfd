// A grid of steps and mode counts for every integrator of fixed step: where it is stable, where it is exact enough, and
// whether the amplification of one step says so before.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/power_law.h"
#include "harness/analysis/stability_grid.h"
#include "mechanics/system/modal_form.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int counts_mapped = 5, steps_a_decade = 4;
constexpr std::size_t fewest_fitted = 3;  // errors of an order
constexpr long steps_of_vibration = 1000, most_steps = 50000;
constexpr Index most_unknowns = 2500;  // [-] of a mesh whose modes are all found: a dense solver takes 15 s
constexpr Index most_coupled = 350;    // [-] likewise where damping couples them: 0.7 s for every step that is tried
constexpr double past_the_limit = 10;  // [-] the grid ends so far beyond the limit of the slowest system
// Explicit Euler's limit, 2 zeta/omega, lies far below the grid. In modes steps are cheap enough to go there.
constexpr double below_the_limit = 30, most_modal_steps = 400000;
// Full order as far as to a tenth of its limit, four steps for an order, where its steps times its modes allow it.
constexpr double below_the_whole_limit = 10, most_whole_work = 4e9;

Finding map_table() {
  return table(
      "stability-map", "stability-map", "Steps that are stable, inaccurate and unstable",
      "Every integrator of fixed step on the modes of the mesh, over mode count and step, and on full order, in all "
      "modes of a mesh of at most 2500 unknowns (350 where damping couples modes; limits of larger ones that no "
      "dashpot couples are in step-limits), of the mass and with the damping that it steps by: explicit schemes lump "
      "the mass, and central differences then lag all damping but that of mass; in modes down to a thirtieth of the "
      "limit of the most, where there is no limit two steps more if fewer than three have errors to fit, on full "
      "order to a tenth of its own, as far as 400 thousand steps and 4e9 steps times modes go. Unstable: the energy "
      "of free vibration, all modes alike, passes 1e4 of what it was within 1000 steps, or steps under the scene's "
      "loads are more than 1000 times off the closed form of the same modes (M norm, elastic part), or off by more "
      "than the whole where free vibration grows more than tenfold over that run by theory, or there is no number. "
      "Inaccurate: not so, and more than 5 % off. Spectral radius: the largest of one step over the modes, of all of "
      "them together where damping couples them; limit: the step where it passes 1. Growth that shows neither in 1000 "
      "steps nor in the run is too slow to be seen; at the limit, within 2e-4 of it, what is bounded may pass 1e4.",
      {{"integrator", ""},
       {"modes r", ""},
       {"system", ""},
       {"dt", "s"},
       {"dt / limit", "-"},
       {"spectral radius", "-"},
       {"energy", "-"},
       {"error", "-"},
       {"found", ""},
       {"limit", "s"},
       {"verdict", ""}});
}

Finding summary_table() {
  return table(
      "stability-map", "stability-summary", "Whether steps do what the amplification says, and converge",
      "Cells of the map by what was found, all of an integrator and those on full order; share: of what is as "
      "predicted, which growth too slow to be seen and steps at the limit are not, and steps that no theory is known "
      "of are counted against it. Order: exponent of the error over the steps of the largest mode count, or of full "
      "order, that grow less than tenfold over the run by theory, whose error lies between 1e-9 and a tenth, of as "
      "many of the least, from four on, as give the smallest standard error, which is that of the line, not how far "
      "this is from the least steps' own. A load that jumps within a step makes every scheme one of first order. "
      "Largest energy: over all cells and steps, of that at the start of free vibration. Energy over its bound: the "
      "same of cells within their limit, over what theory has, 1 of average acceleration and central differences, of "
      "symplectic Euler the mean over the modes of 1/(1 - a/2 - sqrt(a^2 + (a/x - x)^2)/2), x = omega dt, a = 2 zeta "
      "x, undamped 1/(1 - x/2), of central differences whose damping lags by the same invariant; none where damping "
      "couples modes.",
      {{"integrator", ""},
       {"cells", ""},
       {"stable", ""},
       {"inaccurate", ""},
       {"unstable", ""},
       {"not as predicted", ""},
       {"too slow to be seen", ""},
       {"at the limit", ""},
       {"share as predicted", ""},
       {"order", "-"},
       {"standard error", "-"},
       {"largest energy", "-"},
       {"energy over its bound", "-"}});
}

struct Mapped {
  std::vector<MappedSystem> reduced;                 // by mode count, ascending
  std::optional<MappedSystem> implicit, explicitly;  // full order, as implicit and as explicit schemes step it
};

MappedSystem mapped(System in_modes, const Scene& scene) {
  return mapped_system(std::move(in_modes), sample_times(scene), scene.duration, scene.study.load_tolerance);
}

// In all modes of the mesh and of its one mass, by a dense solver.
System in_all_modes(const System& system) {
  System undamped = system;  // whose modes a dashpot does not couple
  undamped.modal_damping = {MatrixXd(system.M.rows(), 0), VectorXd(0)};
  ModalForm form = modal_form(undamped);
  const VectorXd omega = form.lambda.cwiseSqrt();
  return project(system, {system.R.cols(), omega, std::move(form.Phi), {}, omega.cwiseAbs2().maxCoeff()});
}

// In modes of the lumped mass that is the unit matrix, and stays the lumped one, by which integrators damp as they do
// on the mesh.
System in_all_lumped_modes(const System& system) {
  System in_modes = in_all_modes(with_lumped_mass(system));
  in_modes.lumped_mass = in_modes.M;
  return in_modes;
}

// Nothing where damping couples more modes than eigenvalues of a step are found of.
std::optional<MappedSystem> mapped_whole(System in_modes, const Scene& scene) {
  const bool coupled = stepped_modes(in_modes).coupled.K.size() > 0;
  if (coupled && in_modes.M.rows() > most_coupled) return {};
  return mapped(std::move(in_modes), scene);
}

Mapped mapped_systems(const AnalysisContext& context) {
  const std::vector<int> counts = few(mode_counts(context), counts_mapped);
  const ModalBody body = modal_body(context, counts.back());
  const Scene& scene = *context.scene;
  Mapped all;
  for (const int r : counts) {
    const Modes kept = leading(body.modes, r);
    if (kept.size() == kept.n_rigid) continue;
    if (!all.reduced.empty() && kept.size() == all.reduced.back().system.M.rows()) continue;
    all.reduced.push_back(mapped(project(body.system, kept), scene));
  }
  const System& system = body.system;
  if (system.stored_energy || all.reduced.empty()) return all;
  const bool coupled = all.reduced.back().modes.coupled.K.size() > 0;
  if (system.M.rows() > (coupled ? most_coupled : most_unknowns)) return all;
  all.implicit = mapped_whole(in_all_modes(with_consistent_mass(system)), scene);
  all.explicitly = system.lumped_mass.rows() > 0 ? mapped_whole(in_all_lumped_modes(system), scene) : all.implicit;
  return all;
}

// From a tenth of the least 2/omega, or as many steps as one run may take, to past all of them, at most the duration.
std::vector<double> steps_of_grid(const Mapped& all, double duration) {
  const auto limit = [](const MappedSystem& mapped) { return 2 / mapped.modes.omega(mapped.modes.omega.size() - 1); };
  const double least = limit(all.implicit ? *all.implicit : all.reduced.back());
  const double first = std::max(0.1 * least, duration / static_cast<double>(most_steps));
  const double last = std::min(duration, past_the_limit * limit(all.reduced.front()));
  std::vector<double> steps;
  for (int i = 0; i == 0 || steps.back() < last; ++i) steps.push_back(first * std::pow(10., i * 1. / steps_a_decade));
  return steps;
}

// The grid from its first step down to `last`, and the grid itself. Ascending.
std::vector<double> steps_from(double last, std::vector<double> grid) {
  const double first = grid.front();
  for (int i = 1; first * std::pow(10., -i * 1. / steps_a_decade) > last; ++i)
    grid.insert(grid.begin(), first * std::pow(10., -i * 1. / steps_a_decade));
  return grid;
}

// To below the least limit of an integrator on its modes, where it is stable at any step.
std::vector<double> steps_in_modes(const Mapped& all, const std::string& integrator, const std::vector<double>& grid,
                                   double duration) {
  double least = std::numeric_limits<double>::infinity();
  for (const MappedSystem& mapped : all.reduced) least = std::fmin(least, predicted_limit(mapped, integrator));
  if (!(least > 0)) return grid;
  return steps_from(std::max(least / below_the_limit, duration / most_modal_steps), grid);
}

std::vector<double> steps_of_whole(const MappedSystem& whole, const std::string& integrator,
                                   const std::vector<double>& grid, double duration) {
  const double limit = predicted_limit(whole, integrator), n = static_cast<double>(whole.modes.omega.size());
  if (!(limit > 0)) return grid;
  return steps_from(std::max(limit / below_the_whole_limit, duration * n / most_whole_work), grid);
}

// [-] Of the closed form, whose loads are met to that.
double bar_of_error(const StepCell& cell, const Scene& scene) {
  return std::isfinite(cell.error) ? scene.study.load_tolerance : nan;
}

struct Summary {
  double stable = 0, inaccurate = 0, unstable = 0, foretold = 0, otherwise = 0, slow = 0, at_limit = 0, energy = 0;
  double over = nan;  // of the energy its bound
  double bar_of_energy = 0, bar_of_over = 0;
  std::vector<double> dt, error;  // of the largest mode count

  void add(const StepCell& cell, double bar) {
    (cell.found == StepClass::stable ? stable : cell.found == StepClass::inaccurate ? inaccurate : unstable) += 1;
    const std::string said = verdict(cell);
    if (said == "as predicted") foretold += 1;
    if (said == "not as predicted" || said == "no prediction") otherwise += 1;
    if (said == "too slow to be seen") slow += 1;
    if (said == "at the limit") at_limit += 1;
    if (cell.energy > energy) energy = cell.energy, bar_of_energy = bar;
    if (std::isnan(over) || cell.energy / cell.bound > over)
      over = cell.energy / cell.bound, bar_of_over = bar / cell.bound;
  }
  // What grows more than tenfold over the run hides the order, and is past its limit (harness/study/instability.h).
  void keep_error(const StepCell& cell, double duration) {
    const bool grows = duration / cell.dt * std::log(cell.radius) > std::log(10);
    if (!(cell.error > 1e-9 && cell.error < 0.1) || grows) return;
    dt.push_back(cell.dt);
    error.push_back(cell.error);
  }
  std::vector<FindingCell> row(const std::string& integrator) const {
    const auto n = static_cast<Index>(dt.size());
    const PowerLaw law =
        power_law_of_least(Eigen::Map<const VectorXd>(dt.data(), n), Eigen::Map<const VectorXd>(error.data(), n));
    const double cells = stable + inaccurate + unstable;
    return {integrator,         cells,  stable,   inaccurate,       unstable,
            otherwise,          slow,   at_limit, foretold / cells, law.exponent,
            law.standard_error, energy, over};
  }
};

}  // namespace

std::vector<Finding> stability_map(const AnalysisContext& context) {
  const Mapped all = mapped_systems(context);
  Finding map = map_table(), summary = summary_table();
  if (all.reduced.empty()) return {map, summary};
  const double duration = context.scene->duration;
  const std::vector<double> steps = steps_of_grid(all, duration);
  for (const Integrator& integrator : context.catalogue.integrators) {
    if (integrator.knob != Integrator::Knob::time_step) continue;
    Summary sum, of_whole;
    const auto add = [&](const MappedSystem& mapped, const std::vector<double>& dts, bool whole) {
      const double limit = predicted_limit(mapped, integrator.name);
      for (const double dt : dts) {
        const StepCell cell = step_cell(mapped, integrator, dt, steps_of_vibration);
        const double bar = std::isfinite(cell.energy) ? bar_of_energy(mapped, integrator, cell) : nan;
        sum.add(cell, bar);
        if (&mapped == &all.reduced.back()) sum.keep_error(cell, duration);
        if (whole) of_whole.add(cell, bar), of_whole.keep_error(cell, duration);
        map.rows.push_back({integrator.name, count(mapped.modes.omega.size()), whole ? "full order" : "modes", dt,
                            dt / limit, cell.radius, cell.energy, cell.error, to_string(cell.found), limit,
                            verdict(cell)});
        bar_last_row(map, {{"energy", bar}, {"error", bar_of_error(cell, *context.scene)}});
      }
    };
    const std::vector<double> in_modes = steps_in_modes(all, integrator.name, steps, duration);
    for (const MappedSystem& mapped : all.reduced) add(mapped, in_modes, false);
    const bool unlimited = std::isinf(predicted_limit(all.reduced.back(), integrator.name));
    if (unlimited && sum.dt.size() < fewest_fitted)  // of what converges slowly
      add(all.reduced.back(),
          {steps.front() * std::pow(10., -2. / steps_a_decade), steps.front() * std::pow(10., -1. / steps_a_decade)},
          false);
    const auto& whole = integrator.conditionally_stable ? all.explicitly : all.implicit;
    if (whole) add(*whole, steps_of_whole(*whole, integrator.name, steps, duration), true);
    const auto summarise = [&summary](const Summary& of, const std::string& name) {
      summary.rows.push_back(of.row(name));
      bar_last_row(summary, {{"largest energy", of.bar_of_energy}, {"energy over its bound", of.bar_of_over}});
    };
    summarise(sum, integrator.name);
    if (whole) summarise(of_whole, integrator.name + ", full order");
  }
  return {map, summary};
}

}  // namespace mb
