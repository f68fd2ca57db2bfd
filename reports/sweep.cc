#include "reports/sweep.h"

#include <algorithm>

namespace mb {
namespace {

std::tuple<std::string, std::string, std::string> key_of(const Run& run) {
  return {run.case_name, run.profile, run.contender.integrator};
}

}  // namespace

Sweeps full_order_sweeps(const std::vector<Run>& runs) {
  Sweeps sweeps;
  for (const Run& run : runs) {
    if (is_reduced(run.contender)) continue;
    Sweep& sweep = sweeps[key_of(run)];
    sweep.coarsest_accuracy = std::max(sweep.coarsest_accuracy, accuracy(run.contender));
    const bool fewer = sweep.fewest_unknowns == 0 || run.n_unknowns < sweep.fewest_unknowns;
    if (run.n_unknowns > 0 && fewer) sweep.fewest_unknowns = run.n_unknowns;
  }
  return sweeps;
}

std::string edge_of(const Sweeps& sweeps, const Run& run) {
  const Sweep& sweep = sweeps.at(key_of(run));
  const double own = accuracy(run.contender);
  std::string text;
  if (own > 0 && own >= sweep.coarsest_accuracy) {
    text = run.contender.settings.time_step > 0 ? "largest time step" : "largest tolerance";
  }
  const bool is_coarsest = run.n_unknowns > 0 && run.n_unknowns <= sweep.fewest_unknowns;
  if (is_coarsest) text += (text.empty() ? "" : ", ") + std::string("coarsest mesh");
  return text;
}

}  // namespace mb
