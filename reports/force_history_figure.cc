// The contact force over time, a line an answer.
#include <cmath>

#include "reports/finding_layers.h"
#include "reports/findings.h"

namespace mb {

std::vector<Figure> force_history_figures(const Finding& finding) {
  if (!has(finding, {"contender", "time", "normal force"})) return {};
  Json data = Json::array();
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const double t = number_at(finding, i, "time"), force = number_at(finding, i, "normal force");
    if (!std::isfinite(t) || !std::isfinite(force)) continue;
    const std::string name = with_modes(datum_of(finding, i), text_at(finding, i, "contender"));
    data.push_back({{"contender", name}, {"t", t}, {"force", force}});
  }
  Json x = plain("t", "time [" + unit_of(finding, "time") + "]");
  x["scale"] = {{"zero", false}};  // the first touch may come long after the start
  const Json y = plain("force", "normal force [" + unit_of(finding, "normal force") + "]");
  const Json line =
      layer(line_mark(),
            {{"x", x}, {"y", y}, {"strokeDash", shapes_of(data, "contender")}, {"color", channel(data, "contender")}});
  return {
      {"force-history", specification("Contact force over time", std::move(data), Json::array(), Json::array({line}))}};
}

}  // namespace mb
