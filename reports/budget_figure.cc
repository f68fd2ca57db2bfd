// Where the error of a contender comes from, part by part.
#include <cmath>

#include "reports/finding_layers.h"
#include "reports/findings.h"
#include "reports/words.h"

namespace mb {

namespace {

bool of_several_bodies(const Finding& finding) {
  for (std::size_t i = 1; i < finding.rows.size(); ++i)
    if (text_at(finding, i, "body") != text_at(finding, 0, "body")) return true;
  return false;
}

// Two lines: "ball, static-correction, r = 32" and "newmark, step 0.001 s". On one they would be cut or crowd out the
// bars.
std::string label_of(const Finding& finding, std::size_t i, bool with_body) {
  const std::string integrator = text_at(finding, i, "integrator");
  const std::string steps = joined({integrator == "exact" ? "" : integrator, text_at(finding, i, "setting")}, ", ");
  const std::string contender = with_modes(datum_of(finding, i), text_at(finding, i, "method"));
  return joined({joined({with_body ? text_at(finding, i, "body") : "", contender}, ", "), steps}, "\n");
}

}  // namespace

// Parts are norms of differences that add as vectors: the stack is longer than the whole where they cancel.
std::vector<Figure> budget_figures(const Finding& finding) {
  const bool with_body = of_several_bodies(finding);
  std::vector<Figure> all;
  for (const char* norm : {"M norm", "K norm"}) {
    if (!has(finding, {"method", "part", norm})) continue;
    Json data = Json::array();
    for (std::size_t i = 0; i < finding.rows.size(); ++i) {
      const double value = number_at(finding, i, norm);
      const std::string part = text_at(finding, i, "part");
      if (!std::isfinite(value) || part.starts_with("sum") || part.starts_with("total")) continue;
      data.push_back({{"contender", label_of(finding, i, with_body)}, {"part", part}, {"norm", value}});
    }
    const Json y = {{"field", "contender"},
                    {"type", "nominal"},
                    {"sort", nullptr},
                    {"title", nullptr},
                    {"axis", {{"labelLimit", 360}, {"labelExpr", "split(datum.label, '\\n')"}}}};
    Json x = plain("norm", std::string("norm of the parts, ") + norm + " [-]");
    x["stack"] = "zero";
    Json bars = layer({{"type", "bar"}, {"tooltip", {{"content", "data"}}}},
                      {{"y", y}, {"x", x}, {"color", channel(data, "part")}});
    Json figure =
        specification("Error budget, " + std::string(norm) + ": parts add as vectors, so that they may cancel.",
                      std::move(data), Json::array(), Json::array({bars}));
    figure["height"] = {{"step", 34}};
    all.push_back({std::string("budget-") + norm[0], std::move(figure)});
  }
  return all;
}

}  // namespace mb
