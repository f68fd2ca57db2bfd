// A check holds where every value within the error bar satisfies the bound, and fails where none does:
//
//   at_most:  value + bar <= bound holds,  value - bar > bound fails,  between them it is not decidable
//
// One of how runs end holds where every mark of all of them has that status.
#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "cases/scene/nearest.h"
#include "cases/scene/printable.h"
#include "reports/content.h"
#include "reports/findings.h"
#include "reports/number.h"
#include "reports/runs.h"

namespace mb {
namespace {

double bound(const Check& check) { return check.at_most ? *check.at_most : check.at_least.value_or(0); }

// [unit of the metric] how far inside its bound a value lies; negative: outside.
double margin(const Check& check, double value) { return check.at_most ? bound(check) - value : value - bound(check); }

CheckResult blank(const Scene& scene, const Check& check, const std::string& status) {
  CheckResult result{.case_name = scene.name, .profile = scene.profile, .check = check};
  result.status = status;
  return result;
}

CheckResult decided(const Scene& scene, const Check& check, double value, double error_bar) {
  CheckResult result = blank(scene, check, "ok");
  result.measured = true;
  result.value = value;
  result.error_bar = error_bar;
  const double inside = margin(check, value);
  result.holds = inside >= error_bar;
  result.decidable = result.holds || inside < -error_bar;
  return result;
}

// Of several answers one that fails counts before one that is not decidable, and that before one that holds.
bool is_worse(const CheckResult& a, const CheckResult& b) {
  const auto rank = [](const CheckResult& r) { return std::tuple(r.holds, !r.decidable, margin(r.check, r.value)); };
  return !b.measured || rank(a) < rank(b);
}

CheckResult judge(const Scene& scene, const Check& check, const std::vector<const Record*>& answers) {
  CheckResult worst = blank(scene, check, "no record");
  for (const Record* answer : answers) {
    if (!is_usable(*answer)) return blank(scene, check, reason(*answer));  // one failed part fails the whole check
    CheckResult one = decided(scene, check, answer->value, answer->error_bar.value_or(0));
    one.has_bar = answer->error_bar.has_value();
    one.unit = answer->unit;
    if (is_worse(one, worst)) worst = std::move(one);
  }
  return worst;
}

CheckResult ended(const Scene& scene, const Check& check, const std::vector<std::string>& statuses) {
  CheckResult result = blank(scene, check, "no record");
  for (const std::string& status : statuses) {
    result.holds = status == check.status;
    result.status = status;
    result.measured = true;
    if (!result.holds) break;
  }
  return result;
}

std::vector<std::string> statuses_of(const std::vector<const Record*>& answers) {
  std::vector<std::string> all;
  for (const Record* answer : answers) all.push_back(answer->status);
  return all;
}

// Rows are asked for by their first cell: a text, or a number as a person writes it.
bool is_asked(const Check& check, const FindingCell& first) {
  if (check.row.empty()) return true;
  if (const auto* text = std::get_if<std::string>(&first)) return *text == check.row;
  return format_setting(std::get<double>(first)) == check.row;
}

std::string no_column(const Finding& finding, const std::string& column) {
  std::vector<std::string> known;
  for (const FindingColumn& one : finding.columns) known.push_back(one.name);
  const auto meant = nearest(column, known);
  return fmt::format("no column '{}'{}", column, meant ? ": did you mean '" + *meant + "'?" : "");
}

Footing footing_of(const Finding& finding, const Check& check) {
  if (check.reference.empty()) return finding.footing;
  return {check.reference, check.kind, finding.footing.uncertainty};
}

CheckResult judge(const Scene& scene, const Check& check, const std::vector<Finding>& findings) {
  CheckResult worst = blank(scene, check, "no record");
  for (const Finding& finding : findings) {
    const bool own = finding.case_name == scene.name && finding.profile == scene.profile && finding.name == check.table;
    if (!own) continue;
    const auto column = column_of(finding, check.column);
    if (!column) return blank(scene, check, no_column(finding, check.column));
    for (std::size_t i = 0; i < finding.rows.size(); ++i) {
      if (finding.rows[i].empty() || !is_asked(check, finding.rows[i][0])) continue;
      if (!check.status.empty()) {
        worst = ended(scene, check, {text_at(finding, i, check.column)});
        worst.footing = footing_of(finding, check);
        if (!worst.holds) return worst;
        continue;
      }
      const double value = number_at(finding, i, check.column);
      if (std::isnan(value)) return blank(scene, check, "not a number in row " + std::to_string(i + 1));
      const double bar = bar_at(finding, i, *column);
      CheckResult one = decided(scene, check, value, bar > 0 ? bar : 0);
      one.has_bar = !std::isnan(bar);
      one.unit = finding.columns[*column].unit;
      one.footing = footing_of(finding, check);
      if (is_worse(one, worst)) worst = std::move(one);
    }
  }
  return worst;
}

// Of a reduced method without an integrator the closed form, and no run with steps in its place.
std::vector<const Run*> runs_asked(const Scene& scene, const Check& check, const std::vector<Run>& runs) {
  const bool of_steps = !check.integrator.empty() || check.method == "full-order";
  std::vector<const Run*> all;
  for (const Run& run : runs) {
    const Contender& c = run.contender;
    const bool asked = run.case_name == scene.name && run.profile == scene.profile && c.method == check.method &&
                       c.settings.modes == check.modes &&
                       (check.rotation.empty() || check.rotation == to_string(c.settings.rotation)) &&
                       (check.integrator.empty() || check.integrator == c.integrator) &&
                       (!check.time_step || *check.time_step == c.settings.time_step);
    if (asked && (of_steps || c.integrator == "exact")) all.push_back(&run);
  }
  return all;
}

std::vector<const Record*> marks_asked(const Check& check, const Run& run) {
  std::vector<const Record*> marks;
  for (const auto& [measure, record] : run.measures) {
    const bool asked = check.status.empty() ? measure.metric == check.metric && measure.truth == check.truth
                                            : is_mark(record) && !is_undefined(record);
    if (asked) marks.push_back(&record);
  }
  return marks;
}

}  // namespace

std::vector<CheckResult> check_results(const std::vector<Scene>& scenes, const std::vector<Record>& records,
                                       const std::vector<Finding>& findings) {
  const std::vector<Run> runs = group_runs(records);
  std::vector<CheckResult> results;
  for (const Scene& scene : scenes) {
    for (const Check& check : scene.checks) {
      if (!check.table.empty()) {
        results.push_back(judge(scene, check, findings));
        continue;
      }
      std::vector<const Record*> answers;
      for (const Run* run : runs_asked(scene, check, runs)) {
        const std::vector<const Record*> marks = marks_asked(check, *run);
        answers.insert(answers.end(), marks.begin(), marks.end());
      }
      results.push_back(check.status.empty() ? judge(scene, check, answers)
                                             : ended(scene, check, statuses_of(answers)));
    }
  }
  return results;
}

std::string subject_of(const Check& check) {
  if (check.table.empty()) return check.status.empty() ? check.metric : "how it ends";
  const auto shown = [](const std::string& text) { return printable(text, text.size()); };
  return "table " + check.table + ", column " + shown(check.column) +
         (check.row.empty() ? "" : ", row " + shown(check.row));
}

}  // namespace mb
