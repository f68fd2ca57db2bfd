// Largest stable steps over the mode count.
#include "reports/finding_layers.h"
#include "reports/findings.h"

namespace mb {

// Lines: the formula; points: bisection; dashes: the full system, which has no r.
std::vector<Figure> step_limit_figures(const Finding& finding) {
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
  Json measured = layer(
      point_mark(),
      {{"x", x}, {"y", logarithmic("measured", y_title)}, {"color", colour}, {"shape", shapes_of(data, "scheme")}},
      "isValid(datum.r) && isValid(datum.measured)");
  return {{"step-limits",
           specification("Largest stable step: lines by formula, points by bisection, dashes the full system. "
                         "Limits of 0 are not drawn.",
                         std::move(data), Json::array(), Json::array({full, formula, measured}))}};
}

}  // namespace mb
