#include "reports/matrix.h"

#include <cmath>
#include <set>

#include "reports/number.h"

namespace mb {
namespace {

struct Outcome {
  const Run* best = nullptr;  // with the least error
  const Record* error = nullptr;
  int n_runs = 0, n_unstable = 0, n_failed = 0, n_undefined = 0;
};

// Full order: every mesh and step of an integrator together.
std::string family(const Contender& contender) {
  if (is_reduced(contender)) return describe_family(contender);
  return (contender.method == "full-order" ? "full order, " : "full basis, ") + describe_integrator(contender);
}

std::string case_of(const Evaluation& evaluation, const Run& run) {
  for (const Run& other : evaluation.runs) {
    if (other.case_name == run.case_name && other.profile != run.profile)
      return run.case_name + " (" + run.profile + ")";
  }
  return run.case_name;
}

void count(Outcome& outcome, const Run& run) {
  for (const auto& [measure, record] : run.measures) {
    if (measure.metric != headline_metric || !is_against_best(run, measure)) continue;
    ++outcome.n_runs;
    if (is_undefined(record)) {
      ++outcome.n_undefined;
    } else if (is_unstable(record)) {
      ++outcome.n_unstable;
    } else if (!is_usable(record)) {
      ++outcome.n_failed;
    } else if (!outcome.error || largest_error(record) < largest_error(*outcome.error)) {
      outcome.best = &run;
      outcome.error = &record;
    }
  }
}

std::string lost(const Outcome& outcome) {
  std::string text;
  if (outcome.n_unstable) text += ", " + std::to_string(outcome.n_unstable) + " unstable";
  if (outcome.n_failed) text += ", " + std::to_string(outcome.n_failed) + " failed";
  return text.empty() ? "" : text + " of " + std::to_string(outcome.n_runs);
}

Cell cell_of(const Evaluation& evaluation, const Outcome& outcome) {
  if (outcome.n_runs == 0) return text_cell("– not run");
  if (outcome.error) {
    const bool within = largest_error(*outcome.error) <= error_target;
    const Run& best = *outcome.best;
    const std::string setting =
        is_reduced(best.contender) ? describe_setting(best.contender)
                                   : describe_size(best.contender, theory_of(evaluation, best.case_name, best.profile));
    return {.text = std::string(within ? "✔ " : "▲ ") + format_record(*outcome.error) +
                    (setting.empty() ? "" : " (" + setting + ")") + lost(outcome),
            .value = outcome.error->value,
            .bar = outcome.error->error_bar,
            .status = outcome.error->status};
  }
  if (outcome.n_unstable > 0) return text_cell("⚡ " + lost(outcome).substr(2));
  return text_cell(outcome.n_failed > 0 ? "✘ " + lost(outcome).substr(2) : "? undefined");
}

}  // namespace

Sheet matrix_table(const Evaluation& evaluation) {
  std::map<std::pair<bool, std::string>, std::map<std::string, Outcome>> outcomes;  // reduced first; by case
  std::set<std::string> cases;
  for (const Run& run : evaluation.runs) {
    const std::string name = case_of(evaluation, run);
    cases.insert(name);
    count(outcomes[{!is_reduced(run.contender), family(run.contender)}][name], run);
  }
  Sheet table{
      .name = "matrix",
      .title = "Cases and contenders",
      .note =
          "Least displacement error against exact, or finer where no closed form is known, over the runs of "
          "each contender, and the setting that gave "
          "it. ✔ within 1 % with its error bar, ▲ not, ⚡ unstable (steps beyond the integrator's limit), ✘ failed "
          "otherwise, – not run in this case.",
      .columns = {{"contender", ""}},
      .rows = {},
      .n_keys = 0};
  for (const std::string& name : cases) table.columns.push_back({name, "", Column::Kind::error});
  for (const auto& [key, by_case] : outcomes) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{text_cell(key.second)});
    for (const std::string& name : cases) {
      const auto entry = by_case.find(name);
      row.push_back(cell_of(evaluation, entry == by_case.end() ? Outcome{} : entry->second));
    }
  }
  return table;
}

}  // namespace mb
