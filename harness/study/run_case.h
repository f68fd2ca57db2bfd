// One case from scene to records: truths, then every contender and analysis, then the times that decide.
//
//   truths  ->  jobs (marks of contenders, tables of analyses)  ->  times, alone
//
// Jobs may be spread over processes and machines (Shard); times are taken when nothing else of ours runs.
#pragma once

#include "harness/study/grade.h"
#include "harness/study/plan.h"

namespace mb {

struct RunOptions {
  bool again = false;                 // run also what the store holds
  bool timed = true;                  // whether times are taken
  Shard shard;                        // which part of the jobs
  std::function<bool()> interrupted;  // asked between runs and truths; what is finished is kept
  std::optional<double> memory = {};  // [byte] that a job may take; nothing: what is there when it begins
  bool alone = true;                  // nothing else of ours runs meanwhile: else analyses that take times are left
  bool again_timed = false;           // run also those of them that the store holds
};

struct CaseOutcome {
  int n_run = 0, n_stored = 0;  // jobs computed now, found in the store
  int n_failed = 0;             // of both: a failure that is stored is one still
  bool interrupted = false;
};

// Records, trajectories, times and tables go to the store, one file each. A contender's failure is a record with a
// status, an analysis' failure a table whose note says so. A run past the limit of its step is
// "unstable", without a value or a trajectory (instability.h). Throws where the truth fails: one record, under the
// truth's own name, says so. What is estimated to take more memory than there is fails before it is allocated; whatever
// fails for want of memory is tried again by every later run.
CaseOutcome run_case(const std::shared_ptr<const Scene>& scene, const Catalogue& catalogue, const Store& store,
                     const RunOptions& options, const Progress& progress);

}  // namespace mb
