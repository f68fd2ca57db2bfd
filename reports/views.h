// The tables of the report. Every one names case, profile and, where errors stand in it, the truth.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reports/content.h"
#include "reports/runs.h"
#include "reports/sheet.h"

namespace mb {

inline constexpr double error_target = 0.01;                          // [-] of the headline, tables and figures
inline constexpr double looser_target = 0.05;                         // [-] beside it, for what the bars leave open
inline constexpr const char* headline_metric = "displacement-error";  // M norm
inline const std::array<std::string, 3> norms = {"displacement-error", "strain-error", "surface-deviation"};
bool is_norm(const std::string& metric);  // one of these

// Everything that tables, figures and the page are made of; computed once.
struct Evaluation {
  ReportInput input;
  std::vector<Run> runs;
  std::vector<CheckResult> checks;
  std::vector<SpeedUp> speed_ups;  // by each of the norms, every truth
};
Evaluation evaluate(const ReportInput& input);

const Scene* scene_of(const Evaluation& evaluation, const std::string& case_name, const std::string& profile);
const Run* run_of(const Evaluation& evaluation, const Record& record);
// Of the first body that has one; solid, too, where the scene is unknown.
Theory theory_of(const Evaluation& evaluation, const std::string& case_name, const std::string& profile);
std::optional<double> simulated_seconds(const Evaluation& evaluation,
                                        const Run& run);  // [s]; none where the scene is unknown

std::string range_text(const SpeedUp& speed_up);  // "340 to 370", "single run"; "" where no rival

// "354 (340 to 370)", "0.9 (0.7 to 1.2), within noise", "12 (single run), perturbed", "none reached"
Cell ratio_cell(const SpeedUp& speed_up);
Cell margin_cell(const SpeedUp& speed_up);      // how much more exact the rival is: "2.9 (2.1 to 4)"; "" where none
Cell miss_ratio_cell(const SpeedUp& speed_up);  // speed-up over the near miss; "" where none

// Measures of a case without a number, for one reason.
struct Failure {
  std::string case_name, profile, reason;
  std::string contenders;  // "Q1 1x2, newmark, 7 runs from step 0.01 s to step 0.00016 s; eigenmodes, r = 8"
  int n_runs = 0;
  long n_measures = 0;
  bool undefined = false;  // the metric has no meaning there: the runs did not fail
};
std::vector<Failure> failures_of(const Evaluation& evaluation);

// "bar: box of 1 x 0.1 x 0.1 m; E = ...; fixed at x-min; undamped; mesh Q2 8x1x1. Loads: tip (step): 10 Pa on x-max."
std::string case_line(const Evaluation& evaluation, const Scene& scene);

// What the records say of the truths of a case themselves: "Of the truth finer: share of kinetic energy above 30 Hz:
// 7.5e-6 (cylinder)."
std::vector<std::string> truth_sentences(const Evaluation& evaluation, const Scene& scene);

Sheet checks_table(const Evaluation& evaluation);
Sheet reduced_table(const Evaluation& evaluation);     // error against r
Sheet rivals_table(const Evaluation& evaluation);      // full-order contenders
Sheet contenders_table(const Evaluation& evaluation);  // both, with speed-up: the page's table
Sheet speed_up_table(const Evaluation& evaluation, const std::vector<SpeedUp>& shown);
// Parts of offline and online times, and work counts. Where no run of a case has a rival, of its most exact one.
Sheet phases_table(const Evaluation& evaluation, const std::vector<SpeedUp>& shown);
Sheet probes_table(const Evaluation& evaluation);
Sheet failures_table(const Evaluation& evaluation);  // one row a reason
Sheet records_table(const Evaluation& evaluation);   // one row a record

}  // namespace mb
