// Which full-order contenders were run, and whether a rival stands at the edge of them: beyond it a cheaper one might
// have done. Failed and unstable runs count: they were tried.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "reports/runs.h"

namespace mb {

struct Sweep {
  double coarsest_accuracy = 0;  // [s] largest time step, or [-] largest tolerance
  long fewest_unknowns = 0;      // degrees of freedom of the coarsest mesh; 0 where none was recorded
};
using Sweeps = std::map<std::tuple<std::string, std::string, std::string>, Sweep>;  // by case, profile, integrator
Sweeps full_order_sweeps(const std::vector<Run>& runs);

// "largest time step", "largest tolerance", "coarsest mesh", two of them; "" inside. The run is one of the sweeps.
std::string edge_of(const Sweeps& sweeps, const Run& run);

}  // namespace mb
