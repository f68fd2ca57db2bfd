#include <algorithm>
#include <stdexcept>

#include "harness/analysis/analyses.h"

namespace mb {

const std::vector<Analysis>& analysis_catalogue() {
  constexpr auto any = Analysis::Scenes::any, loaded = Analysis::Scenes::without_contact,
                 touching = Analysis::Scenes::with_contact;
  static const std::vector<Analysis> all{
      {"budget",
       "which part of an answer's error is due to the step, to truncation, to the mesh, to contact on its surface and "
       "to finite strain",
       &error_budget, any, false, true},
      {"step-limits", "largest stable steps of explicit schemes, by formula, by bisection and by runs", &step_limits,
       any, false, false, false, true},
      {"stability-map",
       "which steps of every integrator are stable, inaccurate and unstable over mode count and step, beside what one "
       "step's amplification predicts",
       &stability_map, loaded},
      {"aliasing", "what frames make of motion too fast for them, and what it takes to avoid it", &temporal_aliasing,
       loaded, false, true},
      {"frequency-response", "steady response at the first probe over frequency, full against reduced",
       &frequency_responses, loaded},
      {"mode-amplitudes", "how a mode's displacement falls with its frequency for fixed energy, force and impulse",
       &mode_amplitudes},
      {"damping",
       "damping ratios asked for and achieved, mode by mode, by the full and the reduced system and by the study's "
       "steps",
       &achieved_damping, loaded},
      {"damping-coupling", "what keeping the diagonal alone costs where damping couples modes", &coupled_damping,
       loaded},
      {"long-run",
       "energy over a million steps of free vibration, by every integrator of fixed step and in closed form", &long_run,
       loaded},
      {"multiplets", "modes by two solvers, multiplet by multiplet", &multiplets},
      {"aspect", "modes and steps of a box from compact to 200 times as long as thick", &aspect, loaded},
      {"locking", "static answers and first frequencies by degree of the elements as Poisson's ratio nears 1/2",
       &locking, loaded},
      {"linearity", "how far linear theory is off: estimated by a perturbation series, measured against finite strain",
       &linearity, loaded, false, true},
      {"frequencies", "natural frequencies against published ones, with observed order", &natural_frequencies},
      {"probe-extremes", "largest and smallest probe values, when, and the static ones", &probe_extremes, loaded, false,
       true},
      {"collision-cost", "cost of points against polygons, a tree of boxes over them and an analytic shape",
       &collision_cost, any, false, false, true},
      {"contact-forces", "errors of contact forces from vertices, quadratures and curvatures", &contact_forces},
      {"contact-stiffness",
       "what halving and doubling the stiffness of the contact layer does, and how a hundredth of it grows from "
       "contact "
       "to contact",
       &contact_stiffness, touching, true},
      {"contact",
       "its layer, the polynomials and samples that carry it, its force over time, where the time goes; of eigenmodes, "
       "static correction and the study's linear and quadratic modes",
       &contact, touching, false, false, true},
      {"contact-stability",
       "which steps in contact are stable, inaccurate and unstable over the layer's stiffness, beside what one "
       "linearised step predicts",
       &contact_stability, touching},
      {"flight-cost", "cost of a modal run over flight time and over steps in contact", &flight_cost, touching, false,
       false, true},
      {"amplitude", "the speed of an impact at which linear theory ends, by linear against finite kinematics",
       &amplitude, touching},
      {"instructions", "instructions a simulated second, by valgrind, beside the time they take", &instructions,
       touching, false, false, true},
      {"slenderness", "errors of polynomial modes by degree on bodies from compact to slender",
       &polynomials_over_slenderness, loaded}};
  return all;
}

const Analysis& analysis(const std::string& name) {
  const std::vector<Analysis>& all = analysis_catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Analysis& a) { return a.name == name; });
  if (found == all.end()) throw std::out_of_range("no analysis '" + name + "'");
  return *found;
}

}  // namespace mb
