#include "harness/study/stored.h"

#include <algorithm>
#include <limits>

#include "cases/contract/status.h"
#include "cases/scene/printable.h"
#include "harness/provenance.h"
#include "harness/store/file.h"
#include "harness/study/identity.h"
#include "harness/study/memory.h"
#include "reports/runs.h"

namespace mb {

namespace {

constexpr const char* failure = "failure";  // the one column of such a table
constexpr std::size_t most_reason = 1000;   // [bytes] a table with longer texts would not be written

StoredJob stored_tables(const Job& job, const Store& store) {
  StoredJob found;
  found.has_times = true;  // an analysis takes its own
  if (!store.has_findings(job.hash)) return found;
  Store::Findings tables = store.read_findings_of(job.hash);
  found.has_result = tables.refused.empty() && std::ranges::none_of(tables.findings, [](const Finding& f) {
                       return is_failure(f) && is_shortage(f.note);
                     });
  found.failed = std::ranges::any_of(tables.findings, [](const Finding& f) { return is_failure(f); });
  found.damaged = std::move(tables.refused);
  return found;
}

// What left an answer left its motion (run_case.cc).
bool is_answer(const std::vector<Record>& marks) {
  return !marks.empty() &&
         std::ranges::all_of(marks, [](const Record& r) { return r.status == "ok" || is_undefined(r.status); });
}

// What is wrong with the motion of a run, if anything is: all of it is read.
std::optional<RefusedLine> damage_of_motion(const std::string& run, const Store& store) try {
  store.read_trajectory(run);
  return {};
} catch (const StoreError& error) {
  return RefusedLine{error.file(), 0, error.fault()};
}

// Where a contender is the truth itself, what stands under its name may be what the truth contains and no mark of it.
StoredJob stored_marks(const Job& job, const Store& store) {
  StoredJob found;
  if (!store.has_records(job.hash)) return found;
  RecordLines marks = store.read_records_of(job.hash);
  const bool has_motion = store.has_trajectory(job.hash);
  const auto damaged = has_motion ? damage_of_motion(job.hash, store) : std::nullopt;
  if (damaged) found.damaged.push_back(*damaged);
  found.has_result =
      marks.refused.empty() && !damaged && !std::ranges::all_of(marks.records, is_of_truth) &&
      (has_motion || !is_answer(marks.records)) &&
      std::ranges::none_of(marks.records, [](const Record& r) { return is_failure(r) && is_shortage(r.status); });
  found.failed = std::ranges::any_of(marks.records, [](const Record& r) { return is_failure(r); });
  std::ranges::move(marks.refused, std::back_inserter(found.damaged));
  found.has_times = std::ranges::none_of(marks.records, [](const Record& r) { return r.status == "ok"; });
  found.marks = std::move(marks.records);
  if (found.has_times || !store.has_times(job.hash)) return found;
  RecordLines times = store.read_times_of(job.hash);
  found.has_times = times.refused.empty() && !times.records.empty();
  std::ranges::move(times.refused, std::back_inserter(found.damaged));
  return found;
}

}  // namespace

bool is_failure(const Record& record) {
  return record.status != "ok" && !is_unstable(record.status) && !is_undefined(record.status);
}

Record failed_truth(const Scene& scene, const std::string& reason) {
  Record record;
  record.contender = truth_contenders(scene).front();
  record.run = run_hash(scene, record.contender);
  record.case_name = scene.name;
  record.profile = scene.profile;
  record.metric = "truth-above-band";
  record.truth = to_string(TruthKind::finer);
  record.unit = "-";
  record.value = std::numeric_limits<double>::quiet_NaN();
  record.status = "failed: " + reason;
  record.provenance = provenance(scene.profile);
  return record;
}

bool holds_answers(const Store& store, const std::string& run) {
  if (!store.has_records(run)) return false;
  const RecordLines lines = store.read_records_of(run);
  return lines.refused.empty() && std::ranges::none_of(lines.records, [](const Record& r) { return is_failure(r); });
}

void sign(std::vector<Finding>& findings, const Scene& scene, const std::string& job) {
  for (Finding& finding : findings) {
    finding.run = job;
    finding.case_name = scene.name;
    finding.profile = scene.profile;
    finding.provenance = provenance(scene.profile);
  }
}

bool is_failure(const Finding& finding) { return finding.columns.size() == 1 && finding.columns[0].name == failure; }

Finding failed_table(const std::string& analysis, const std::string& reason) {
  Finding table;
  table.analysis = table.name = table.title = analysis;
  table.columns = {{failure, ""}};
  table.rows = {{one_line(reason, most_reason)}};
  table.note = "failed: " + one_line(reason, most_reason);
  return table;
}

StoredJob stored(const Job& job, const Store& store) {
  return job.kind == Job::Kind::analysis ? stored_tables(job, store) : stored_marks(job, store);
}

void keep_unless_answered(const Store& store, const std::string& run, const std::vector<Record>& records) {
  const FolderLock lock(store.directory());
  if (!holds_answers(store, run)) store.write_records(run, records);
}

void keep_marks(const Store& store, const Job& job, const std::vector<Record>& marks, bool replace) {
  const FolderLock lock(store.directory());
  if (replace || !stored(job, store).is_sound()) store.write_records(job.hash, marks);
}

void keep_tables(const Store& store, const Job& job, const std::vector<Finding>& tables) {
  const FolderLock lock(store.directory());
  const bool failed = std::ranges::any_of(tables, [](const Finding& f) { return is_failure(f); });
  if (!failed || !stored(job, store).is_sound()) store.write_findings(job.hash, tables);
}

}  // namespace mb
