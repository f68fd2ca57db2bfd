// Figures of what analyses found, by the names of their tables and columns (harness/analysis/analyses.h).
#include <cmath>
#include <functional>
#include <set>

#include "reports/figures.h"
#include "reports/findings.h"
#include "reports/number.h"

namespace mb {
namespace {

constexpr const char* palette[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                   "#E69F00", "#56B4E9", "#8C6BB1", "#7F7F7F"};

bool has(const Finding& finding, std::initializer_list<const char*> columns) {
  return std::all_of(columns.begin(), columns.end(), [&](const char* name) { return column_of(finding, name); });
}

// A row as an object; cells without a number are left out.
Json datum_of(const Finding& finding, std::size_t i) {
  Json datum = Json::object();
  for (std::size_t j = 0; j < std::min(finding.columns.size(), finding.rows[i].size()); ++j) {
    const FindingCell& cell = finding.rows[i][j];
    if (const auto* text = std::get_if<std::string>(&cell)) {
      datum[finding.columns[j].name] = *text;
    } else if (std::isfinite(std::get<double>(cell))) {
      datum[finding.columns[j].name] = std::get<double>(cell);
    }
  }
  return datum;
}

// Every value of a text or setting column, in order of appearance.
std::vector<std::string> values_of(const Json& data, const char* field) {
  std::vector<std::string> all;
  for (const Json& datum : data) {
    const std::string value = datum.value(field, std::string());
    if (!value.empty() && std::find(all.begin(), all.end(), value) == all.end()) all.push_back(value);
  }
  return all;
}

Json channel(const Json& data, const char* field) {
  Json range = Json::array();
  const std::vector<std::string> names = values_of(data, field);
  for (std::size_t i = 0; i < names.size(); ++i) range.push_back(palette[i % std::size(palette)]);
  return {{"field", field},
          {"type", "nominal"},
          {"scale", {{"domain", names}, {"range", range}}},
          {"legend", bottom_legend()}};
}

Json plain(const char* field, const std::string& axis_title) {
  return {{"field", field}, {"type", "quantitative"}, {"title", axis_title}};
}

Json layer(Json mark, Json encoding, const std::string& filter = "") {
  Json all = {{"mark", std::move(mark)}, {"encoding", std::move(encoding)}};
  if (!filter.empty()) all["transform"] = Json::array({Json{{"filter", filter}}});
  return all;
}

Json line_mark() { return {{"type", "line"}, {"strokeWidth", 1.6}, {"tooltip", false}}; }
Json point_mark() { return {{"type", "point"}, {"size", 62}, {"filled", true}, {"tooltip", {{"content", "data"}}}}; }
Json dashed_mark() {
  return {{"type", "rule"}, {"strokeDash", {6, 3}}, {"strokeWidth", 1.4}, {"tooltip", {{"content", "data"}}}};
}

std::string with_modes(const Json& datum, const std::string& name) {
  if (!datum.contains("modes r") || !datum["modes r"].is_number()) return name;
  return name + ", r = " + format_setting(datum["modes r"].get<double>());
}

// Lines: the formula; points: bisection; dashes: the full system, which has no r.
std::vector<Figure> step_limits(const Finding& finding) {
  if (!has(finding, {"system", "modes r", "scheme", "dt formula", "dt measured"})) return {};
  Json data = Json::array();
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const Json datum = datum_of(finding, i);
    const double r = number_at(finding, i, "modes r");
    Json value = {{"scheme", datum.value("scheme", "")}, {"system", datum.value("system", "")}};
    if (r > 0) value["r"] = r;
    for (const auto& [column, field] : {std::pair("dt formula", "formula"), std::pair("dt measured", "measured")}) {
      if (datum.contains(column) && datum[column].is_number() && datum[column] > 0) value[field] = datum[column];
    }
    data.push_back(std::move(value));
  }
  const std::string y_title = "largest stable step [s]";
  const Json x = logarithmic("r", "elastic modes, r"), colour = channel(data, "scheme");
  Json full = layer(dashed_mark(), {{"y", logarithmic("measured", y_title)}, {"color", colour}},
                    "!isValid(datum.r) && isValid(datum.measured)");
  Json formula = layer(line_mark(), {{"x", x}, {"y", logarithmic("formula", y_title)}, {"color", colour}},
                       "isValid(datum.r) && isValid(datum.formula)");
  Json measured = layer(point_mark(),
                        {{"x", x},
                         {"y", logarithmic("measured", y_title)},
                         {"color", colour},
                         {"shape",
                          {{"field", "scheme"},
                           {"type", "nominal"},
                           {"scale", {{"domain", values_of(data, "scheme")}}},
                           {"legend", bottom_legend()}}}},
                        "isValid(datum.r) && isValid(datum.measured)");
  return {{"step-limits",
           specification("Largest stable step: lines by formula, points by bisection, dashes the full system. "
                         "Limits of 0 are not drawn.",
                         std::move(data), Json::array(), Json::array({full, formula, measured}))}};
}

// Of many mode counts the smallest, the middle one and the largest.
std::set<double> few_modes(const Finding& finding) {
  std::set<double> all;
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    if (text_at(finding, i, "contender") == "modal") all.insert(number_at(finding, i, "modes r"));
  }
  if (all.size() <= 3) return all;
  return {*all.begin(), *std::next(all.begin(), static_cast<std::ptrdiff_t>(all.size() / 2)), *all.rbegin()};
}

