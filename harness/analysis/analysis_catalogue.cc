#include <algorithm>
#include <stdexcept>

#include "harness/analysis/analyses.h"

namespace mb {

const std::vector<Analysis>& analysis_catalogue() {
  constexpr auto loaded = Analysis::Scenes::without_contact, touching = Analysis::Scenes::with_contact;
  static const std::vector<Analysis> all{
      {.name = "budget",
       .doc = "which part of an answer's error is due to the step, to truncation, to the mesh, to contact on its "
              "surface and to finite strain",
       .run = &error_budget,
       .of_truth = true},
      {.name = "step-limits",
       .doc = "largest stable steps of explicit schemes, by formula, by bisection and by runs",
       .run = &step_limits,
       .single_modes = true},
      {.name = "stability-map",
       .doc = "which steps of every integrator are stable, inaccurate and unstable over mode count and step, beside "
              "what one step's amplification predicts",
       .run = &stability_map,
       .scenes = loaded},
      {.name = "aliasing",
       .doc = "what frames make of motion too fast for them, and what it takes to avoid it",
       .run = &temporal_aliasing,
       .scenes = loaded,
       .of_truth = true,
       .of_mesh = true},
      {.name = "frequency-response",
       .doc = "steady response at the first probe over frequency, full against reduced",
       .run = &frequency_responses,
       .scenes = loaded},
      {.name = "mode-amplitudes",
       .doc = "how a mode's displacement falls with its frequency for fixed energy, force and impulse",
       .run = &mode_amplitudes,
       .of_mesh = true},
      {.name = "damping",
       .doc = "damping ratios asked for and achieved, mode by mode, by the full and the reduced system and by the "
              "study's steps",
       .run = &achieved_damping,
       .scenes = loaded,
       .of_mesh = true},
      {.name = "damping-coupling",
       .doc = "what keeping the diagonal alone costs where damping couples modes",
       .run = &coupled_damping,
       .scenes = loaded,
       .of_mesh = true},
      {.name = "long-run",
       .doc = "energy over a million steps of free vibration, by every integrator of fixed step and in closed form",
       .run = &long_run,
       .scenes = loaded},
      {.name = "multiplets", .doc = "modes by two solvers, multiplet by multiplet", .run = &multiplets},
      {.name = "aspect",
       .doc = "modes and steps of a box from compact to 200 times as long as thick",
       .run = &aspect,
       .scenes = loaded},
      {.name = "locking",
       .doc = "static answers and first frequencies by degree of the elements as Poisson's ratio nears 1/2",
       .run = &locking,
       .scenes = loaded},
      {.name = "linearity",
       .doc = "how far linear theory is off: estimated by a perturbation series, measured against finite strain",
       .run = &linearity,
       .scenes = loaded,
       .of_truth = true,
       .of_mesh = true},
      {.name = "frequencies",
       .doc = "natural frequencies against published ones, with observed order",
       .run = &natural_frequencies},
      {.name = "probe-extremes",
       .doc = "largest and smallest probe values, when, and the static ones",
       .run = &probe_extremes,
       .scenes = loaded,
       .of_truth = true,
       .of_mesh = true},
      {.name = "collision-cost",
       .doc = "cost of points against polygons, a tree of boxes over them and an analytic shape",
       .run = &collision_cost,
       .timed = true},
      {.name = "contact-forces",
       .doc = "errors of contact forces from vertices, quadratures and curvatures",
       .run = &contact_forces},
      {.name = "contact-stiffness",
       .doc = "what halving and doubling the stiffness of the contact layer does, and how a hundredth of it grows from "
              "contact to contact",
       .run = &contact_stiffness,
       .scenes = touching,
       .theories = true},
      {.name = "contact",
       .doc = "its layer, the polynomials and samples that carry it, its force over time, where the time goes; of "
              "eigenmodes, static correction and the study's linear and quadratic modes",
       .run = &contact,
       .scenes = touching,
       .timed = true},
      {.name = "contact-stability",
       .doc = "which steps in contact are stable, inaccurate and unstable over the layer's stiffness, beside what one "
              "linearised step predicts",
       .run = &contact_stability,
       .scenes = touching},
      {.name = "flight-cost",
       .doc = "cost of a modal run over flight time and over steps in contact",
       .run = &flight_cost,
       .scenes = touching,
       .timed = true},
      {.name = "amplitude",
       .doc = "the speed of an impact at which linear theory ends, by linear against finite kinematics",
       .run = &amplitude,
       .scenes = touching},
      {.name = "instructions",
       .doc = "instructions a simulated second, by valgrind, beside the time they take",
       .run = &instructions,
       .scenes = touching,
       .timed = true},
      {.name = "slenderness",
       .doc = "errors of polynomial modes by degree on bodies from compact to slender",
       .run = &polynomials_over_slenderness,
       .scenes = loaded}};
  return all;
}

const Analysis& analysis(const std::string& name) {
  const std::vector<Analysis>& all = analysis_catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Analysis& a) { return a.name == name; });
  if (found == all.end()) throw std::out_of_range("no analysis '" + name + "'");
  return *found;
}

}  // namespace mb
