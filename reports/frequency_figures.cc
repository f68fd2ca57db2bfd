// Figures over frequency: responses, and what is found mode by mode.
#include <cmath>
#include <map>

#include "reports/finding_layers.h"
#include "reports/findings.h"
#include "reports/number.h"

namespace mb {
namespace {

// Columns of one table against its frequencies, a series each.
std::vector<Figure> over_frequency(const Finding& finding, const std::vector<const char*>& columns,
                                   const std::string& quantity, bool logarithmic_y) {
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
  const std::string y_title = quantity + " [" + unit_of(finding, data[0]["series"]) + "]";
  const std::string x_title = "frequency [" + unit_of(finding, "frequency") + "]";
  const Json y = logarithmic_y ? logarithmic("value", y_title) : plain("value", y_title);
  Json points = layer(point_mark(), {{"x", logarithmic("f", x_title)},
                                     {"y", y},
                                     {"color", channel(data, "series")},
                                     {"shape", shapes_of(data, "series")}});
  return {
      {file_part(finding.name), specification(finding.title, std::move(data), Json::array(), Json::array({points}))}};
}

}  // namespace

std::vector<Figure> frequency_response_figures(const Finding& finding) {
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
  std::vector<Figure> all;
  for (auto& [load, data] : by_load) {
    const Json line =
        layer(line_mark(), {{"x", plain("f", "frequency [" + unit_of(finding, "frequency") + "]")},
                            {"y", logarithmic("amplitude", "amplitude [" + unit_of(finding, "amplitude") + "]")},
                            {"strokeDash", shapes_of(data, "contender")},
                            {"color", channel(data, "contender")}});
    all.push_back({load.empty() ? "frequency-response" : "frequency-response-" + file_part(load),
                   specification("Frequency response at the first probe" + (load.empty() ? "" : ", load " + load), data,
                                 Json::array(), Json::array({line}))});
  }
  return all;
}

std::vector<Figure> damping_figures(const Finding& finding) {
  return over_frequency(finding, {"zeta asked", "zeta full", "zeta reduced", "zeta by decay"}, "damping ratio", false);
}

std::vector<Figure> amplitude_figures(const Finding& finding) {
  return over_frequency(finding, {"fixed energy", "fixed force", "fixed impulse"}, "largest modal displacement", true);
}

}  // namespace mb
