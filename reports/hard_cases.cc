#include "reports/hard_cases.h"

#include <algorithm>
#include <set>

#include "cases/contract/status.h"
#include "reports/warnings.h"
#include "reports/words.h"

namespace mb {
namespace {

struct Counts {
  long hold = 0, open = 0, fail = 0;
};

Counts checks_of(const Evaluation& evaluation, const Scene& scene) {
  Counts counts;
  for (const CheckResult& result : evaluation.checks) {
    if (result.case_name != scene.name || result.profile != scene.profile) continue;
    const bool open = result.measured && !result.decidable;
    (result.holds ? counts.hold : open ? counts.open : counts.fail) += 1;
  }
  return counts;
}

// Runs of the scene whose records have a status of that kind.
long runs_with(const Evaluation& evaluation, const Scene& scene, bool (*of)(const std::string& status)) {
  std::set<std::string> runs;
  for (const Record& record : evaluation.input.records)
    if (record.case_name == scene.name && record.profile == scene.profile && of(record.status)) runs.insert(record.run);
  return static_cast<long>(runs.size());
}

bool blew_up(const std::string& status) { return is_unstable(status) || status == "not_finite"; }
bool is_failed(const std::string& status) { return status != "ok" && !blew_up(status) && !is_undefined(status); }

std::string verdict_of(const Counts& checks) {
  if (checks.fail > 0) return "fails";
  if (checks.open > 0) return "open";
  return checks.hold > 0 ? "holds" : "not run";
}

}  // namespace

Sheet hard_cases_table(const Evaluation& evaluation) {
  Sheet table{.name = "hard-cases",
              .title = "Hard cases",
              .note =
                  "Cases that are there to break something. Verdict: of the case's own checks; `open` where an "
                  "error bar decides nothing. Unstable: runs past the limit of their step, which grew, or by theory "
                  "alone grow tenfold where there is anything to grow: found and named, no number of theirs is stored. "
                  "Warnings: of strain or rotation beyond linear theory and of steps in contact that gain more than a "
                  "tenth of the energy in play, told under the case; a check decides only on what it names. "
                  "A check that asks for an unstable run holds where growth is seen.",
              .columns = {},
              .rows = {},
              .n_keys = 0};
  table.columns = {{"case", ""},
                   {"profile", ""},
                   {"what is hard, and what must hold", ""},
                   {"checks that hold", ""},
                   {"unstable runs", "", Column::Kind::number},
                   {"failed runs", "", Column::Kind::number},
                   {"warnings", "", Column::Kind::number},
                   {"verdict", ""}};
  for (const Scene& scene : evaluation.input.scenes) {
    if (scene.hard.empty()) continue;
    const Counts checks = checks_of(evaluation, scene);
    table.rows.push_back(
        {text_cell(scene.name), text_cell(scene.profile), text_cell(scene.hard),
         text_cell(std::to_string(checks.hold) + " of " + std::to_string(checks.hold + checks.open + checks.fail)),
         count_cell(runs_with(evaluation, scene, &blew_up)), count_cell(runs_with(evaluation, scene, &is_failed)),
         count_cell(static_cast<long>(warnings(evaluation.input.records, scene).size())),
         text_cell(verdict_of(checks))});
  }
  return table;
}

}  // namespace mb
