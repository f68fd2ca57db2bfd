// Cost of collision detection over its size, and errors of contact forces over the number of samples.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "reports/finding_layers.h"
#include "reports/findings.h"
#include "reports/number.h"

namespace mb {
namespace {

// A line and its points for every contender, both axes logarithmic.
Figure lines(const std::string& name, const std::string& description, Json data, const std::string& x_title,
             const std::string& y_title) {
  const Json x = logarithmic("x", x_title), y = logarithmic("y", y_title), colour = channel(data, "contender");
  const Json line = layer(line_mark(), {{"x", x}, {"y", y}, {"color", colour}}, "isValid(datum.x)");
  const Json points =
      layer(point_mark(), {{"x", x}, {"y", y}, {"color", colour}, {"shape", shapes_of(data, "contender")}},
            "isValid(datum.x)");
  const Json levels = layer(dashed_mark(), {{"y", y}, {"color", colour}}, "!isValid(datum.x)");
  return {name, specification(description, std::move(data), Json::array(), Json::array({levels, line, points}))};
}

// "sphere, n = m" as part of a file name: "sphere-n-m".
std::string stem(const std::string& text) {
  std::string part = file_part(text);
  const auto twice = [](char a, char b) { return a == '-' && b == '-'; };
  part.erase(std::unique(part.begin(), part.end(), twice), part.end());
  return part;
}

// Rows by what `group` says of them: contender, x where finite, y where positive and finite.
std::map<std::string, Json> grouped(const Finding& finding, const std::function<std::string(std::size_t)>& group,
                                    const char* x, const char* y) {
  std::map<std::string, Json> all;
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const double at = number_at(finding, i, x), value = number_at(finding, i, y);
    if (!(value > 0) || !std::isfinite(value)) continue;
    Json datum = {{"contender", text_at(finding, i, "contender")}, {"y", value}};
    if (at > 0 && std::isfinite(at)) datum["x"] = at;
    all.try_emplace(group(i), Json::array()).first->second.push_back(std::move(datum));
  }
  return all;
}

}  // namespace

// One a partner and sweep.
std::vector<Figure> collision_figures(const Finding& finding) {
  if (!has(finding, {"partner", "sweep", "contender", "points m", "time"})) return {};
  std::vector<Figure> all;
  const auto group = [&](std::size_t i) {
    return text_at(finding, i, "partner") + ", " + text_at(finding, i, "sweep");
  };
  for (auto& [name, data] : grouped(finding, group, "points m", "time")) {
    all.push_back(lines("collision-cost-" + stem(name), "Time of collision detection, " + name, std::move(data),
                        "points m", "time of a query [s]"));
  }
  return all;
}

// One a shape and depth, of force errors averaged over orientations; dashes: the closed form, which has no samples.
std::vector<Figure> contact_figures(const Finding& finding) {
  if (!has(finding, {"shape", "depth", "contender", "samples", "force"})) return {};
  std::vector<Figure> all;
  const auto group = [&](std::size_t i) {
    return text_at(finding, i, "shape") + ", depth " + format_setting(number_at(finding, i, "depth"));
  };
  for (auto& [name, data] : grouped(finding, group, "samples", "force")) {
    all.push_back(lines("contact-forces-" + stem(name), "Error of the contact force, " + name, std::move(data),
                        "samples on the whole surface", "mean relative error of the force [-]"));
  }
  return all;
}

}  // namespace mb
