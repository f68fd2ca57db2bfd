// Vega-Lite specifications of the figures; the data stand in `data.values` of the archived files and are filled in by
// the page.
//
// A datum is one contender by one measure: series, run (label), r, r_used, mesh, time_step, unknowns, value, bar, time,
// spread. What is drawn follows from it inside the specification: shown = max(|value|, bar), hollow where below the
// bar.
#pragma once

#include <string>
#include <vector>

#include "cases/json/json.h"
#include "reports/views.h"

namespace mb {

// What an axis shows: a metric of one body or probe.
struct Quantity {
  std::string metric, subject, unit;
  auto operator<=>(const Quantity&) const = default;
};
std::vector<Quantity> quantities(const Analysis& analysis);
std::string title(const Quantity& quantity);  // "relative displacement error, M norm"

// Series in the order of their colours and shapes: fixed for a whole report.
std::vector<std::string> series(const Analysis& analysis);

// Seconds of computing per simulated second where every scene is known, else seconds a run.
struct TimeAxis {
  bool per_simulated_second;
  std::string title;
};
TimeAxis time_axis(const Analysis& analysis);

Json run_json(const Analysis& analysis, const Run& run);  // the part of a datum that no measure changes
Json error_against_modes(const Quantity& quantity, const std::vector<std::string>& series_names, Json data);
Json work_against_precision(const Quantity& quantity, const std::vector<std::string>& series_names,
                            const TimeAxis& axis, Json data);

struct Figure {
  std::string name;
  Json specification;
};
std::vector<Figure> figures(const Analysis& analysis);  // every case, profile, truth and quantity that has data

}  // namespace mb
