#include "reports/page.h"

#include <algorithm>
#include <stdexcept>

#include "reports/figures.h"
#include "reports/number.h"
#include "reports/verdict.h"

namespace mb {
namespace {

constexpr std::string_view place_of_data = "@REPORTJSON@";

const char* name_of(Column::Kind kind) {
  switch (kind) {
    case Column::Kind::text:
      return "text";
    case Column::Kind::number:
      return "number";
    case Column::Kind::error:
      return "error";
    case Column::Kind::time:
      return "time";
  }
  return "text";
}

// A cell is [text], [text, value] or [text, value, bar, status].
Json cell_json(const Cell& cell) {
  Json json = Json::array({cell.text});
  if (cell.value || cell.bar || !cell.status.empty()) json.push_back(cell.value ? Json(*cell.value) : Json(nullptr));
  if (cell.bar || !cell.status.empty()) {
    json.push_back(cell.bar ? Json(*cell.bar) : Json(nullptr));
    json.push_back(cell.status);
  }
  return json;
}

Json table_json(const Sheet& table) {
  Json columns = Json::array(), rows = Json::array();
  for (const Column& column : table.columns) {
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"kind", name_of(column.kind)}});
  }
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const Cell& cell : row) cells.push_back(cell_json(cell));
    rows.push_back(std::move(cells));
  }
  return {{"name", table.name}, {"title", table.title}, {"note", table.note}, {"columns", columns}, {"rows", rows}};
}

Json verdict_json(const Verdict& verdict) {
  Json json = {{"cases", verdict.n_cases},
               {"cases_within", verdict.n_cases_within},
               {"checks", verdict.n_checks},
               {"hold", verdict.n_hold},
               {"not_decidable", verdict.n_not_decidable},
               {"not_measured", verdict.n_not_measured},
               {"at_target", verdict.at_target.size()},
               {"failed_runs", verdict.n_failed_runs},
               {"sentences", verdict.sentences}};
  json["median"] = verdict.median ? Json(format_number(*verdict.median)) : Json(nullptr);
  return json;
}

// Measures as [run, quantity, truth, value, bar]: indices keep a page of many runs small. Failed measures have value
// null.
Json measures_json(const Analysis& analysis, const std::vector<Quantity>& all, const std::vector<std::string>& truths) {
  Json measures = Json::array();
  for (std::size_t i = 0; i < analysis.runs.size(); ++i) {
    for (const auto& [measure, record] : analysis.runs[i].measures) {
      const Quantity sought{measure.metric, measure.subject, record.unit};
      const auto quantity = std::find(all.begin(), all.end(), sought) - all.begin();
      const auto truth = std::find(truths.begin(), truths.end(), measure.truth) - truths.begin();
      const Json value = is_usable(record) ? Json(record.value) : Json(nullptr);
      measures.push_back(Json::array({i, quantity, truth, value, record.error_bar.value_or(0)}));
    }
  }
  return measures;
}

std::vector<std::string> truths_of(const Analysis& analysis) {
  std::vector<std::string> truths;
  for (const Record& record : analysis.input.records) {
    const bool known = std::find(truths.begin(), truths.end(), record.truth) != truths.end();
    if (is_mark(record) && !known) truths.push_back(record.truth);
  }
  std::sort(truths.begin(), truths.end());  // "finer" first: the headline's
  return truths;
}

Json plots_json(const Analysis& analysis) {
  const std::vector<Quantity> all = quantities(analysis);
  const std::vector<std::string> names = series(analysis), truths = truths_of(analysis);
  Json runs = Json::array(), list = Json::array();
  for (const Run& run : analysis.runs) {
    Json json = run_json(analysis, run);
    json["case"] = run.case_name;
    json["profile"] = run.profile;
    runs.push_back(std::move(json));
  }
  for (const Quantity& quantity : all) {
    list.push_back({{"metric", quantity.metric},
                    {"subject", quantity.subject},
                    {"title", title(quantity)},
                    {"modes", error_against_modes(quantity, names, Json::array())},
                    {"work", work_against_precision(quantity, names, time_axis(analysis), Json::array())}});
  }
  return {{"runs", runs}, {"quantities", list}, {"truths", truths}, {"measures", measures_json(analysis, all, truths)}};
}

Json cases_json(const Analysis& analysis) {
  Json cases = Json::array();
  for (const Scene& scene : analysis.input.scenes) {
    cases.push_back({{"name", scene.name},
                     {"profile", scene.profile},
                     {"title", scene.title},
                     {"purpose", scene.purpose},
                     {"source", scene.source},
                     {"truth", truth_sentences(analysis, scene)},
                     {"duration", scene.duration},
                     {"frame_rate", scene.frame_rate},
                     {"samples_per_second", scene.samples_per_second}});
  }
  return cases;
}

}  // namespace

std::string script_json(const Json& json) {
  std::string text;
  for (const char c : to_line(json)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

Json page_json(const Analysis& analysis) {
  Json terms = Json::array();
  for (const Definition& one : definitions(analysis)) terms.push_back(Json::array({one.term, one.text}));
  Json tables = Json::object();
  for (const Sheet& table : {contenders_table(analysis), speed_up_table(analysis), checks_table(analysis),
                             probes_table(analysis), failures_table(analysis)}) {
    tables[table.name] = table_json(table);
  }
  return {{"schema", 1},
          {"verdict", verdict_json(verdict_of(analysis))},
          {"environment", analysis.input.environment},
          {"cases", cases_json(analysis)},
          {"tables", tables},
          {"plots", plots_json(analysis)},
          {"definitions", terms},
          {"commands", reproducing_commands(analysis)}};
}

std::string page(const Analysis& analysis, std::string_view page_template) {
  const std::size_t place = page_template.find(place_of_data);
  if (place == std::string_view::npos) throw std::logic_error("the page template has no place for the data");
  std::string text(page_template.substr(0, place));
  text += script_json(page_json(analysis));
  return text + std::string(page_template.substr(place + place_of_data.size()));
}

}  // namespace mb