// A row of the table of aliasing as a point; none where it cannot be drawn. Without N: exact shutter average.
std::optional<Json> aliasing_point(const Finding& finding, std::size_t i, const std::set<double>& modes) {
  const double N = number_at(finding, i, "sub-samples"), value = number_at(finding, i, "aliasing");
  const std::string contender = text_at(finding, i, "contender");
  if (!std::isfinite(number_at(finding, i, "frame rate")) || !(value > 0) || !std::isfinite(value)) return std::nullopt;
  if (contender == "modal" && !modes.contains(number_at(finding, i, "modes r"))) return std::nullopt;
  Json point = {{"contender", with_modes(datum_of(finding, i), contender)},
                {"shutter", text_at(finding, i, "shutter")},
                {"aliasing", value}};
  if (N >= 1 && std::isfinite(N)) point["N"] = N;
  return point;
}

// One figure a frame rate: what is left of the motion too fast for the frames, against the sub-samples averaged.
std::vector<Figure> aliasing(const Finding& finding) {
  if (!has(finding, {"frame rate", "contender", "sub-samples", "aliasing"})) return {};
  const std::set<double> modes = few_modes(finding);
  std::map<double, Json> by_rate;
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    if (auto point = aliasing_point(finding, i, modes)) {
      by_rate.try_emplace(number_at(finding, i, "frame rate"), Json::array())
          .first->second.push_back(std::move(*point));
    }
  }
  std::vector<Figure> all;
  for (auto& [rate, data] : by_rate) {
    const Json colour = channel(data, "contender"), y = logarithmic("aliasing", "aliasing / low-band motion [-]");
    Json x = logarithmic("N", "sub-samples averaged in a frame, N");
    x["scale"] = {{"type", "log"}, {"base", 2}};
    x["axis"] = {{"values", {1, 2, 4, 8, 16, 32, 64}}, {"gridOpacity", 0.5}};
    const Json encoding = {{"x", x}, {"y", y}, {"color", colour}};
    Json layers = Json::array({layer(dashed_mark(), {{"y", y}, {"color", colour}}, "!isValid(datum.N)"),
                               layer(line_mark(), encoding, "isValid(datum.N)"),
                               layer(point_mark(), encoding, "isValid(datum.N)")});
    all.push_back({"aliasing-" + file_part(format_setting(rate)),
                   specification("Temporal aliasing at " + format_setting(rate) +
                                     " frames/s; dashes: exact shutter average; what is 0 is not drawn.",
                                 std::move(data), Json::array(), std::move(layers))});
  }
  return all;
}

std::vector<Figure> frequency_response(const Finding& finding) {
  if (!has(finding, {"contender", "frequency", "amplitude"})) return {};
  std::map<std::string, Json> by_load;
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const Json datum = datum_of(finding, i);
    const double f = number_at(finding, i, "frequency"), amplitude = number_at(finding, i, "amplitude");
    if (!std::isfinite(f) || !(amplitude > 0) || !std::isfinite(amplitude)) continue;
    by_load.try_emplace(text_at(finding, i, "load"), Json::array())
        .first->second.push_back(
            {{"contender", with_modes(datum, datum.value("contender", ""))}, {"f", f}, {"amplitude", amplitude}});
  }
  const auto unit_of = [&](const char* name) { return finding.columns[*column_of(finding, name)].unit; };
  std::vector<Figure> all;
  for (auto& [load, data] : by_load) {
    const Json line = layer(line_mark(), {{"x", plain("f", "frequency [" + unit_of("frequency") + "]")},
                                          {"y", logarithmic("amplitude", "amplitude [" + unit_of("amplitude") + "]")},
                                          {"strokeDash",
                                           {{"field", "contender"},
                                            {"type", "nominal"},
                                            {"scale", {{"domain", values_of(data, "contender")}}},
                                            {"legend", bottom_legend()}}},
                                          {"color", channel(data, "contender")}});
    all.push_back({load.empty() ? "frequency-response" : "frequency-response-" + file_part(load),
                   specification("Frequency response at the first probe" + (load.empty() ? "" : ", load " + load), data,
                                 Json::array(), Json::array({line}))});
  }
  return all;
}

