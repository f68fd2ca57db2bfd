#include "reports/findings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/number.h"

namespace mb {
namespace {

struct Section {
  const char *analysis, *heading;
  bool before_speed_up;
};
constexpr Section sections[] = {{"budget", "Error budget", true},
                                {"step-limits", "Step limits", true},
                                {"stability-map", "Stability", true},
                                {"aliasing", "Temporal aliasing", true},
                                {"frequency-response", "Frequency response", false},
                                {"damping", "Damping", false},
                                {"damping-coupling", "Damping that couples modes", false},
                                {"long-run", "A million steps", false},
                                {"multiplets", "Modes by two solvers", false},
                                {"aspect", "From compact to slender or flat", false},
                                {"locking", "Locking", false},
                                {"linearity", "Linear theory and finite strain", false},
                                {"mode-amplitudes", "Mode amplitudes", false},
                                {"collision-cost", "Collision cost", false},
                                {"contact-forces", "Contact forces", false},
                                {"contact", "Contact", false},
                                {"contact-stiffness", "Contact stiffness", false},
                                {"contact-stability", "Stability in contact", false},
                                {"flight-cost", "Cost of flight and of contact", false},
                                {"amplitude", "Where linear theory ends", false},
                                {"frequencies", "Natural frequencies", false},
                                {"probe-extremes", "Extremes at the probes", false},
                                {"instructions", "Instructions", false},
                                {"slenderness", "Polynomial modes over slenderness", false}};

std::ptrdiff_t place(const std::string& analysis) {
  return std::find_if(std::begin(sections), std::end(sections),
                      [&](const Section& s) { return analysis == s.analysis; }) -
         std::begin(sections);
}

std::string heading(const std::string& analysis) {
  const auto i = place(analysis);
  return i < std::ssize(sections) ? sections[i].heading : "Findings: " + analysis;
}

bool is_count(double value) { return value == std::floor(value) && std::abs(value) < 1e6; }

Cell cell_of(const FindingCell& cell, double bar) {
  if (const auto* text = std::get_if<std::string>(&cell)) return text_cell(*text);
  const double value = std::get<double>(cell);
  if (std::isnan(value)) return text_cell("n/a");
  if (std::isinf(value)) return text_cell(value > 0 ? "unbounded" : "unbounded below");
  if (is_count(value) && !(bar > 0)) return count_cell(std::lround(value));
  if (std::isinf(bar)) return {.text = format_with_bar(value, bar), .value = value, .status = "bar unknown"};
  if (bar > 0) {
    const std::string text = format_with_bar(value, bar), beside = " \u00b1 " + format_number(bar, 1);
    return {.text = std::abs(value) < bar ? text : text + beside, .value = value, .bar = bar};
  }
  return {.text = format_number(value, 4), .value = value};
}

std::string note_of(const Finding& finding) {
  std::string note = finding.note;
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) note += (note.empty() ? "" : " ") + std::string(what) + text + ".";
  };
  add("Held to: ", finding.footing.reference);
  add("Uncertainty: ", finding.footing.uncertainty);
  return note;
}

Column column_of(const Finding& finding, std::size_t j) {
  const FindingColumn& column = finding.columns[j];
  const bool numeric = std::any_of(finding.rows.begin(), finding.rows.end(),
                                   [&](const auto& row) { return j < row.size() && row[j].index() == 1; });
  bool barred = false;
  for (std::size_t i = 0; i < finding.rows.size(); ++i) barred = barred || bar_at(finding, i, j) > 0;
  using Kind = Column::Kind;
  return {column.name, column.unit, barred ? Kind::error : numeric ? Kind::number : Kind::text};
}

}  // namespace

