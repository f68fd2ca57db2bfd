// Bars of what was won, a case and a norm each.
#include <cmath>

#include "reports/figures.h"

namespace mb {
namespace {

constexpr const char* palette[] = {"#0072B2", "#D55E00", "#009E73"};  // as many as norms

Json tip_field(const char* name, const char* text) { return {{"field", name}, {"type", "nominal"}, {"title", text}}; }

Json datum_of(const std::string& norm, const SpeedUp& one) {
  const double low = std::isfinite(one.ratio_low) ? one.ratio_low : one.ratio;
  return {{"case", one.error.case_name + " (" + one.error.profile + ")"},
          {"norm", norm},
          {"ratio", one.ratio},
          {"low", low > 0 ? low : one.ratio / 10},
          {"high", std::isfinite(one.ratio_high) ? one.ratio_high : one.ratio},
          {"reduced", describe(one.error.contender)},
          {"rival", describe(one.rival[0].contender)},
          {"text", ratio_cell(one).text}};
}

}  // namespace

std::optional<Json> speed_up_figure(const std::vector<std::pair<std::string, SpeedUp>>& pairs) {
  Json data = Json::array();
  for (const auto& [norm, one] : pairs) {
    if (!one.rival.empty() && one.ratio > 0) data.push_back(datum_of(norm, one));
  }
  if (data.empty()) return std::nullopt;
  const Json y = {
      {"field", "case"}, {"type", "nominal"}, {"sort", nullptr}, {"title", nullptr}, {"axis", {{"labelLimit", 240}}}};
  const Json offset = {{"field", "norm"}, {"type", "nominal"}, {"sort", nullptr}, {"scale", {{"domain", norms}}}};
  const Json colour = {{"field", "norm"},
                       {"type", "nominal"},
                       {"scale", {{"domain", norms}, {"range", palette}}},
                       {"legend", bottom_legend()}};
  const Json tip =
      Json::array({tip_field("case", "case"), tip_field("norm", "norm"), tip_field("reduced", "reduced run"),
                   tip_field("rival", "rival"), tip_field("text", "speed-up")});
  const std::string x_title = "speed-up at 1 % error [-]";
  const Json bars = {{"mark", {{"type", "bar"}}},
                     {"encoding",
                      {{"y", y},
                       {"yOffset", offset},
                       {"x", logarithmic("ratio", x_title)},
                       {"x2", {{"datum", 1}}},
                       {"color", colour},
                       {"tooltip", tip}}}};
  const Json spread = {
      {"mark", {{"type", "rule"}, {"strokeWidth", 1.6}, {"color", "#8a8f98"}, {"tooltip", false}}},
      {"encoding", {{"y", y}, {"yOffset", offset}, {"x", logarithmic("low", x_title)}, {"x2", {{"field", "high"}}}}}};
  Json figure =
      specification("Speed-up of the cheapest reduced run within 1 % over the cheapest full-order run within 1 %",
                    std::move(data), Json::array(), Json::array({bars, spread}));
  figure["height"] = {{"step", 16}};
  return figure;
}

}  // namespace mb
