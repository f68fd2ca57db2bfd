// What the store holds of a job. "Stored" means the same everywhere: the file is there, every line of it is sound, and
// it says something of the job: not that there was no memory for it. Anything else is computed again. And how failures
// are stored, which no run forgets.
#pragma once

#include <string>
#include <vector>

#include "harness/store/store.h"
#include "harness/study/plan.h"

namespace mb {

// Neither a number, nor a result with a name of its own (unstable, undefined): the run gave no answer.
bool is_failure(const Record& record);
// The record that stands for all results of a case whose truth failed, under the name of the truth `finer`.
Record failed_truth(const Scene& scene, const std::string& reason);
// The table that stands for those of an analysis that failed.
bool is_failure(const Finding& finding);
Finding failed_table(const std::string& analysis, const std::string& reason);

// Sets whose findings they are: the job's, of that case and profile, made by this build.
void sign(std::vector<Finding>& findings, const Scene& scene, const std::string& job);

// Whether sound records stand under that name, none of which says that it failed.
bool holds_answers(const Store& store, const std::string& run);

struct StoredJob {
  bool has_result = false;           // marks of a contender, or tables of an analysis
  bool has_times = false;            // they are there, or there is nothing whose time could be taken
  bool failed = false;               // the result is that it failed
  std::vector<Record> marks;         // of a contender
  std::vector<RefusedLine> damaged;  // why it is not stored although there are files
  bool is_sound() const { return has_result && !failed; }
  bool is_complete(bool timed) const { return has_result && (has_times || !timed); }
};
StoredJob stored(const Job& job, const Store& store);

// What was found is written, but never over what another process has found meanwhile: the store is looked at and
// written under one lock. A failure and the truth's own marks give way to any answer; marks give way to sound ones,
// whose times then stay, unless they are to replace what is there; tables give way to none.
void keep_unless_answered(const Store& store, const std::string& run, const std::vector<Record>& records);
void keep_marks(const Store& store, const Job& job, const std::vector<Record>& marks, bool replace);
void keep_tables(const Store& store, const Job& job, const std::vector<Finding>& tables);

}  // namespace mb
