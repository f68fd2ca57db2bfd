#include "reports/views.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "reports/contender_columns.h"
#include "reports/number.h"
#include "reports/speedup.h"

namespace mb {
namespace {

using Kind = Column::Kind;

bool is_probe(const std::string& metric) { return metric.starts_with("probe-"); }

struct MetricColumn {
  std::string metric, unit;
};

// Metrics that were recorded, the usual ones first, in one table for bodies and one for probes.
std::vector<MetricColumn> metric_columns(const Analysis& analysis, bool probes) {
  static constexpr const char* usual[] = {"displacement-error", "strain-error", "surface-deviation", "pose-translation",
                                          "pose-rotation",      "probe-error",  "probe-magnitude",   "probe-phase"};
  std::map<std::string, std::string> found;  // metric -> unit
  for (const Record& record : analysis.input.records) {
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
Sheet metric_table(const Analysis& analysis, std::string name, std::string title, bool probes, Wanted wanted) {
  const std::vector<MetricColumn> metrics = metric_columns(analysis, probes);
  Sheet table{.name = std::move(name), .title = std::move(title), .note = "", .columns = {}, .rows = {}};
  table.columns = {{"case", ""}, {"profile", ""}, {"truth", ""}, {probes ? "probe" : "body", ""}};
  for (Column& column : contender_columns()) table.columns.push_back(std::move(column));
  for (const MetricColumn& metric : metrics) table.columns.push_back({metric.metric, metric.unit, Kind::error});
  table.columns.push_back({"online time", "s", Kind::time});
  table.columns.push_back({"offline time", "s", Kind::time});
  for (const Run& run : analysis.runs) {
    if (!wanted(run.contender)) continue;
    for (const Answer& answer : answers(run, metrics)) {
      std::vector<Cell> row = {text_cell(run.case_name), text_cell(run.profile), text_cell(answer.truth),
                               text_cell(answer.subject)};
      for (Cell& cell : contender_cells(run.contender, run.modes_used, run.n_unknowns)) row.push_back(std::move(cell));
      for (Cell& cell : metric_cells(run, answer, metrics)) row.push_back(std::move(cell));
      row.push_back(record_cell(pointer(run.online)));
      row.push_back(record_cell(pointer(run.offline)));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::string bound(const Check& check) {
  if (check.at_most) return "<= " + format_setting(*check.at_most);
  return check.at_least ? ">= " + format_setting(*check.at_least) : "no bound";
}

Cell measured_cell(const CheckResult& result) {
  if (!result.measured) return {.text = "none", .value = {}, .bar = {}, .status = result.status};
  return {.text = format_with_bar(result.value, result.error_bar),
          .value = result.value,
          .bar = result.error_bar,
          .status = "ok"};
}

std::string verdict(const CheckResult& result) {
  if (!result.measured) return result.status == "no record" ? "not measured" : "failed (" + result.status + ")";
  if (!result.decidable) return "not decidable: the bound is below the error bar";
  return result.holds ? "holds" : "does not hold";
}

}  // namespace

Analysis analyse(const ReportInput& input) {
  return {.input = input,
          .runs = group_runs(input.records),
          .checks = check_results(input.scenes, input.records),
          .speed_ups = speed_ups(input.records, headline_metric)};
}

const Scene* scene_of(const Analysis& analysis, const std::string& case_name, const std::string& profile) {
  for (const Scene& scene : analysis.input.scenes) {
    if (scene.name == case_name && scene.profile == profile) return &scene;
  }
  return nullptr;
}

const Run* run_of(const Analysis& analysis, const Record& record) {
  for (const Run& run : analysis.runs) {
    const bool same = run.case_name == record.case_name && run.profile == record.profile &&
                      same_contender(run.contender, record.contender);
    if (same) return &run;
  }
  return nullptr;
}

std::optional<double> simulated_seconds(const Analysis& analysis, const Run& run) {
  const Scene* scene = scene_of(analysis, run.case_name, run.profile);
  return scene && scene->duration > 0 ? std::optional(scene->duration) : std::nullopt;
}

std::vector<std::string> truth_sentences(const Analysis& analysis, const Scene& scene) {
  std::map<std::tuple<std::string, std::string, std::string>, std::string> said;  // by truth, metric and subject
  for (const Record& record : analysis.input.records) {
    if (!is_of_truth(record) || record.case_name != scene.name || record.profile != scene.profile) continue;
    std::string text = "Of the truth " + record.truth + ": " + record.metric + " " + format_record(record);
    if (!record.unit.empty() && record.unit != "-") text += " " + record.unit;
    if (!record.subject.empty()) text += " (" + record.subject + ")";
    said[{record.truth, record.metric, record.subject}] = text + ".";
  }
  std::vector<std::string> sentences;
  for (const auto& [key, sentence] : said) sentences.push_back(sentence);
  return sentences;
}

Sheet checks_table(const Analysis& analysis) {
  Sheet table{.name = "checks", .title = "Checks", .note = "What the case files demand.", .columns = {}, .rows = {}};
  table.columns = {{"case", ""},
                   {"profile", ""},
                   {"truth", ""},
                   {"method", ""},
                   {"r", "", Kind::number},
                   {"metric", ""},
                   {"measured", "", Kind::error},
                   {"bound", ""},
                   {"verdict", ""},
                   {"why", ""}};
  for (const Scene& scene : analysis.input.scenes) {  // scene by scene: a case may stand here in two profiles
    for (const CheckResult& result : check_results({scene}, analysis.input.records)) {
      table.rows.push_back({text_cell(scene.name), text_cell(scene.profile), text_cell(result.check.truth),
                            text_cell(result.check.method), count_cell(result.check.modes),
                            text_cell(result.check.metric), measured_cell(result), text_cell(bound(result.check)),
                            text_cell(verdict(result)), text_cell(result.check.why)});
    }
  }
  return table;
}

Sheet reduced_table(const Analysis& analysis) {
  return metric_table(analysis, "error-against-modes", "Error against r", false,
                      [](const Contender& contender) { return is_reduced(contender); });
}

Sheet rivals_table(const Analysis& analysis) {
  return metric_table(analysis, "full-order", "Full-order contenders", false,
                      [](const Contender& contender) { return !is_reduced(contender); });
}

Sheet probes_table(const Analysis& analysis) {
  return metric_table(analysis, "probes", "Probe signals", true, [](const Contender&) { return true; });
}

// What the page shows: every contender with its speed-up and whether it meets the target.
Sheet contenders_table(const Analysis& analysis) {
  Sheet table = metric_table(analysis, "contenders", "Contenders", false, [](const Contender&) { return true; });
  std::map<std::vector<std::string>, std::vector<Cell>> ratios;  // by the cells that name a reduced run
  for (const SpeedUp& one : analysis.speed_ups) {
    const Record& e = one.error;
    const Contender& c = e.contender;
    ratios[{e.case_name, e.profile, e.truth, e.subject, c.method, c.integrator, to_string(c.resolution),
            std::to_string(c.settings.modes)}] = {
        one.rival.empty() ? ratio_cell(one) : number_cell(one.ratio),  // its range stands in the table of speed-ups
        margin_cell(one), miss_ratio_cell(one)};
  }
  const auto error = std::find_if(table.columns.begin(), table.columns.end(),
                                  [](const Column& column) { return column.name == headline_metric; });
  const std::size_t j_error = static_cast<std::size_t>(error - table.columns.begin());
  for (const char* name : {"speed-up", "margin", "miss speed-up"}) table.columns.push_back({name, "-", Kind::number});
  table.columns.push_back({"<= 1 %", ""});
  for (std::vector<Cell>& row : table.rows) {
    std::vector<std::string> key;
    for (std::size_t j = 0; j < 8; ++j) key.push_back(row[j].text);
    const bool graded = j_error < row.size() && row[j_error].value.has_value();
    const bool within = graded && std::max(std::abs(*row[j_error].value), row[j_error].bar.value_or(0)) <= error_target;
    const auto ratio = ratios.find(key);
    for (std::size_t j = 0; j < 3; ++j) row.push_back(ratio == ratios.end() ? text_cell("") : ratio->second[j]);
    row.push_back(text_cell(!graded ? "" : within ? "yes" : "no"));
  }
  return table;
}

}  // namespace mb
