#include "reports/finding_layers.h"

#include <algorithm>
#include <cmath>

#include "reports/findings.h"
#include "reports/number.h"

namespace mb {
namespace {

constexpr const char* palette[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                   "#E69F00", "#56B4E9", "#8C6BB1", "#7F7F7F"};

// Every value of a text or setting column, in order of appearance.
std::vector<std::string> values_of(const Json& data, const char* field) {
  std::vector<std::string> all;
  for (const Json& datum : data) {
    const std::string value = datum.value(field, std::string());
    if (!value.empty() && std::find(all.begin(), all.end(), value) == all.end()) all.push_back(value);
  }
  return all;
}

}  // namespace

bool has(const Finding& finding, std::initializer_list<const char*> columns) {
  return std::all_of(columns.begin(), columns.end(), [&](const char* name) { return column_of(finding, name); });
}

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

Json channel(const Json& data, const char* field) {
  Json range = Json::array();
  const std::vector<std::string> names = values_of(data, field);
  for (std::size_t i = 0; i < names.size(); ++i) range.push_back(palette[i % std::size(palette)]);
  return {{"field", field},
          {"type", "nominal"},
          {"scale", {{"domain", names}, {"range", range}}},
          {"legend", bottom_legend()}};
}

Json shapes_of(const Json& data, const char* field) {
  return {{"field", field},
          {"type", "nominal"},
          {"scale", {{"domain", values_of(data, field)}}},
          {"legend", bottom_legend()}};
}

Json plain(const char* field, const std::string& axis_title) {
  return {{"field", field}, {"type", "quantitative"}, {"title", axis_title}};
}

Json layer(Json mark, Json encoding, const std::string& filter) {
  Json all = {{"mark", std::move(mark)}, {"encoding", std::move(encoding)}};
  if (!filter.empty()) all["transform"] = Json::array({Json{{"filter", filter}}});
  return all;
}

Json line_mark() { return {{"type", "line"}, {"strokeWidth", 1.6}, {"tooltip", false}}; }
Json point_mark() { return {{"type", "point"}, {"size", 62}, {"filled", true}, {"tooltip", {{"content", "data"}}}}; }
Json dashed_mark() {
  return {{"type", "rule"}, {"strokeDash", {6, 3}}, {"strokeWidth", 1.4}, {"tooltip", {{"content", "data"}}}};
}

std::string unit_of(const Finding& finding, const std::string& column) {
  const auto j = column_of(finding, column);
  return j ? finding.columns[*j].unit : "";
}

std::string with_modes(const Json& datum, const std::string& name) {
  if (!datum.contains("modes r") || !datum["modes r"].is_number()) return name;
  return name + ", r = " + format_setting(datum["modes r"].get<double>());
}

}  // namespace mb
