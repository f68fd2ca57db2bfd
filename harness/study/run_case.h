// One case from scene to records: truths, then every contender, then the times that decide.
#pragma once

#include "harness/study/grade.h"
#include "harness/study/plan.h"

namespace mb {

struct RunOptions {
  bool again = false;                 // run also what the store holds
  std::function<bool()> interrupted;  // asked between runs; what is finished is kept
};

struct CaseOutcome {
  int n_run = 0, n_stored = 0, n_failed = 0;  // contenders computed now, found in the store, failed
  bool interrupted = false;
};

// Records and trajectories go to the store, one file a run. Throws where the truth fails; a contender's failure is a
// record with a status. Timed parts run alone: nothing else is started here while they do.
CaseOutcome run_case(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue, const Store& store,
                     const RunOptions& options, const Progress& progress);

}  // namespace mb
