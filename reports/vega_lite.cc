// The specifications of errors: against r, against the step, against time.
#include "reports/figures.h"

namespace mb {
namespace {

// Every channel names the same legend: Vega-Lite merges them into one.
Json colour(const std::vector<DrawnSeries>& all) {
  return {{"field", "series"}, {"type", "nominal"}, {"scale", colour_scale(all)}, {"legend", bottom_legend()}};
}

Json shape(const std::vector<DrawnSeries>& all) {
  return {{"field", "series"}, {"type", "nominal"}, {"scale", shape_scale(all)}, {"legend", bottom_legend()}};
}

// Whole powers of ten get a grid line and a label, 10 with an exponent; the ticks between get neither.
constexpr const char* is_power_of_ten = "abs(log(datum.value)/LN10 - round(log(datum.value)/LN10)) < 1e-6";
constexpr const char* exponents =
    "['⁻¹⁶','⁻¹⁵','⁻¹⁴','⁻¹³','⁻¹²','⁻¹¹','⁻¹⁰',"
    "'⁻⁹','⁻⁸','⁻⁷','⁻⁶','⁻⁵','⁻⁴','⁻³','⁻²','⁻¹',"
    "'⁰','¹','²','³','⁴','⁵','⁶','⁷','⁸'][round(log(datum.value)/LN10) + 16]";

Json calculate(const std::string& formula, const std::string& as) { return {{"calculate", formula}, {"as", as}}; }

// Whiskers stop at a tenth of the value: on a logarithmic axis value - bar may lie arbitrarily far down.
Json derived() {
  return Json::array(
      {{{"filter", "isValid(datum.value)"}},
       calculate("max(abs(datum.value), datum.bar)", "shown"),
       {{"filter", "datum.shown > 0"}},
       calculate("abs(datum.value) < datum.bar", "below"),
       calculate("datum.below ? datum.shown : max(datum.shown - datum.bar, datum.shown / 10)", "low"),
       calculate("datum.below ? datum.shown : datum.shown + datum.bar", "high"),
       calculate("datum.below ? '<= ' + format(datum.bar, '.2~g') : format(datum.value, '.3~g') + "
                 "(datum.bar > 0 ? ' ± ' + format(datum.bar, '.2~g') : '')",
                 "error"),
       calculate("isValid(datum.time) ? format(datum.time, '.3~g') + "
                 "(isValid(datum.spread) ? ' ± ' + format(datum.spread, '.1~g') : ', single run') : 'not timed'",
                 "cost")});
}

Json tooltip(const std::string& error_title, const std::string& time_title) {
  const auto field = [](const char* name, const std::string& text) {
    return Json{{"field", name}, {"type", "nominal"}, {"title", text}};
  };
  return Json::array({field("run", "contender"), field("mesh", "mesh"), field("unknowns", "unknowns"),
                      field("error", error_title), field("cost", time_title)});
}

Json points(const Json& x, const Json& y, const std::vector<DrawnSeries>& all, Json tip) {
  return {{"mark", {{"type", "point"}, {"size", 62}, {"filled", true}, {"opacity", 1}, {"strokeWidth", 1.6}}},
          {"encoding",
           {{"x", x},
            {"y", y},
            {"fill", colour(all)},
            {"stroke", colour(all)},
            {"shape", shape(all)},
            {"fillOpacity", {{"condition", {{"test", "datum.below"}, {"value", 0}}}, {"value", 1}}},
            {"tooltip", std::move(tip)}}}};
}

Json whiskers(const Json& x, const std::string& axis_title, const std::vector<DrawnSeries>& all) {
  return {{"mark", {{"type", "rule"}, {"strokeWidth", 1.2}, {"opacity", 0.75}, {"tooltip", false}}},
          {"encoding",
           {{"x", x}, {"y", logarithmic("low", axis_title)}, {"y2", {{"field", "high"}}}, {"color", colour(all)}}}};
}

// Below this band nothing can be told: the truth's own error bar.
Json band(const std::string& axis_title) {
  return {{"transform", Json::array({{{"aggregate", Json::array({{{"op", "max"}, {"field", "bar"}, {"as", "band"}}})}},
                                     {{"filter", "datum.band > 0"}}})},
          {"mark", {{"type", "rect"}, {"color", "#8a8f98"}, {"opacity", 0.22}, {"tooltip", false}}},
          {"encoding",
           {{"x", {{"value", 0}}},
            {"x2", {{"value", "width"}}},
            {"y", logarithmic("band", axis_title)},
            {"y2", {{"value", "height"}}}}}};
}

Json target(const std::string& axis_title) {
  const Json data = {{"values", Json::array({{{"target", error_target}}})}};
  const Json y = logarithmic("target", axis_title);
  return {{"name", "target"},
          {"data", data},
          {"layer",
           Json::array({{{"mark", {{"type", "rule"}, {"strokeDash", {5, 3}}, {"color", "#c0392b"}, {"tooltip", false}}},
                         {"encoding", {{"y", y}}}},
                        {{"mark",
                          {{"type", "text"},
                           {"align", "left"},
                           {"dx", 4},
                           {"dy", -6},
                           {"color", "#c0392b"},
                           {"text", "1 % target"},
                           {"tooltip", false}}},
                         {"encoding", {{"x", {{"value", 0}}}, {"y", y}}}}})}};
}

// Smallest error at most a given cost: a running minimum over contenders by rising time.
Json front(const Json& x, const std::string& axis_title) {
  return {
      {"transform", Json::array({{{"window", Json::array({{{"op", "min"}, {"field", "shown"}, {"as", "front"}}})},
                                  {"sort", Json::array({{{"field", "time"}, {"order", "ascending"}}})},
                                  {"frame", Json::array({nullptr, 0})}}})},
      {"mark",
       {{"type", "line"},
        {"interpolate", "step-after"},
        {"color", "#8a8f98"},
        {"strokeWidth", 1.8},
        {"tooltip", false}}},
      {"encoding",
       {{"x", x}, {"y", logarithmic("front", axis_title)}, {"order", {{"field", "time"}, {"type", "quantitative"}}}}}};
}

}  // namespace

Json bottom_legend() {
  return {{"title", nullptr}, {"orient", "bottom"}, {"columns", 3}, {"symbolSize", 70}, {"labelLimit", 320}};
}

Json logarithmic(const std::string& field, const std::string& axis_title) {
  const std::string label = std::string(is_power_of_ten) + " ? '10' + " + exponents + " : ''";
  const Json grid = {{"condition", {{"test", is_power_of_ten}, {"value", 0.8}}}, {"value", 0}};
  return {{"field", field},
          {"type", "quantitative"},
          {"scale", {{"type", "log"}, {"nice", true}}},
          {"axis", {{"labelExpr", label}, {"gridOpacity", grid}}},
          {"title", axis_title}};
}

Json specification(const std::string& description, Json data, Json transform, Json layers) {
  return {{"$schema", "https://vega.github.io/schema/vega-lite/v6.json"},
          {"description", description},
          {"width", 560},
          {"height", 380},
          {"data", {{"name", "rows"}, {"values", std::move(data)}}},
          {"transform", std::move(transform)},
          {"layer", std::move(layers)},
          {"config", {{"font", "system-ui, sans-serif"}, {"view", {{"stroke", nullptr}}}}}};
}

namespace {

bool is_relative(const Quantity& quantity) { return quantity.unit == "-" || quantity.unit == unit_placeholder; }

std::string axis_title(const Quantity& quantity) { return title(quantity) + " [" + quantity.unit + "]"; }

// Lines through the runs that share a field, whiskers, the target and the points.
Json curves_of(const Json& x, const char* line_of, const Quantity& quantity, const std::vector<DrawnSeries>& all) {
  const std::string name = axis_title(quantity);
  const Json line = {{"mark", {{"type", "line"}, {"strokeWidth", 1.4}, {"opacity", 0.7}, {"tooltip", false}}},
                     {"encoding",
                      {{"x", x},
                       {"y", logarithmic("shown", name)},
                       {"detail", {{"field", line_of}, {"type", "nominal"}}},
                       {"color", colour(all)}}}};
  Json layers = Json::array({band(name), line, whiskers(x, name, all)});
  if (is_relative(quantity)) layers.push_back(target(name));
  layers.push_back(points(x, logarithmic("shown", name), all, tooltip(title(quantity), "online time")));
  return layers;
}

Json only(const std::string& condition) {
  Json transform = derived();
  transform.insert(transform.begin(), Json{{"filter", condition}});
  return transform;
}

}  // namespace

Json error_against_modes(const Quantity& quantity, const std::vector<DrawnSeries>& all, Json data) {
  std::vector<DrawnSeries> reduced;
  for (const DrawnSeries& one : all) {
    if (!one.name.starts_with("full ")) reduced.push_back(one);
  }
  const Json x = {{"field", "r_used"},
                  {"type", "quantitative"},
                  {"scale", {{"type", "symlog"}, {"constant", 1}, {"nice", false}, {"padding", 12}}},
                  {"axis", {{"values", {0, 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024}}, {"gridOpacity", 0.5}}},
                  {"title", "elastic modes used, r"}};
  return specification("Error of reduced methods against the number of modes", std::move(data),
                       only("datum.against_modes && isValid(datum.r_used)"), curves_of(x, "series", quantity, reduced));
}

Json error_against_step(const Quantity& quantity, const std::vector<DrawnSeries>& all, Json data) {
  const Json x = logarithmic("time_step", "time step [s]");
  return specification("Error against the time step", std::move(data),
                       only("datum.against_step && isValid(datum.time_step)"), curves_of(x, "family", quantity, all));
}

Json work_against_precision(const Quantity& quantity, const std::vector<DrawnSeries>& all, const TimeAxis& axis,
                            Json data) {
  const std::string name = axis_title(quantity);
  const Json x = logarithmic("time", axis.title);
  Json transform = derived();
  transform.push_back({{"filter", "isValid(datum.time) && datum.time > 0"}});
  Json layers = Json::array({band(name), front(x, name), whiskers(x, name, all)});
  if (is_relative(quantity)) layers.push_back(target(name));
  layers.push_back(points(x, logarithmic("shown", name), all, tooltip(title(quantity), axis.title)));
  return specification("Error of every contender against its online time", std::move(data), std::move(transform),
                       std::move(layers));
}

}  // namespace mb
