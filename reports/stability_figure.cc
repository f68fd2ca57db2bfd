// Which steps are stable over the mode count, an integrator a figure, with the limit that its amplification predicts.
#include <algorithm>
#include <cmath>

#include "reports/finding_layers.h"
#include "reports/findings.h"

namespace mb {
namespace {

const Json classes = {"stable", "inaccurate", "unstable"};
const Json colours = {"#0072B2", "#E69F00", "#D55E00"}, shapes = {"circle", "diamond", "cross"};

Json by_class(const char* what, const Json& range) {
  return {{"field", "found"},
          {"type", "nominal"},
          {"title", nullptr},
          {"scale", {{"domain", classes}, {what, range}}},
          {"legend", bottom_legend()}};
}

std::vector<std::string> integrators_of(const Finding& finding) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const std::string name = text_at(finding, i, "integrator");
    if (std::ranges::find(all, name) == all.end()) all.push_back(name);
  }
  return all;
}

Json data_of(const Finding& finding, const std::string& integrator) {
  Json data = Json::array();
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    if (text_at(finding, i, "integrator") != integrator) continue;
    Json datum = datum_of(finding, i);
    if (!(datum.value("limit", 0.) > 0)) datum.erase("limit");  // stable nowhere or everywhere: no line
    data.push_back(std::move(datum));
  }
  return data;
}

}  // namespace

namespace {

// A limit over y, where there is one.
Json boundary(const char* column, const Json& dash, const char* y_name, const Json& y) {
  const Json line = {{"type", "line"}, {"color", "#000000"}, {"strokeDash", dash}, {"point", true}};
  return layer(line, {{"x", logarithmic(column, "step [s]")}, {"y", y}, {"order", plain(y_name, "")}},
               std::string("isValid(datum['") + column + "'])");
}

// Over y, by whatever column of the map.
std::vector<Figure> maps_over(const Finding& finding, const char* y_name, const char* y_title,
                              const std::string& title) {
  if (!has(finding, {"integrator", y_name, "dt", "found", "limit"})) return {};
  std::vector<Figure> all;
  for (const std::string& integrator : integrators_of(finding)) {
    const Json y = logarithmic(y_name, y_title);
    const Json cells = layer({{"type", "point"}, {"size", 90}, {"filled", true}, {"tooltip", {{"content", "data"}}}},
                             {{"x", logarithmic("dt", "step [s]")},
                              {"y", y},
                              {"color", by_class("range", colours)},
                              {"shape", by_class("range", shapes)}});
    Json layers = Json::array({cells, boundary("limit", {6, 3}, y_name, y)});
    if (has(finding, {"opening limit"})) layers.push_back(boundary("opening limit", {2, 2}, y_name, y));
    Json map = specification(integrator + ": " + title, data_of(finding, integrator), Json::array(), std::move(layers));
    map["title"] = integrator + ": ";
    all.push_back({file_part(finding.name) + "-" + file_part(integrator), std::move(map)});
  }
  return all;
}

}  // namespace

std::vector<Figure> stability_figures(const Finding& finding) {
  return maps_over(finding, "modes r", "elastic modes, r",
                   "stable, inaccurate and unstable steps; dashes the limit by the spectral radius of one step");
}

std::vector<Figure> contact_stability_figures(const Finding& finding) {
  const char* corrected = finding.name == "corrected-stability" ? " with static correction" : "";
  return maps_over(finding, "stiffness factor", "stiffness of the layer over the scene's",
                   "stable, inaccurate and unstable steps in contact" + std::string(corrected) +
                       "; dashes the limit by one linearised step, "
                       "dots a lower bound of it: beyond alone may steps gain a tenth where the layer opens");
}

}  // namespace mb