Sheet sheet_of(const Finding& finding) {
  Sheet table{.name = file_part(finding.case_name) + "-" + file_part(finding.name),
              .title = finding.title + ": case " + finding.case_name + ", profile " + finding.profile,
              .note = note_of(finding),
              .columns = {},
              .rows = {},
              .n_keys = 0};
  for (std::size_t j = 0; j < finding.columns.size(); ++j) table.columns.push_back(column_of(finding, j));
  for (std::size_t i = 0; i < finding.rows.size(); ++i) {
    const auto& cells = finding.rows[i];
    std::vector<Cell>& row = table.rows.emplace_back();
    for (std::size_t j = 0; j < finding.columns.size(); ++j) {
      Cell& cell = row.emplace_back(j < cells.size() ? cell_of(cells[j], bar_at(finding, i, j)) : text_cell(""));
      if (!cell.value && table.columns[j].kind == Column::Kind::error) cell.status = cell.text;  // "unbounded" in CSV
    }
  }
  return table;
}

std::vector<FindingGroup> finding_groups(const Evaluation& evaluation) {
  std::map<std::pair<std::ptrdiff_t, std::string>, FindingGroup> found;
  for (const Finding& finding : evaluation.input.findings) {
    FindingGroup& group = found[{place(finding.analysis), finding.analysis}];
    group.analysis = finding.analysis;
    group.heading = heading(finding.analysis);
    group.findings.push_back(&finding);
  }
  std::vector<FindingGroup> groups;
  for (auto& [key, group] : found) {
    std::stable_sort(group.findings.begin(), group.findings.end(), [](const Finding* a, const Finding* b) {
      return std::tie(a->case_name, a->profile) < std::tie(b->case_name, b->profile);
    });
    groups.push_back(std::move(group));
  }
  return groups;
}

bool stands_before_speed_up(const std::string& analysis) {
  const auto i = place(analysis);
  return i < std::ssize(sections) && sections[i].before_speed_up;
}

std::string file_stem(const Evaluation& evaluation, const Finding& finding) {
  const std::string stem = sheet_of(finding).name;
  const auto& all = evaluation.input.findings;
  const bool twice = std::any_of(all.begin(), all.end(), [&](const Finding& other) {
    return other.case_name == finding.case_name && other.name == finding.name && other.profile != finding.profile;
  });
  return twice ? stem + "-" + file_part(finding.profile) : stem;
}

Sheet shortened(const Sheet& table, std::size_t most, const std::string& whole) {
  if (table.rows.size() <= most) return table;
  Sheet part = table;
  part.rows.resize(most);
  if (!part.note.empty()) part.note += ' ';
  part.note +=
      "The first " + std::to_string(most) + " of " + std::to_string(table.rows.size()) + " rows; all in " + whole + ".";
  return part;
}

std::string file_part(const std::string& text) {
  std::string part;
  for (const char c : text.substr(0, 64)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    part += plain ? c : '-';
  }
  return part;
}

std::optional<std::size_t> column_of(const Finding& finding, const std::string& name) {
  for (std::size_t j = 0; j < finding.columns.size(); ++j) {
    if (finding.columns[j].name == name) return j;
  }
  return std::nullopt;
}

double number_at(const Finding& finding, std::size_t row, const std::string& column) {
  const auto j = column_of(finding, column);
  const auto* value = j && *j < finding.rows[row].size() ? std::get_if<double>(&finding.rows[row][*j]) : nullptr;
  return value ? *value : std::numeric_limits<double>::quiet_NaN();
}

double bar_at(const Finding& finding, std::size_t row, std::size_t column) {
  const bool is_there = row < finding.bars.size() && column < finding.bars[row].size();
  return is_there ? finding.bars[row][column] : std::numeric_limits<double>::quiet_NaN();
}

std::string text_at(const Finding& finding, std::size_t row, const std::string& column) {
  const auto j = column_of(finding, column);
  const auto* text = j && *j < finding.rows[row].size() ? std::get_if<std::string>(&finding.rows[row][*j]) : nullptr;
  return text ? *text : "";
}

}  // namespace mb
