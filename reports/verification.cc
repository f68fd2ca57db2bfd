#include "reports/verification.h"

#include "reports/check_cells.h"
#include "reports/environment.h"
#include "reports/number.h"
#include "reports/render.h"
#include "reports/words.h"

namespace mb {
namespace {

using Kind = Column::Kind;

// What a check's number is held to.
std::string reference_of(const Check& check, const Scene* scene) {
  if (!check.table.empty()) return "what theory says, in the table " + check.table;
  if (!scene) return check.truth;
  if (check.truth == "exact") return "closed form " + scene->truth.exact;
  const std::string rtol = format_setting(scene->truth.relative_tolerance);
  if (check.truth == "finer")
    return "full order on " + to_string(scene->truth.finer) + ", adaptive steps at rtol " + rtol;
  return "full order on the same mesh, adaptive steps at rtol " + rtol + "/100";
}

std::string kind_of(const Check& check) {
  if (!check.table.empty()) return "analytical";
  return check.truth == "exact" ? "closed form" : check.truth == "finer" ? "converged numbers" : "second route";
}

std::string uncertainty_of(const CheckResult& result) {
  if (result.error_bar > 0) return format_number(result.error_bar, 2);
  return result.check.table.empty() ? "below the digits shown" : "none of its own";
}

}  // namespace

Sheet verification_table(const Evaluation& evaluation) {
  Sheet table{.name = "verification",
              .title = "Verification",
              .note =
                  "Every check of every case: what it is held to, how uncertain that is, the tolerance and why it "
                  "is that, and what came out. Uncertainty: in the unit of the result, of the truth's mesh and of "
                  "its steps (Richardson's distance between two of each); of closed forms that of their series.",
              .columns = {},
              .rows = {},
              .n_keys = 0};
  table.columns = {{"case", ""},      {"profile", ""}, {"what", ""},
                   {"reference", ""}, {"kind", ""},    {"uncertainty", ""},
                   {"tolerance", ""}, {"why", ""},     {"result", "", Kind::number},
                   {"verdict", ""}};
  for (const CheckResult& result : evaluation.checks) {
    const Check& check = result.check;
    const Scene* scene = scene_of(evaluation, result.case_name, result.profile);
    const std::string of = check.method.empty()
                               ? subject_of(check)
                               : joined({check.method, check.rotation, "r = " + std::to_string(check.modes)}, " ") +
                                     ": " + subject_of(check);
    table.rows.push_back({text_cell(result.case_name), text_cell(result.profile), text_cell(of),
                          text_cell(reference_of(check, scene)), text_cell(kind_of(check)),
                          text_cell(uncertainty_of(result)), text_cell(bound(check)), text_cell(check.why),
                          measured_cell(result), text_cell(verdict(result))});
  }
  return table;
}

std::string verification_document(const Evaluation& evaluation) {
  const Commit commit = main_commit(evaluation);
  const Sheet table = verification_table(evaluation);
  std::string text = "# Verification\n\n" + markdown_text(table.note) + "\n\n";
  text += "Made by `modalbench report` from stored results" +
          (commit.name.empty() ? std::string() : " of commit " + markdown_text(commit.name)) +
          "; nothing here was written by hand. Sources of the cases:\n\n";
  for (const Scene& scene : evaluation.input.scenes)
    text += "- **" + markdown_text(scene.name) + "**: " + markdown_text(scene.source) + "\n";
  return text + "\n" + markdown(table);
}

}  // namespace mb
