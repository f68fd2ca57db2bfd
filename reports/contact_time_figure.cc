// Where the time of a run in contact goes: its parts as shares of their sum, a bar a method and r.
#include <cmath>

#include "reports/finding_layers.h"
#include "reports/findings.h"
#include "reports/number.h"
#include "reports/words.h"

namespace mb {
namespace {

// Two lines: "static-correction, r = 32" and "step 0.0001 s", if the table has steps.
std::string label_of(const Finding& finding, std::size_t i) {
  const double step = number_at(finding, i, "dt");
  const std::string name = with_modes(datum_of(finding, i), text_at(finding, i, "method"));
  return joined({name, step > 0 ? "step " + format_setting(step) + " s" : ""}, "\n");
}

}  // namespace

std::vector<Figure> contact_time_figures(const Finding& finding) {
  if (!has(finding, {"method", "part", "share"})) return {};
  Json data = Json::array();
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const double share = number_at(finding, i, "share"), seconds = number_at(finding, i, "time");
    if (!std::isfinite(share)) continue;
    Json datum = {{"contender", label_of(finding, i)}, {"part", text_at(finding, i, "part")}, {"share", share}};
    if (std::isfinite(seconds)) datum["time [s]"] = seconds;  // of the tooltip
    data.push_back(std::move(datum));
  }
  const Json y = {{"field", "contender"},
                  {"type", "nominal"},
                  {"sort", nullptr},
                  {"title", nullptr},
                  {"axis", {{"labelLimit", 360}, {"labelExpr", "split(datum.label, '\\n')"}}}};
  Json x = plain("share", "share of the computing time [" + unit_of(finding, "share") + "]");
  x["stack"] = "zero";
  x["scale"] = {{"domain", {0, 1}}};
  const Json bars = layer({{"type", "bar"}, {"tooltip", {{"content", "data"}}}},
                          {{"y", y}, {"x", x}, {"color", channel(data, "part")}});
  Json figure =
      specification("Where the time of a run in contact goes", std::move(data), Json::array(), Json::array({bars}));
  figure["height"] = {{"step", 34}};
  return {{"contact-time", std::move(figure)}};
}

}  // namespace mb
