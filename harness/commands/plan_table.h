// What `run --plan` prints: the jobs asked for, and which of them the store makes unnecessary.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "harness/study/plan.h"

namespace mb {

struct PlannedJob {
  std::string case_name, profile;
  Job job;
  bool stored;  // nothing of it would be run
};

void print_plan_table(const std::vector<PlannedJob>& plan, std::ostream& out);

// One object. Settings that mean nothing to a contender, as the time step of an adaptive integrator, are null.
void print_plan_json(const std::vector<PlannedJob>& plan, const Catalogue& catalogue, std::ostream& out);

}  // namespace mb
