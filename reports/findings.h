// What analyses found (cases/contract/finding.h) as tables of the report, in the report's order: error budget, step
// limits, temporal aliasing, frequency response, damping, mode amplitudes, collision cost, contact forces, natural
// frequencies, extremes of probes, then whatever else there is.
#pragma once

#include <string>
#include <vector>

#include "reports/sheet.h"
#include "reports/views.h"

namespace mb {

// A column is one of numbers where any cell is a number. NaN prints "n/a", infinity "unbounded". Case and profile go
// into the title, what it is held to and how uncertain that is into the note; a bar stands beside its number: "0.12 +-
// 0.02". The name is a file stem: "cylinder-shear-step-limits".
Sheet sheet_of(const Finding& finding);

struct FindingGroup {
  std::string analysis, heading;         // "step-limits", "Step limits"
  std::vector<const Finding*> findings;  // as old as the evaluation
};
std::vector<FindingGroup> finding_groups(const Evaluation& evaluation);
bool stands_before_speed_up(const std::string& analysis);

// Files of one case in several profiles get the profile into their names.
std::string file_stem(const Evaluation& evaluation, const Finding& finding);

inline constexpr std::size_t longest_text_table = 60, longest_page_table = 400;  // rows

// The part of a table that a text report shows: the first `most` rows, and a sentence in the note where there are more.
Sheet shortened(const Sheet& table, std::size_t most, const std::string& whole);

// A name that came from a store as part of a file name.
std::string file_part(const std::string& text);

// Cells by the name of their column; NaN and "" where there is no such column or cell.
std::optional<std::size_t> column_of(const Finding& finding, const std::string& name);
double number_at(const Finding& finding, std::size_t row, const std::string& column);
double bar_at(const Finding& finding, std::size_t row, std::size_t column);  // NaN where it has none
std::string text_at(const Finding& finding, std::size_t row, const std::string& column);

}  // namespace mb
