// What a report is made of: the stored records and the scenes they belong to. Nothing is recomputed here but
// arithmetic on records (pivoting, speed-up at equal error, verdicts of checks).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cases/contract/finding.h"
#include "cases/contract/record.h"
#include "cases/scene/scene.h"
#include "reports/publish.h"

namespace mb {

struct ReportInput {
  std::vector<Record> records;
  std::vector<Finding> findings;
  std::vector<Scene> scenes;                       // with their checks and prose
  std::map<std::string, std::string> environment;  // commit, date, profile, processor, threads, blas, compiler
  std::map<std::string, std::string> metric_docs;  // metric name, also of the times -> its only definition
  std::vector<std::string> damaged = {};           // of the store, what is left out and why: "FILE: REASON"
};

// A check of a case with what was measured; where several bodies or probes answer it, one that fails before one that is
// not decidable before one that holds, and of those the one furthest outside its bound.
// A check names no integrator: runs in closed form answer it, or all where a method was not run in closed form.
struct CheckResult {
  std::string case_name, profile;
  Check check;
  double value = 0, error_bar = 0;
  bool has_bar = false;       // false: of the answer alone, or of a table that states its uncertainty in words
  std::string unit = {};      // of value, bar and bound; "-" or "" where it has none
  bool measured = false;      // false where no usable record answers it: `status` says what the record says, if any
  bool holds = false;         // measured, and within its bound by the error bar or more
  bool decidable = true;      // false: the bound lies within the error bar of the value
  std::string status = "ok";  // of the record, where one fails of that; "no record" where there is none
  Footing footing = {};       // of the table, where it is a check of one
};
// A check of a table: the row furthest from its bound; a cell that is no number leaves it unmeasured.
std::vector<CheckResult> check_results(const std::vector<Scene>& scenes, const std::vector<Record>& records,
                                       const std::vector<Finding>& findings = {});
std::string subject_of(const Check& check);  // "displacement-error", "table frequencies, column largest error, row 3"

// For one reduced run: the cheapest full-order contender whose error is at most the reduced run's, by the same metric.
// No interpolation between runs. Errors below their bar count as the bar. rival empty: none reached that error. The
// near miss is the most exact of the full-order contenders that are cheaper than the rival: all of them miss that
// error. Between these two neighbours of the sweep cost is expected to rise with accuracy; what a finer or wider sweep
// would find is not known. The headline compares at a target instead (speedup.h). Times of other machines than the one
// that took most of the case's are not compared.
struct SpeedUp {
  Record error, time;             // of the reduced run
  std::vector<Record> rival;      // {} or {error, time} of the cheapest full-order contender
  std::vector<Record> near_miss;  // {} or {error, time}; {} where no rival
  double ratio = 0;               // [-] rival time / time; 0 where no rival
  double miss_ratio = 0;          // [-] near miss's time / time; 0 where no near miss
  double ratio_low = 0;           // [-] by range_of both times (times.h); NaN where one is a single run's
  double ratio_high = 0;          // [-] likewise
  std::string edge = {};          // of its integrator's sweep where the rival stands: "largest time step"; "" inside
};
std::vector<SpeedUp> speed_ups(const std::vector<Record>& records, const std::string& metric);

// Whether the browser part was built into this library; without it write_report writes no report.html.
bool page_available();

// All files of a report, page included; publish puts them where they belong.
std::vector<ReportFile> report_files(const ReportInput& input);

// Writes report.md, data/*.csv, data/results.jsonl, tables/*.tex, figures/*.vl.json and, where the browser part was
// built, report.html below `directory`, in the place of a report that stands there (publish.h). Returns the files
// written. Throws std::runtime_error on a failed write: the report before is then left as it was.
std::vector<std::filesystem::path> write_report(const ReportInput& input, const std::filesystem::path& directory);

}  // namespace mb
