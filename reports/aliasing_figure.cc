// What the frames of a film make of motion that is too fast for them.
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "reports/finding_layers.h"
#include "reports/findings.h"
#include "reports/number.h"

namespace mb {
namespace {

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

}  // namespace

// One figure a frame rate: what is left of the motion too fast for the frames, against the sub-samples averaged.
std::vector<Figure> aliasing_figures(const Finding& finding) {
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

}  // namespace mb
