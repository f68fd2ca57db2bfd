#include "harness/analysis/footings.h"

#include <algorithm>
#include <stdexcept>

namespace mb {

namespace {

struct Entry {
  const char* table;
  Footing footing;
};

const Footing truth{"the truth of the case, finer mesh", "converged numbers", "as the bars say"};
const Footing same_mesh{"the truth of the case on the same mesh", "second route", "as the bars say"};
const Footing time{"another contender on the same machine", "measurement", "the spread of repetitions"};
const Footing fitted{"the exponent of theory or of the claim", "property",
                     "the standard error of the fit, which knows nothing of a bend in the data"};
const Footing verdict{"the table before", "measurement", "that of the numbers it weighs"};
const Footing settings{"the same answer under another setting", "second route",
                       "differences of answers, each as the adaptive steps leave it"};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"budget", truth},
      {"budget-cross-terms", truth},
      {"step-limits",
       {"formulas of the schemes, mode by mode", "closed form",
        "bisection to 1e-9 of the step, residuals of the modes"}},
      {"step-limit-runs",
       {"growth rho^n of one step's amplification", "closed form", "rounding of n steps, below the 1 % asked for"}},
      {"step-limit-exponents", fitted},
      {"stability-map",
       {"spectral radius of one step", "property", "a class has none; steps are a quarter of a decade apart"}},
      {"stability-summary", {"spectral radius of one step", "property", "counts; of the order as the bars say"}},
      {"aliasing", same_mesh},
      {"aliasing-claim", same_mesh},
      {"aliasing-modes", {"|f - F round(f/F)|", "closed form", "residuals of the modes"}},
      {"frequency-response",
       {"the direct solution at each frequency, full order", "second route",
        "rounding times the condition near a resonance"}},
      {"frequency-response-error",
       {"the direct solution at each frequency, full order", "second route",
        "rounding times the condition near a resonance"}},
      {"frequency-response-peaks",
       {"none but what a check names", "measurement", "golden section to 1e-4 of the frequency, of this mesh"}},
      {"damping", {"the ratios that the scene asks for", "property", "rounding, for low modes times omega_max/omega"}},
      {"damping-of-steps", {"the eigenvalue of one step", "closed form", "rounding over a period"}},
      {"damping-coupling",
       {"adaptive steps of the same reduced system", "second route", "in column closed form against steps"}},
      {"damping-coupling-modes", {"none", "measurement", "rounding times the condition told beside"}},
      {"long-run",
       {"conservation of energy", "property", "rounding of sums over 1000 steps; of the exponent as the bars say"}},
      {"multiplets", {"a dense solver of the whole matrix", "second route", "rounding times omega_max/omega squared"}},
      {"multiplets-kept",
       {"a dense solver of the whole matrix", "second route", "rounding times omega_max/omega squared"}},
      {"aspect", {"adaptive steps of all unknowns", "second route", "rtol 1e-5 of the steps, times their number"}},
      {"locking",
       {"elements of degree 4 on the finer mesh, its cells halved", "converged numbers",
        "as the bars say: by the same degree on cells twice the size"}},
      {"locking-growth", {"no growth, which is 1", "property", "as the bars say"}},
      {"linearity", {"the truth of the case on the same mesh, of finite strain", "second route", "as the bars say"}},
      {"mode-amplitudes", {"none", "measurement", "rounding of closed forms"}},
      {"mode-amplitude-exponents", fitted},
      {"collision-cost", time},
      {"collision-cost-exponents", fitted},
      {"collision-cost-crossover", time},
      {"collision-cost-claim", verdict},
      {"contact-forces",
       {"the exact force of a rigid body on a layer", "closed form", "that of the exact force: column error of exact"}},
      {"contact-forces-orders", fitted},
      {"contact-forces-claim", verdict},
      {"contact-stiffness", settings},
      {"contacts-in-turn", truth},
      {"contact-conditions", settings},
      {"force-history",
       {"the truth of the case", "converged numbers", "that of the peak force in the table of errors"}},
      {"contact-time", time},
      {"contact-time-runs", time},
      {"contact-meetings", {"none", "measurement", "rounding of closed forms"}},
      {"contact-geometry", {"the modes of the mesh", "second route", "rounding times the condition told beside"}},
      {"contact-samples", settings},
      {"contact-stability",
       {"spectral radius of one linearised step", "property", "a class has none; steps as in the first column"}},
      {"contact-stability-summary",
       {"spectral radius of one linearised step; of errors the closed form at half the least step", "property",
        "counts; errors of order 1 are told half as large as they are, of order 2 by a quarter less; of the order as "
        "the bars say"}},
      {"flight-cost", time},
      {"flight-cost-exponents", fitted},
      {"amplitude", {"finite kinematics on the same mesh", "second route", "the tolerance of the adaptive steps"}},
      {"amplitude-limits",
       {"finite kinematics on the same mesh", "second route", "that of lines between the speeds tried"}},
      {"amplitude-exponents", fitted},
      {"frequencies", {"the frequencies that the case names", "published", "as the bars say: that of the reference"}},
      {"probe-extremes", {"none but what a check names", "measurement", "as the bars say"}},
      {"instructions", {"none", "measurement", "counts of valgrind, which repeat"}},
      {"slenderness",
       {"96 eigenmodes of the same mesh with static correction", "second route", "in column bar, by half as many"}}};
  return all;
}

}  // namespace

Footing footing_of(const std::string& table) {
  const auto found = std::ranges::find(entries(), table, &Entry::table);
  if (found == entries().end()) throw std::out_of_range("no footing is stated of table '" + table + "'");
  return found->footing;
}

}  // namespace mb
