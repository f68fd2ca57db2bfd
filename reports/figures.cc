#include "reports/figures.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "reports/number.h"

namespace mb {
namespace {

constexpr const char* method_palette[] = {"#0072B2", "#D55E00", "#009E73", "#56B4E9", "#A6761D", "#E7298A"};
constexpr const char* degree_palette[] = {"#E69F00", "#CC79A7", "#8C6BB1", "#7F7F7F"};
constexpr const char* shapes[] = {"circle",        "square", "triangle-up",   "diamond",
                                  "triangle-down", "cross",  "triangle-left", "triangle-right"};

std::size_t place(std::vector<std::string>& known, const std::string& name) {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  known.push_back(name);
  return known.size() - 1;
}

Json scale(const std::vector<DrawnSeries>& all, std::string DrawnSeries::*part) {
  Json domain = Json::array(), range = Json::array();
  for (const DrawnSeries& one : all) {
    domain.push_back(one.name);
    range.push_back(one.*part);
  }
  return {{"domain", domain}, {"range", range}};
}

}  // namespace

Json colour_scale(const std::vector<DrawnSeries>& all) { return scale(all, &DrawnSeries::colour); }
Json shape_scale(const std::vector<DrawnSeries>& all) { return scale(all, &DrawnSeries::shape); }

std::vector<Quantity> quantities(const Evaluation& evaluation) {
  static const std::vector<std::string> order = {"displacement-error", "strain-error",  "surface-deviation",
                                                 "pose-translation",   "pose-rotation", "probe-error",
                                                 "probe-von-mises"};
  const auto place = [](const Quantity& quantity) {
    return std::tuple(std::find(order.begin(), order.end(), quantity.metric) - order.begin(), quantity);
  };
  std::set<Quantity> found;
  for (const Record& record : evaluation.input.records) {
    if (is_mark(record) && is_reduced(record.contender)) found.insert({record.metric, record.subject, record.unit});
  }
  std::vector<Quantity> sorted(found.begin(), found.end());
  std::sort(sorted.begin(), sorted.end(), [&](const Quantity& a, const Quantity& b) { return place(a) < place(b); });
  return sorted;
}

std::string title(const Quantity& quantity) {
  static const std::map<std::string, std::string> known = {
      {"displacement-error", "relative displacement error, M norm"},
      {"strain-error", "relative strain error, K norm"},
      {"surface-deviation", "largest surface deviation / body size"},
      {"pose-translation", "pose error, translation"},
      {"pose-rotation", "pose error, rotation"},
      {"probe-error", "relative error of the probe signal"},
      {"probe-von-mises", "relative von Mises error of the probe"},
      {"probe-magnitude", "Sprague-Geers magnitude error"},
      {"probe-phase", "Sprague-Geers phase error"},
      {"probe-combined", "Sprague-Geers combined error"}};
  const auto entry = known.find(quantity.metric);
  const std::string name = entry == known.end() ? quantity.metric : entry->second;
  return quantity.subject.empty() ? name : name + ", " + quantity.subject;
}

std::vector<DrawnSeries> series(const Evaluation& evaluation) {
  std::vector<std::string> methods = {"eigenmodes", "static-correction", "quadratic", "linear", "full"};
  std::vector<std::string> integrators = {"exact",    "newmark",        "central-difference",
                                          "sundials", "explicit-euler", "symplectic-euler"};
  std::map<std::string, DrawnSeries> found;
  for (const Run& run : evaluation.runs) {
    const Contender& c = run.contender;
    const std::string name = describe_series(c, theory_of(evaluation, run.case_name, run.profile));
    if (found.contains(name)) continue;
    const auto degree = static_cast<std::size_t>(std::max(1, c.resolution.degree) - 1);
    const char* colour = c.method == "full-order"
                             ? degree_palette[degree % std::size(degree_palette)]
                             : method_palette[place(methods, c.method) % std::size(method_palette)];
    found[name] = {name, colour, shapes[place(integrators, c.integrator) % std::size(shapes)]};
  }
  std::vector<DrawnSeries> all;
  for (const bool full : {false, true}) {  // reduced ones first
    for (const auto& [name, one] : found) {
      if (name.starts_with("full ") == full) all.push_back(one);
    }
  }
  return all;
}

TimeAxis time_axis(const Evaluation& evaluation) {
  const bool known = std::all_of(evaluation.runs.begin(), evaluation.runs.end(),
                                 [&](const Run& run) { return simulated_seconds(evaluation, run).has_value(); });
  return {known, known ? "online time per simulated second [s]" : "online time [s]"};
}

std::vector<Json> run_data(const Evaluation& evaluation) {
  const bool per_second = time_axis(evaluation).per_simulated_second;
  const std::vector<Drawn> all_drawn = drawn(evaluation.runs);
  std::vector<Json> all;
  for (std::size_t i = 0; i < evaluation.runs.size(); ++i) {
    const Run& run = evaluation.runs[i];
    const Contender& contender = run.contender;
    const Theory theory = theory_of(evaluation, run.case_name, run.profile);
    const std::string family = describe_family(contender, theory) + ", " + describe_size(contender, theory);
    Json& json = all.emplace_back(Json{{"series", describe_series(contender, theory)},
                                       {"family", family},
                                       {"run", describe(contender, theory)},
                                       {"reduced", is_reduced(contender)},
                                       {"mesh", describe_mesh(contender.resolution, theory)},
                                       {"unknowns", run.n_unknowns},
                                       {"against_modes", is_reduced(contender) && all_drawn[i].against_modes},
                                       {"against_step", all_drawn[i].against_step}});
    if (is_reduced(contender)) json["r_used"] = std::max(run.modes_used, 0);
    if (takes_modes(contender)) json["r"] = contender.settings.modes;
    if (contender.settings.time_step > 0) json["time_step"] = contender.settings.time_step;
    if (!run.online || !is_usable(*run.online)) continue;
    const double per = per_second ? *simulated_seconds(evaluation, run) : 1;
    json["time"] = run.online->value / per;
    if (run.online->error_bar) json["spread"] = *run.online->error_bar / per;  // a single run has none
  }
  return all;
}

Labels order_labels(const std::vector<Curve>& all, const Run& of_case, const Measure& measure, bool against_step,
                    const std::vector<Drawn>& are_drawn, const std::vector<Run>& runs) {
  Labels labels;
  for (const Curve& curve : all) {
    const bool wanted = curve.case_name == of_case.case_name && curve.profile == of_case.profile &&
                        curve.measure == measure && !std::isnan(curve.observed.order) &&
                        curve.refinement == (against_step ? Refinement::step : Refinement::modes);
    if (!wanted) continue;
    const auto i = static_cast<std::size_t>(curve.runs.back() - runs.data());
    if (against_step && !are_drawn[i].against_step) continue;
    const std::string name = describe_series(curve.contender, curve.theory);
    labels[name] = name + (against_step ? ": dt^" : ": r^") +
                   format_number(against_step ? curve.observed.order : -curve.observed.order);
  }
  return labels;
}

void label_legends(Json& part, const Labels& labels) {
  if (labels.empty()) return;
  if (part.is_object() && part.contains("labelLimit")) {
    part["labelExpr"] = "(" + to_line(Json(labels)) + ")[datum.label] || datum.label";
    part["columns"] = 2;
  }
  if (part.is_structured()) {
    for (Json& child : part) label_legends(child, labels);
  }
}

}  // namespace mb
