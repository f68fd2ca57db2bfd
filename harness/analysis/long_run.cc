// A million steps of free vibration without damping: what of the energy is left (energy_drift.h).
#include <algorithm>

#include "harness/analysis/analyses.h"
#include "harness/analysis/energy_drift.h"
#include "harness/analysis/modal_body.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr Index n_steps = 1'000'000;
constexpr double step_times_omega = 2 * pi / 20;  // [-] of the fastest mode kept: fifty of its periods in a window
constexpr int fewest = 2, most = 8;               // modes kept

Finding long_run_table() {
  return table("long-run", "long-run", "Energy over a million steps",
               "Free vibration of the modes kept, all alike in energy, without damping, at a twentieth of the shortest "
               "period a step. Swing: the largest deviation of energy within the first 1000 steps; drift: of its mean "
               "over 1000 steps, weighted after Hann, at the end from that at the start, positive where energy grows; "
               "exponent: of the drift over the number of steps from the first 1000 on. Bar: grid convergence index of "
               "the drift, by windows of 500 steps, the farther of two, and its rounding, twice what motion a third as "
               "large drifts otherwise; of the swing that rounding likewise.",
               {{"integrator", ""},
                {"modes r", ""},
                {"dt", "s"},
                {"steps", ""},
                {"status", ""},
                {"swing", "-"},
                {"drift", "-"},
                {"exponent", "-"},
                {"standard error", "-"}});
}

}  // namespace

std::vector<Finding> long_run(const AnalysisContext& context) {
  const int r = std::clamp(mode_counts(context).front(), fewest, most);
  const ModalBody body = modal_body(context, r);
  const System system = project(body.system, body.modes);
  const double dt = step_times_omega / body.modes.omega(body.modes.size() - 1);
  Finding found = long_run_table();
  for (const Integrator& integrator : context.catalogue.integrators) {
    if (integrator.knob == Integrator::Knob::tolerance) continue;
    const EnergyDrift of = energy_drift(integrator, system, dt, n_steps);
    found.rows.push_back({integrator.name, count(system.M.rows() - system.R.cols()), dt, count(n_steps),
                          to_string(of.status), of.swing, of.drift, of.law.exponent, of.law.standard_error});
    bar_last_row(found, {{"swing", of.bar_of_swing}, {"drift", of.bar}});
  }
  return {found};
}

}  // namespace mb
