#include "reports/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/check_cells.h"
#include "reports/environment.h"
#include "reports/number.h"
#include "reports/render.h"
#include "reports/unbarred.h"
#include "reports/words.h"

namespace mb {
namespace {

using Kind = Column::Kind;

// What a check's number is held to.
std::string reference_of(const CheckResult& result, const Scene* scene) {
  const Check& check = result.check;
  if (!check.table.empty()) return result.footing.reference;
  if (!check.status.empty()) return "growth past the limit of the scheme";
  if (!scene) return check.truth;
  if (check.truth == "exact") return "closed form " + scene->truth.exact;
  const std::string rtol = format_setting(scene->truth.relative_tolerance);
  if (check.truth == "same_modes") return "closed form of the same modes";
  if (check.truth == "finer")
    return "full order on " + to_string(scene->truth.finer) + ", adaptive steps at rtol " + rtol;
  return "full order on the same mesh, adaptive steps at rtol " + rtol + "/100";
}

std::string kind_of(const CheckResult& result) {
  const Check& check = result.check;
  if (!check.table.empty()) return result.footing.kind;
  if (!check.status.empty()) return "property";
  return check.truth == "exact" || check.truth == "same_modes" ? "closed form"
         : check.truth == "finer"                              ? "converged numbers"
                                                               : "second route";
}

std::string uncertainty_of(const CheckResult& result) {
  if (std::isinf(result.error_bar)) return "unknown";
  if (result.error_bar > 0) return format_number(result.error_bar, 2);
  if (!result.check.status.empty()) return "none: how a run ends is no number";
  if (result.has_bar) return "below the digits shown";
  if (result.check.table.empty()) return "none: of the answer alone";
  return result.unit.empty() ? "none: counts are exact" : result.footing.uncertainty;  // "-" has one without a unit
}

// [-] Value and bar over a bound from above, of runs.
double share_of_limit(const CheckResult& result) {
  if (!result.measured || !std::isfinite(result.error_bar) || result.check.method.empty() ||
      !(result.check.at_most.value_or(0) > 0))
    return 0;
  return (result.value + result.error_bar) / *result.check.at_most;
}

struct Counted {
  long n = 0, n_hold = 0;
  double share = 0;
  std::string closest = {};  // the check of that share

  void add(const CheckResult& result) {
    ++n;
    n_hold += result.holds && result.decidable;
    if (share_of_limit(result) > share) share = share_of_limit(result), closest = checked(result.check);
  }
};

// By case, its profiles together.
Sheet cases_table(const Evaluation& evaluation) {
  Sheet table{.name = "cases", .title = "Cases", .note = {}, .columns = {}, .rows = {}, .n_keys = 0};
  table.columns = {{"case", ""},
                   {"checks", "", Kind::number},
                   {"hold", "", Kind::number},
                   {"of runs closest to its limit", ""},
                   {"with its bar, of the limit", "%", Kind::number},
                   {"source", ""}};
  std::map<std::string, Counted> cases;
  for (const CheckResult& result : evaluation.checks) cases[result.case_name].add(result);
  std::map<std::string, std::string> sources;
  for (const Scene& scene : evaluation.input.scenes) sources.emplace(scene.name, scene.source);
  for (const auto& [name, seen] : cases)
    table.rows.push_back({text_cell(name), count_cell(seen.n), count_cell(seen.n_hold), text_cell(seen.closest),
                          seen.share > 0 ? number_cell(100 * seen.share) : text_cell(""), text_cell(sources[name])});
  return table;
}

std::string unit_of(const CheckResult& result) { return result.unit == "-" ? "" : result.unit; }

}  // namespace

std::string checked(const Check& check) {
  if (check.method.empty()) return subject_of(check);
  return runs_of(check) + ": " + subject_of(check);
}

Sheet verification_table(const Evaluation& evaluation) {
  Sheet table{
      .name = "verification",
      .title = "Verification",
      .note =
          "Every check of the cases that were run: what it is held to, how uncertain that is, the tolerance and why "
          "it is that, and what came out. Uncertainty: in the unit of the result; of truths in full order 5/4 "
          "max(1, 1/(q - 1)) of the distance between two meshes, a quarter more than Richardson's estimate, and that "
          "between two tolerances. q = r^p of meshes whose cells are r times smaller, ((n + 1)/n)^2p where the degree "
          "goes from n to n + 1 instead (Babuska and Suri 1987); p is the least order that errors may have: of strain "
          "in the norm of energy and of what is largest over a body 0.71 at a clamp for Poisson's ratio 0.3, 0.59 for "
          "1/2 (Williams 1952), 1 where loads and contacts end, and twice that of displacement in the mean and of "
          "frequency. Tests hold it to a third mesh in held and free bodies of small strain and in one that falls on a "
          "floor; "
          "not with friction, of two bodies or of finite strain. Numbers of one place and largest values are known no "
          "better than "
          "twice the whole motion is. Where only the cells about a contact are halved, the distance is that part's: "
          "what both meshes lack of the mass is added, and where there is a closed form the distance to that is the "
          "least. Of "
          "relative errors e all that times 1 + e. Of closed forms the uncertainty is that of their series. A check "
          "holds only where every value within it is inside the tolerance.",
      .columns = {},
      .rows = {},
      .n_keys = 0};
  table.columns = {{"case", ""},   {"profile", ""},     {"what", ""},      {"unit", ""}, {"reference", ""},
                   {"kind", ""},   {"uncertainty", ""}, {"tolerance", ""}, {"why", ""},  {"result", "", Kind::number},
                   {"verdict", ""}};
  for (const CheckResult& result : evaluation.checks) {
    const Scene* scene = scene_of(evaluation, result.case_name, result.profile);
    table.rows.push_back({text_cell(result.case_name), text_cell(result.profile), text_cell(checked(result.check)),
                          text_cell(unit_of(result)), text_cell(reference_of(result, scene)),
                          text_cell(kind_of(result)), text_cell(uncertainty_of(result)), text_cell(bound(result.check)),
                          text_cell(result.check.why), measured_cell(result), text_cell(verdict(result))});
  }
  return table;
}

std::string verification_document(const Evaluation& evaluation) {
  const std::string commits = commits_of(evaluation);
  const Sheet table = verification_table(evaluation),
              unbarred = unbarred_columns(evaluation.input.findings, evaluation.input.records);
  std::string text = "# Verification\n\n" + markdown_text(table.note) + "\n\n";
  text += "Made by `modalbench report` from stored results" +
          (commits.empty() ? std::string() : " of " + markdown_text(commits)) +
          "; nothing here was written by hand.\n\n";
  const auto n_hold = std::ranges::count_if(evaluation.checks, [](const auto& c) { return c.holds && c.decidable; });
  text += fmt::format("{} of {} checks hold.\n\n", n_hold, evaluation.checks.size());
  return text + markdown(cases_table(evaluation)) + "\n## Check by check\n\n" + markdown(table) +
         "\n## Numbers without a bar\n\n" + unbarred.note + "\n\n" + markdown(unbarred);
}

}  // namespace mb
