// One figure a case, profile, truth and quantity: the archived ones. The page fills its own from fewer specifications.
#include <tuple>

#include "reports/figures.h"
#include "reports/findings.h"

namespace mb {
namespace {

struct Key {
  std::string case_name, profile;
  Measure measure;
  std::string unit;
  auto operator<=>(const Key&) const = default;
};

// Magnitude, phase and their sum stand in the table of probes.
bool is_drawn(const std::string& metric) {
  return !metric.starts_with("probe-") || metric == "probe-error" || metric == "probe-von-mises";
}

std::string stem(const Key& key) {
  std::string text = file_part(key.case_name);
  for (const std::string& part : {key.profile, key.measure.truth, key.measure.metric, key.measure.subject}) {
    if (!part.empty()) text += "-" + file_part(part);
  }
  return text;
}

// What is drawn against r, or against the step.
Json drawn_part(const Json& data, bool against_step) {
  Json part = Json::array();
  for (const Json& datum : data) {
    const bool wanted = datum.value(against_step ? "against_step" : "against_modes", false);
    if (wanted && (!against_step || datum.contains("time_step"))) part.push_back(datum);
  }
  return part;
}

}  // namespace

std::vector<Figure> figures(const Evaluation& evaluation) {
  const std::vector<Json> of_run = run_data(evaluation);
  const std::vector<Curve> all_curves = curves(evaluation);
  const std::vector<Drawn> are_drawn = drawn(evaluation.runs);
  const std::vector<DrawnSeries> all_series = series(evaluation);
  const TimeAxis axis = time_axis(evaluation);
  std::map<Key, std::pair<const Run*, Json>> data;  // any run of the case, values
  for (std::size_t i = 0; i < evaluation.runs.size(); ++i) {
    const Run& run = evaluation.runs[i];
    for (const auto& [measure, record] : run.measures) {
      if (!is_usable(record) || !is_drawn(measure.metric)) continue;
      Json datum = of_run[i];
      datum["value"] = record.value;
      datum["bar"] = record.error_bar.value_or(0);
      auto& [any, values] = data[{run.case_name, run.profile, measure, record.unit}];
      any = &run;
      values.push_back(std::move(datum));
    }
  }
  std::vector<Figure> all;
  for (const auto& [key, entry] : data) {
    const auto& [any, values] = entry;
    const Quantity quantity{key.measure.metric, key.measure.subject, key.unit};
    const auto add = [&, stem = stem(key)](const std::string& name, Json specification) {
      specification["title"] = any->case_name + ", profile " + any->profile + ", truth " + key.measure.truth;
      all.push_back({name + "-" + stem, std::move(specification)});
    };
    add("work-against-precision", work_against_precision(quantity, all_series, axis, values));
    if (!is_norm(key.measure.metric)) continue;
    for (const bool against_step : {false, true}) {
      Json part = drawn_part(values, against_step);
      if (part.empty()) continue;
      Json specification = against_step ? error_against_step(quantity, all_series, std::move(part))
                                        : error_against_modes(quantity, all_series, std::move(part));
      label_legends(specification,
                    order_labels(all_curves, *any, key.measure, against_step, are_drawn, evaluation.runs));
      add(against_step ? "error-against-step" : "error-against-modes", std::move(specification));
    }
  }
  return all;
}

}  // namespace mb
