// Vega-Lite specifications of the figures; the data stand in `data.values` of the archived files and are filled in by
// the page.
//
// A datum is one contender by one measure: series, family, run (label), r, r_used, mesh, time_step, unknowns, value,
// bar, time, spread. What is drawn follows from it inside the specification: shown = max(|value|, bar), hollow where
// below the bar.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cases/json/json.h"
#include "reports/orders.h"
#include "reports/views.h"

namespace mb {

// What an axis shows: a metric of one body or probe.
struct Quantity {
  std::string metric, subject, unit;
  auto operator<=>(const Quantity&) const = default;
};
inline constexpr const char *metric_placeholder = "@QUANTITY@", *unit_placeholder = "@UNIT@";  // filled by the page
std::vector<Quantity> quantities(const Evaluation& evaluation);
std::string title(const Quantity& quantity);  // "relative displacement error, M norm"

// Colour by method or degree, shape by integrator: fixed for a whole report. Okabe and Ito's palette, safe for
// colour-blind readers (M. Okabe, K. Ito, Color Universal Design, 2008).
struct DrawnSeries {
  std::string name, colour, shape;
};
std::vector<DrawnSeries> series(const Evaluation& evaluation);
Json colour_scale(const std::vector<DrawnSeries>& all);  // {"domain": names, "range": colours}
Json shape_scale(const std::vector<DrawnSeries>& all);

// Seconds of computing per simulated second where every scene is known, else seconds a run.
struct TimeAxis {
  bool per_simulated_second;
  std::string title;
};
TimeAxis time_axis(const Evaluation& evaluation);

std::vector<Json> run_data(const Evaluation& evaluation);  // one a run: the part of a datum that no measure changes
Json error_against_modes(const Quantity& quantity, const std::vector<DrawnSeries>& all, Json data);
Json error_against_step(const Quantity& quantity, const std::vector<DrawnSeries>& all, Json data);
Json work_against_precision(const Quantity& quantity, const std::vector<DrawnSeries>& all, const TimeAxis& axis,
                            Json data);

// Shared by all figures.
Json logarithmic(const std::string& field, const std::string& axis_title);  // a channel, powers of ten labelled
Json bottom_legend();
Json specification(const std::string& description, Json data, Json transform, Json layers);

// What the legend of a figure says of a series instead of its name: "eigenmodes, newmark: dt^2.01".
using Labels = std::map<std::string, std::string>;
Labels order_labels(const std::vector<Curve>& all, const Run& of_case, const Measure& measure, bool against_step,
                    const std::vector<Drawn>& are_drawn, const std::vector<Run>& runs);
void label_legends(Json& specification, const Labels& labels);

struct Figure {
  std::string name;
  Json specification;
};
// Every case, profile, truth and quantity that has data, but for the parts of Sprague and Geers' measure; of the three
// norms also against r and against the step.
std::vector<Figure> figures(const Evaluation& evaluation);

// Of what an analysis found; none where the columns that a figure needs are missing. Names lack case and profile.
std::vector<Figure> finding_figures(const Finding& finding);

// Bars of the pairs given, each with the norm it is of; none where no pair has a rival.
std::optional<Json> speed_up_figure(const std::vector<std::pair<std::string, SpeedUp>>& pairs);

}  // namespace mb
