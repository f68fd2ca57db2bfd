#include "reports/page.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/json/json.h"
#include "reports/claims.h"
#include "reports/definitions.h"
#include "reports/environment.h"
#include "reports/figures.h"
#include "reports/findings.h"
#include "reports/hard_cases.h"
#include "reports/matrix.h"
#include "reports/number.h"
#include "reports/orders.h"
#include "reports/polynomial_modes.h"
#include "reports/speedup.h"
#include "reports/verdict.h"
#include "reports/words.h"

namespace mb {
namespace {

constexpr std::string_view place_of_data = "@REPORTJSON@";

// Data of a specification as fields and rows, so that names stand once.
Json figure_json(const Figure& figure) {
  Json specification = figure.specification, fields = Json::array(), rows = Json::array();
  const Json data = specification["data"]["values"];
  for (const Json& datum : data) {
    for (const auto& [name, value] : datum.items()) {
      if (std::find(fields.begin(), fields.end(), Json(name)) == fields.end()) fields.push_back(name);
    }
  }
  for (const Json& datum : data) {
    Json row = Json::array();
    for (const Json& name : fields) {
      const auto entry = datum.find(name.get<std::string>());
      const bool is_number = entry != datum.end() && entry->is_number();
      row.push_back(entry == datum.end() ? Json(nullptr) : is_number ? rounded(entry->get<double>()) : *entry);
    }
    rows.push_back(std::move(row));
  }
  specification.erase("data");
  return {{"name", figure.name}, {"specification", specification}, {"fields", fields}, {"rows", rows}};
}

Json findings_json(const Evaluation& evaluation) {
  Json groups = Json::array();
  for (const FindingGroup& group : finding_groups(evaluation)) {
    Json tables = Json::array();
    for (const Finding* finding : group.findings) {
      const std::string stem = file_stem(evaluation, *finding);
      Sheet table = shortened(sheet_of(*finding), longest_page_table, "data/" + stem + ".csv");
      table.name = stem;
      Json figures = Json::array();
      for (const Figure& figure : finding_figures(*finding)) figures.push_back(figure_json(figure));
      tables.push_back({{"case", finding->case_name},
                        {"profile", finding->profile},
                        {"table", table_json(table)},
                        {"figures", figures}});
    }
    groups.push_back({{"analysis", group.analysis},
                      {"heading", group.heading},
                      {"before_speed_up", stands_before_speed_up(group.analysis)},
                      {"tables", tables}});
  }
  return groups;
}

// The case on which the page opens: the one whose speed-up is nearest to the headline's median; null where none counts.
Json opening_json(const Verdict& verdict) {
  const SpeedUp* opening = nullptr;
  const auto distance = [&](const SpeedUp& one) { return std::abs(std::log(one.ratio / *verdict.median)); };
  for (const SpeedUp& one : verdict.at_target) {
    if (!one.rival.empty() && (!opening || distance(one) < distance(*opening))) opening = &one;
  }
  if (!opening) return nullptr;
  return {{"case", opening->error.case_name}, {"profile", opening->error.profile}};
}

Json verdict_json(const Verdict& verdict) {
  Json json = {{"cases", verdict.n_cases},
               {"cases_within", verdict.n_cases_within},
               {"checks", verdict.n_checks},
               {"hold", verdict.n_hold},
               {"not_decidable", verdict.n_not_decidable},
               {"not_measured", verdict.n_not_measured},
               {"timed", verdict.is_timed},
               {"at_target", verdict.at_target.size()},
               {"compared", verdict.n_compared},
               {"failed_runs", verdict.n_failed_runs},
               {"unstable_runs", verdict.n_unstable_runs},
               {"sentences", verdict.sentences},
               {"opening", opening_json(verdict)}};
  json["median"] = verdict.median ? Json(format_number(*verdict.median)) : Json(nullptr);
  return json;
}

// Measures as [run, quantity, truth, value, bar]: indices keep a page of many runs small. Failed measures have value
// null.
Json measures_json(const Evaluation& evaluation, const std::vector<Quantity>& all,
                   const std::vector<std::string>& truths) {
  std::map<Quantity, std::size_t> place;
  for (std::size_t i = 0; i < all.size(); ++i) place[all[i]] = i;
  Json measures = Json::array();
  for (std::size_t i = 0; i < evaluation.runs.size(); ++i) {
    for (const auto& [measure, record] : evaluation.runs[i].measures) {
      const auto quantity = place.find({measure.metric, measure.subject, record.unit});
      if (quantity == place.end()) continue;
      const auto truth = std::find(truths.begin(), truths.end(), measure.truth) - truths.begin();
      const Json value = is_usable(record) ? rounded(record.value) : Json(nullptr);
      measures.push_back(Json::array({i, quantity->second, truth, value, rounded(record.error_bar.value_or(0))}));
    }
  }
  return measures;
}

// What the legends say: [any run of the case, quantity, truth, figure, {series: label}].
Json labels_json(const Evaluation& evaluation, const std::vector<Quantity>& all,
                 const std::vector<std::string>& truths) {
  const std::vector<Curve> all_curves = curves(evaluation);
  const std::vector<Drawn> are_drawn = drawn(evaluation.runs);
  Json labels = Json::array();
  std::string last;
  for (std::size_t i = 0; i < evaluation.runs.size(); ++i) {
    const Run& run = evaluation.runs[i];
    const std::string name = run.case_name + "\n" + run.profile;
    if (name == last) continue;
    last = name;
    for (std::size_t q = 0; q < all.size(); ++q) {
      if (!is_norm(all[q].metric)) continue;
      for (std::size_t t = 0; t < truths.size(); ++t) {
        for (const bool against_step : {false, true}) {
          const Measure measure{all[q].metric, all[q].subject, truths[t]};
          const Labels found = order_labels(all_curves, run, measure, against_step, are_drawn, evaluation.runs);
          if (!found.empty()) labels.push_back(Json::array({i, q, t, against_step ? "steps" : "modes", found}));
        }
      }
    }
  }
  return labels;
}

std::vector<std::string> truths_of(const Evaluation& evaluation) {
  std::vector<std::string> truths;
  for (const Record& record : evaluation.input.records) {
    const bool known = std::find(truths.begin(), truths.end(), record.truth) != truths.end();
    if (is_mark(record) && !known) truths.push_back(record.truth);
  }
  std::ranges::sort(truths, {}, [](const std::string& one) { return std::pair(one != "finer", one); });
  return truths;
}

Json plots_json(const Evaluation& evaluation) {
  const std::vector<Quantity> all = quantities(evaluation);
  const std::vector<std::string> truths = truths_of(evaluation);
  const std::vector<DrawnSeries> names = series(evaluation);
  const std::vector<Json> data = run_data(evaluation);
  Json runs = Json::array(), list = Json::array();
  for (std::size_t i = 0; i < evaluation.runs.size(); ++i) {
    Json json = data[i];
    for (const char* field : {"time", "spread"}) {
      if (json.contains(field)) json[field] = rounded(json[field].get<double>());
    }
    json["case"] = evaluation.runs[i].case_name;
    json["profile"] = evaluation.runs[i].profile;
    runs.push_back(std::move(json));
  }
  for (const Quantity& one : all) {
    list.push_back({{"metric", one.metric}, {"subject", one.subject}, {"unit", one.unit}, {"title", title(one)}});
  }
  const Quantity any{metric_placeholder, "", unit_placeholder};
  const Json specifications = {{"modes", error_against_modes(any, names, Json::array())},
                               {"steps", error_against_step(any, names, Json::array())},
                               {"work", work_against_precision(any, names, time_axis(evaluation), Json::array())}};
  Json bars = nullptr;
  if (const auto figure = speed_up_figure(headline_pairs(evaluation))) bars = figure_json({"speed-up", *figure});
  return {{"runs", runs},
          {"quantities", list},
          {"specifications", specifications},
          {"speed_up", bars},
          {"labels", labels_json(evaluation, all, truths)},
          {"truths", truths},
          {"measures", measures_json(evaluation, all, truths)}};
}

Json cases_json(const Evaluation& evaluation) {
  Json cases = Json::array();
  for (const Scene& scene : evaluation.input.scenes) {
    cases.push_back({{"name", scene.name},
                     {"profile", scene.profile},
                     {"title", scene.title},
                     {"purpose", joined({scene.purpose, scene.hard}, " ")},
                     {"source", scene.source},
                     {"line", case_line(evaluation, scene)},
                     {"truth", truth_sentences(evaluation, scene)},
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

Json page_json(const Evaluation& evaluation) {
  Json terms = Json::array();
  for (const Explanation& one : definitions(evaluation)) terms.push_back(Json::array({one.term, one.text}));
  Json tables = Json::object();
  const std::vector<SpeedUp> front = on_front(evaluation.speed_ups);
  for (const Sheet& table : {headline_table(evaluation), contenders_table(evaluation), matrix_table(evaluation),
                             orders_table(curves(evaluation)), speed_up_table(evaluation, front),
                             phases_table(evaluation, front), polynomials_table(evaluation), claims_table(evaluation),
                             hard_cases_table(evaluation), hard_integrators_table(evaluation), checks_table(evaluation),
                             probes_table(evaluation), failures_table(evaluation), environment_table(evaluation)}) {
    tables[table.name] = table_json(table);
  }
  return {{"schema", 1},          {"verdict", verdict_json(verdict_of(evaluation))}, {"cases", cases_json(evaluation)},
          {"tables", tables},     {"findings", findings_json(evaluation)},           {"plots", plots_json(evaluation)},
          {"definitions", terms}, {"commands", reproducing_commands(evaluation)}};
}

std::string page(const Evaluation& evaluation, std::string_view page_template) {
  const std::size_t place = page_template.find(place_of_data);
  if (place == std::string_view::npos) throw std::logic_error("the page template has no place for the data");
  std::string text(page_template.substr(0, place));
  text += script_json(page_json(evaluation));
  return text + std::string(page_template.substr(place + place_of_data.size()));
}

}  // namespace mb
