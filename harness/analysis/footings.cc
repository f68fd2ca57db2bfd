#include "harness/analysis/footings.h"

#include <algorithm>
#include <stdexcept>

namespace mb {

namespace {

struct Entry {
  const char* table;
  Footing footing;
};

struct TablesOfAnalysis {
  const char* analysis;
  std::vector<Entry> tables;
};

const Footing truth{"the truth of the case, finer mesh", "converged numbers", "as the bars say"};
const Footing best{"the truth of the case: its closed form, or the finer mesh", "converged numbers", "as the bars say"};
const Footing same_mesh{"the truth of the case on the same mesh", "second route", "as the bars say"};
const Footing time{"another contender on the same machine", "measurement", "the spread of repetitions"};
const Footing fitted{"the exponent of theory or of the claim", "property",
                     "the standard error of the fit, which knows nothing of a bend in the data"};
const Footing verdict{"the table before", "measurement", "that of the numbers it weighs"};
const Footing settings{"the same answer under another setting", "second route",
                       "as the bars say: what coarser steps move"};
const Footing contact_map{"spectral radius of one linearised step; work of a layer that opens", "property",
                          "a class has none; of errors as the bars say"};
const Footing contact_summary{
    "spectral radius of one linearised step; work of a layer that opens; of errors kicks at a quarter of the least "
    "step",
    "property",
    "counts are exact; of errors and of the order as the bars say; steps unstable from are halves of each other"};

const std::vector<TablesOfAnalysis>& entries() {
  static const std::vector<TablesOfAnalysis> all{
      {"budget", {{"budget", best}, {"budget-cross-terms", best}}},
      {"step-limits",
       {{"step-limits",
         {"formulas of the schemes, mode by mode", "closed form",
          "as the bars say: bisection to 1e-9 of the step; of modes that of the mesh"}},
        {"step-limit-runs",
         {"growth rho^n of one step's amplification", "closed form",
          "as the bars say: rounding of n steps; of the mesh itself also what other modes leave"}},
        {"step-limit-summary", {"growth rho^n of one step's amplification", "closed form", "counts are exact"}},
        {"step-limit-exponents", fitted}}},
      {"stability-map",
       {{"stability-map",
         {"spectral radius of one step", "property",
          "a class has none; steps are a quarter of a decade apart; as the bars say: of errors the study's "
          "load_tolerance, of energies rounding"}},
        {"stability-summary",
         {"spectral radius of one step, energy by theory, the closed form", "property",
          "counts are exact; energies as the bars say, of orders the standard error of the line"}}}},
      {"aliasing",
       {{"aliasing", same_mesh},
        {"aliasing-claim", same_mesh},
        {"aliasing-modes", {"|f - F round(f/F)|", "closed form", "as the bars say: that of the mesh"}}}},
      {"frequency-response",
       {{"frequency-response",
         {"the direct solution at each frequency, full order", "second route",
          "as the bars say: that of the mesh; rounding times the condition near a resonance"}},
        {"frequency-response-error",
         {"the direct solution at each frequency, full order", "second route",
          "as the bars say: that of the mesh; rounding times the condition near a resonance"}},
        {"frequency-response-peaks",
         {"none but what a check names", "measurement",
          "that of the mesh as the bars say; golden section to 1e-4 of the frequency"}}}},
      {"damping",
       {{"damping",
         {"the ratios that the scene asks for", "property",
          "as the bars say: that of the mesh; of achieved from asked rounding, for low modes times omega_max/omega"}},
        {"damping-of-steps",
         {"the eigenvalue of one step", "closed form",
          "as the bars say: that of the mesh; of run from scheme rounding over a period"}}}},
      {"damping-coupling",
       {{"damping-coupling",
         {"adaptive steps of the same reduced system", "second route",
          "as the bars say: that of the mesh; in column closed form against steps"}},
        {"damping-coupling-modes",
         {"none but what a check names", "measurement",
          "as the bars say: that of the mesh; rounding times the condition told beside"}}}},
      {"long-run",
       {{"long-run",
         {"conservation of energy", "property",
          "as the bars say: of the drift that of its windows and rounding, of the exponent that of its fit; of "
          "the swing rounding"}}}},
      {"multiplets",
       {{"multiplets",
         {"a dense solver of the whole matrix", "second route",
          "as the bars say: that of the mesh; rounding times omega_max/omega squared; of distances that of sums"}},
        {"multiplets-kept",
         {"a dense solver of the whole matrix", "second route", "rounding times omega_max/omega squared"}},
        {"multiplets-answers",
         {"the same motion in modes of the dense solver", "second route", "as the bars say: rounding of sums"}}}},
      {"aspect",
       {{"aspect",
         {"adaptive steps of all unknowns; energies by theory", "second route",
          "as the bars say; of energies the rounding of 1000 steps"}}}},
      {"locking",
       {{"locking",
         {"elements of degree 4 on half as many cells again as the finer mesh's", "converged numbers",
          "as the bars say: by the same degree on cells twice the size"}},
        {"locking-dynamics",
         {"adaptive steps of all unknowns; energy at the start", "second route",
          "as the bars say; rounding of 1000 steps"}},
        {"locking-growth",
         {"elements of degree 4 on half as many cells again as the finer mesh's; of growth none, which is 1",
          "converged numbers", "as the bars say"}}}},
      {"linearity",
       {{"linearity",
         {"the truth of the case on the same mesh, of finite strain", "second route", "as the bars say"}}}},
      {"mode-amplitudes",
       {{"mode-amplitudes", {"none", "measurement", "as the bars say: that of the mesh"}},
        {"mode-amplitude-exponents", fitted}}},
      {"collision-cost",
       {{"collision-cost", time},
        {"collision-cost-exponents", fitted},
        {"collision-cost-crossover", time},
        {"collision-cost-claim", verdict}}},
      {"contact-forces",
       {{"contact-forces",
         {"the exact force of a rigid body on a layer", "closed form", "as the bars say: that of the exact force"}},
        {"contact-forces-orders", fitted},
        {"contact-forces-claim", verdict}}},
      {"contact-stiffness",
       {{"contact-stiffness", settings}, {"contacts-in-turn", best}, {"contact-conditions", settings}}},
      {"contact",
       {{"force-history",
         {"the truth of the case", "converged numbers", "of the truth as the bars say; of modes that of their steps"}},
        {"contact-time", time},
        {"contact-time-runs", time},
        {"contact-meetings", {"none", "measurement", "as the bars say; else rounding of closed forms"}},
        {"contact-geometry", {"the modes of the mesh", "second route", "rounding times the condition told beside"}},
        {"contact-samples", {"the finest samples; the truth of the case", "second route", "as the bars say"}}}},
      {"contact-stability",
       {{"contact-stability", contact_map},
        {"contact-stability-summary", contact_summary},
        {"corrected-stability", contact_map},
        {"corrected-stability-summary", contact_summary}}},
      {"flight-cost", {{"flight-cost", time}, {"flight-cost-exponents", fitted}}},
      {"amplitude",
       {{"amplitude",
         {"finite kinematics on the same mesh", "second route", "as the bars say: what coarser steps move"}},
        {"amplitude-limits",
         {"finite kinematics on the same mesh", "second route", "that of lines between the speeds tried"}},
        {"amplitude-exponents", fitted}}},
      {"frequencies",
       {{"frequencies",
         {"the frequencies that the case names", "published",
          "as the bars say: of errors that of the reference, of frequencies that of the mesh"}}}},
      {"probe-extremes", {{"probe-extremes", {"none but what a check names", "measurement", "as the bars say"}}}},
      {"instructions", {{"instructions", {"none", "measurement", "counts of valgrind, which repeat"}}}},
      {"slenderness",
       {{"slenderness",
         {"96 eigenmodes of the same mesh with static correction", "second route",
          "as the bars say: of errors by half as many, of static ones and frequencies rounding"}}}}};
  return all;
}

}  // namespace

Footing footing_of(const Finding& table) {
  for (const auto& [analysis, tables] : entries()) {
    const auto found = std::ranges::find(tables, table.name, &Entry::table);
    if (found != tables.end() && table.analysis == analysis) return found->footing;
  }
  throw std::out_of_range("no footing is stated of table '" + table.name + "' of analysis '" + table.analysis + "'");
}

std::map<std::string, std::string> analyses_of_tables() {
  std::map<std::string, std::string> all;
  for (const auto& [analysis, tables] : entries()) {
    for (const Entry& entry : tables) all.emplace(entry.table, analysis);
  }
  return all;
}

}  // namespace mb
