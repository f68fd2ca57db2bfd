#include "reports/views.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "reports/check_cells.h"
#include "reports/contender_columns.h"
#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/speedup_columns.h"
#include "reports/words.h"

namespace mb {
namespace {

using Kind = Column::Kind;

bool is_probe(const std::string& metric) { return metric.starts_with("probe-"); }

struct MetricColumn {
  std::string metric, unit;
};

// Metrics that were recorded, the usual ones first, in one table for bodies and one for probes.
std::vector<MetricColumn> metric_columns(const Evaluation& evaluation, bool probes) {
  static constexpr const char* usual[] = {"displacement-error", "strain-error",    "surface-deviation",
                                          "pose-translation",   "pose-rotation",   "probe-error",
                                          "probe-von-mises",    "probe-magnitude", "probe-phase"};
  std::map<std::string, std::string> found;  // metric -> unit
  for (const Record& record : evaluation.input.records) {
    if (is_mark(record) && is_probe(record.metric) == probes) found.emplace(record.metric, record.unit);
  }
  std::vector<MetricColumn> columns;
  for (const char* name : usual) {
    if (const auto entry = found.find(name); entry != found.end()) {
      columns.push_back({entry->first, entry->second});
      found.erase(entry);
    }
  }
  for (const auto& [metric, unit] : found) columns.push_back({metric, unit});
  return columns;
}

std::string heading(const std::string& metric) { return metric == "probe-von-mises" ? "von Mises error" : metric; }

struct Answer {
  std::string truth, subject;
  auto operator<=>(const Answer&) const = default;
};

std::set<Answer> answers(const Run& run, const std::vector<MetricColumn>& columns) {
  std::set<Answer> result;
  for (const auto& [measure, record] : run.measures) {
    const bool wanted = std::any_of(columns.begin(), columns.end(),
                                    [&](const MetricColumn& column) { return column.metric == measure.metric; });
    if (wanted) result.insert({measure.truth, measure.subject});
  }
  return result;
}

const Record* pointer(const std::optional<Record>& record) { return record ? &*record : nullptr; }

std::vector<Cell> metric_cells(const Run& run, const Answer& answer, const std::vector<MetricColumn>& columns) {
  std::vector<Cell> cells;
  for (const MetricColumn& column : columns) {
    const auto entry = run.measures.find({column.metric, answer.subject, answer.truth});
    cells.push_back(record_cell(entry == run.measures.end() ? nullptr : &entry->second));
  }
  return cells;
}

template <typename Wanted>
Sheet metric_table(const Evaluation& evaluation, std::string name, std::string title, bool probes, Wanted wanted) {
  const std::vector<MetricColumn> metrics = metric_columns(evaluation, probes);
  Sheet table{.name = std::move(name), .title = std::move(title), .note = "", .columns = {}, .rows = {}};
  table.columns = {{"case", ""}, {"profile", ""}, {"truth", ""}, {probes ? "probe" : "body", ""}};
  for (Column& column : contender_columns()) table.columns.push_back(std::move(column));
  for (const MetricColumn& metric : metrics)
    table.columns.push_back({heading(metric.metric), metric.unit, Kind::error});
  table.columns.push_back({"online time", "s", Kind::time});
  table.columns.push_back({"offline time", "s", Kind::time});
  for (const Run& run : evaluation.runs) {
    if (!wanted(run.contender)) continue;
    const Theory theory = theory_of(evaluation, run.case_name, run.profile);
    for (const Answer& answer : answers(run, metrics)) {
      std::vector<Cell> row = {text_cell(run.case_name), text_cell(run.profile), text_cell(answer.truth),
                               text_cell(answer.subject)};
      append(row, contender_cells(run.contender, run.modes_used, run.n_unknowns, theory));
      append(row, metric_cells(run, answer, metrics));
      row.push_back(record_cell(pointer(run.online)));
      row.push_back(record_cell(pointer(run.offline)));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace

bool is_norm(const std::string& metric) { return std::find(norms.begin(), norms.end(), metric) != norms.end(); }

Evaluation evaluate(const ReportInput& input) {
  Evaluation result{.input = input,
                    .runs = group_runs(input.records),
                    .checks = check_results(input.scenes, input.records, input.findings),
                    .speed_ups = {}};
  for (const std::string& norm : norms) {
    const std::vector<SpeedUp> all = speed_ups(input.records, norm);
    result.speed_ups.insert(result.speed_ups.end(), all.begin(), all.end());
  }
  return result;
}

const Scene* scene_of(const Evaluation& evaluation, const std::string& case_name, const std::string& profile) {
  for (const Scene& scene : evaluation.input.scenes) {
    if (scene.name == case_name && scene.profile == profile) return &scene;
  }
  return nullptr;
}

const Run* run_of(const Evaluation& evaluation, const Record& record) { return find_run(evaluation.runs, record); }

Theory theory_of(const Evaluation& evaluation, const std::string& case_name, const std::string& profile) {
  if (const Scene* scene = scene_of(evaluation, case_name, profile)) {
    for (const Body& body : scene->bodies) {
      if (body.theory != Theory::solid) return body.theory;
    }
  }
  return Theory::solid;
}

std::optional<double> simulated_seconds(const Evaluation& evaluation, const Run& run) {
  const Scene* scene = scene_of(evaluation, run.case_name, run.profile);
  return scene && scene->duration > 0 ? std::optional(scene->duration) : std::nullopt;
}

Sheet checks_table(const Evaluation& evaluation) {
  Sheet table{.name = "checks", .title = "Checks", .note = "What the case files demand.", .columns = {}, .rows = {}};
  table.columns = {{"case", ""},
                   {"profile", ""},
                   {"truth", ""},
                   {"runs", ""},
                   {"what", ""},
                   {"measured", "", Kind::number},
                   {"error bar", "", Kind::number},
                   {"bound", ""},
                   {"verdict", ""},
                   {"why", ""}};
  for (const CheckResult& result : evaluation.checks) {
    table.rows.push_back({text_cell(result.case_name), text_cell(result.profile), text_cell(result.check.truth),
                          text_cell(runs_of(result.check)), text_cell(subject_of(result.check)), measured_cell(result),
                          bar_cell(result), text_cell(bound(result.check)), text_cell(verdict(result)),
                          text_cell(result.check.why)});
  }
  return table;
}

Sheet reduced_table(const Evaluation& evaluation) {
  return metric_table(evaluation, "error-against-modes", "Error against r", false,
                      [](const Contender& contender) { return is_reduced(contender); });
}

Sheet rivals_table(const Evaluation& evaluation) {
  return metric_table(evaluation, "full-order", "Full-order contenders", false,
                      [](const Contender& contender) { return !is_reduced(contender); });
}

Sheet probes_table(const Evaluation& evaluation) {
  return metric_table(evaluation, "probes", "Probe signals", true, [](const Contender&) { return true; });
}

// Cells that name an answer: case, profile, truth, body, then the contender up to its settings (not its unknowns).
constexpr std::size_t n_naming = 4 + 7;

// Whether an error is within the target, as far as its bar can tell.
Cell target_cell(const Cell& error) {
  if (!error.value) return text_cell("");
  const double value = std::abs(*error.value), bar = error.bar.value_or(0);
  return text_cell(value + bar <= error_target ? "yes" : value - bar > error_target ? "no" : "open");
}

// What the page shows: every contender with its speed-up and whether it meets the target.
Sheet contenders_table(const Evaluation& evaluation) {
  Sheet table = metric_table(evaluation, "contenders", "Contenders", false, [](const Contender&) { return true; });
  std::map<std::vector<std::string>, std::vector<Cell>> ratios;  // by the cells that name a reduced run
  const auto key_of = [](const std::vector<Cell>& cells) {
    std::vector<std::string> key;
    for (std::size_t j = 0; j < n_naming; ++j) key.push_back(cells[j].text);
    return key;
  };
  for (const SpeedUp& one : of_norm(evaluation.speed_ups, headline_metric)) {
    const Record& e = one.error;
    std::vector<Cell> cells = {text_cell(e.case_name), text_cell(e.profile), text_cell(e.truth), text_cell(e.subject)};
    const Theory theory = theory_of(evaluation, e.case_name, e.profile);
    append(cells, contender_cells(e.contender, e.modes_used, e.n_unknowns, theory));
    std::vector<Cell> quotients = {ratio_cell(one), margin_cell(one), miss_ratio_cell(one)};
    for (Cell& cell : quotients)  // ranges and limits stand in the table of speed-ups
      if (cell.value) cell.text = format_number(*cell.value);
    if (has_perturbed_time(one)) quotients[0].text += ", perturbed";
    ratios[key_of(cells)] = std::move(quotients);
  }
  const auto error = std::find_if(table.columns.begin(), table.columns.end(),
                                  [](const Column& column) { return column.name == headline_metric; });
  const std::size_t j_error = static_cast<std::size_t>(error - table.columns.begin());
  for (const char* name : {"speed-up", "margin", "miss speed-up"}) table.columns.push_back({name, "-", Kind::number});
  table.columns.push_back({"<= 1 %", ""});
  for (std::vector<Cell>& row : table.rows) {
    const auto ratio = ratios.find(key_of(row));
    for (std::size_t j = 0; j < 3; ++j) row.push_back(ratio == ratios.end() ? text_cell("") : ratio->second[j]);
    row.push_back(target_cell(j_error < row.size() ? row[j_error] : Cell{}));
  }
  return table;
}

}  // namespace mb