// Parts are norms of differences that add as vectors: the stack is longer than the whole where they cancel.
std::vector<Figure> budget(const Finding& finding) {
  std::vector<Figure> all;
  for (const char* norm : {"M norm", "K norm"}) {
    if (!has(finding, {"method", "part", norm})) continue;
    Json data = Json::array();
    for (std::size_t i = 0; i < finding.rows.size(); ++i) {
      const Json datum = datum_of(finding, i);
      const double value = number_at(finding, i, norm);
      const std::string part = text_at(finding, i, "part");
      if (!std::isfinite(value) || part.starts_with("sum") || part.starts_with("total")) continue;
      std::string name = with_modes(datum, text_at(finding, i, "method"));
      for (const char* more : {"integrator", "setting"}) {
        const std::string text = text_at(finding, i, more);
        if (!text.empty() && text != "exact") name += ", " + text;
      }
      data.push_back({{"contender", name}, {"part", part}, {"norm", value}});
    }
    const Json y = {{"field", "contender"},
                    {"type", "nominal"},
                    {"sort", nullptr},
                    {"title", nullptr},
                    {"axis", {{"labelLimit", 240}}}};
    Json x = plain("norm", std::string("norm of the parts, ") + norm + " [-]");
    x["stack"] = "zero";
    Json bars = layer({{"type", "bar"}, {"tooltip", {{"content", "data"}}}},
                      {{"y", y}, {"x", x}, {"color", channel(data, "part")}});
    Json figure =
        specification("Error budget, " + std::string(norm) + ": parts add as vectors, so that they may cancel.",
                      std::move(data), Json::array(), Json::array({bars}));
    figure["height"] = {{"step", 20}};
    all.push_back({std::string("budget-") + norm[0], std::move(figure)});
  }
  return all;
}

// Columns of one table against its frequencies, a series each.
std::vector<Figure> over_frequency(const Finding& finding, const std::vector<const char*>& columns,
                                   const std::string& y_title, bool logarithmic_y) {
  if (!has(finding, {"frequency"})) return {};
  Json data = Json::array();
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const double f = number_at(finding, i, "frequency");
    for (const char* column : columns) {
      const double value = number_at(finding, i, column);
      if (!std::isfinite(value) || !(f > 0) || (logarithmic_y && !(value > 0))) continue;
      data.push_back({{"series", column}, {"f", f}, {"value", value}});
    }
  }
  if (data.empty()) return {};
  const Json y = logarithmic_y ? logarithmic("value", y_title) : plain("value", y_title);
  Json points = layer(point_mark(), {{"x", logarithmic("f", "frequency [Hz]")},
                                     {"y", y},
                                     {"color", channel(data, "series")},
                                     {"shape",
                                      {{"field", "series"},
                                       {"type", "nominal"},
                                       {"scale", {{"domain", values_of(data, "series")}}},
                                       {"legend", bottom_legend()}}}});
  return {
      {file_part(finding.name), specification(finding.title, std::move(data), Json::array(), Json::array({points}))}};
}

}  // namespace

std::vector<Figure> finding_figures(const Finding& finding) {
  std::vector<Figure> all;
  if (finding.name == "step-limits") all = step_limits(finding);
  if (finding.name == "aliasing") all = aliasing(finding);
  if (finding.name == "frequency-response") all = frequency_response(finding);
  if (finding.name == "budget") all = budget(finding);
  if (finding.name == "damping") {
    all = over_frequency(finding, {"zeta asked", "zeta full", "zeta reduced", "zeta by decay"}, "damping ratio [-]",
                         false);
  }
  if (finding.name == "mode-amplitudes") {
    all = over_frequency(finding, {"fixed energy", "fixed force", "fixed impulse"},
                         "displacement / that of the first mode", true);
  }
  std::erase_if(all, [](const Figure& one) { return one.specification["data"]["values"].empty(); });
  for (Figure& one : all) one.specification["title"] = finding.case_name + ", profile " + finding.profile;
  return all;
}

}  // namespace mb
