// What figures of findings are put together from.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "cases/contract/finding.h"
#include "reports/figures.h"

namespace mb {

bool has(const Finding& finding, std::initializer_list<const char*> columns);
Json datum_of(const Finding& finding, std::size_t i);  // row i as an object; cells without a number are left out
std::string unit_of(const Finding& finding, const std::string& column);  // "" where there is no such column
std::string with_modes(const Json& datum, const std::string& name);      // "eigenmodes, r = 8"

Json channel(const Json& data, const char* field);  // a colour for every value of a text field, in order of appearance
Json shapes_of(const Json& data, const char* field);  // likewise a shape
Json plain(const char* field, const std::string& axis_title);
Json layer(Json mark, Json encoding, const std::string& filter = "");
Json line_mark();
Json point_mark();
Json dashed_mark();

// The figures, by the names of tables and columns (harness/analysis/analyses.h); none where columns are missing.
std::vector<Figure> step_limit_figures(const Finding& finding);
std::vector<Figure> stability_figures(const Finding& finding);
std::vector<Figure> contact_stability_figures(const Finding& finding);
std::vector<Figure> aliasing_figures(const Finding& finding);
std::vector<Figure> frequency_response_figures(const Finding& finding);
std::vector<Figure> budget_figures(const Finding& finding);
std::vector<Figure> damping_figures(const Finding& finding);
std::vector<Figure> amplitude_figures(const Finding& finding);
std::vector<Figure> collision_figures(const Finding& finding);
std::vector<Figure> contact_figures(const Finding& finding);
std::vector<Figure> force_history_figures(const Finding& finding);
std::vector<Figure> contact_time_figures(const Finding& finding);

}  // namespace mb
