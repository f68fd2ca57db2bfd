#include "reports/sheet.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/number.h"
#include "reports/runs.h"
#include "reports/times.h"

namespace mb {
namespace {

Sheet without_columns(const Sheet& table, const std::vector<bool>& keep) {
  Sheet result{.name = table.name, .title = table.title, .note = table.note, .columns = {}, .rows = {}};
  for (std::size_t j = 0; j < keep.size(); ++j) {
    if (keep[j]) result.columns.push_back(table.columns[j]);
  }
  for (const auto& row : table.rows) {
    std::vector<Cell>& kept = result.rows.emplace_back();
    for (std::size_t j = 0; j < keep.size(); ++j) {
      if (keep[j]) kept.push_back(row[j]);
    }
  }
  return result;
}

Sheet without_empty_columns(const Sheet& table) {
  std::vector<bool> keep(table.columns.size(), false);
  for (const auto& row : table.rows) {
    for (std::size_t j = 0; j < row.size(); ++j) keep[j] = keep[j] || !row[j].text.empty();
  }
  return without_columns(table, keep);
}

std::string bars(const Sheet& table) {
  std::string text;
  for (std::size_t j = 0; j < table.columns.size(); ++j) {
    if (table.columns[j].kind != Column::Kind::error) continue;
    double largest = 0;
    for (const auto& row : table.rows) largest = std::max(largest, row[j].bar.value_or(0));
    if (largest > 0) text += (text.empty() ? "" : ", ") + table.columns[j].name + " " + format_number(largest, 2);
  }
  return text.empty() ? "" : "Error bar of the truth (largest): " + text + ".";
}

}  // namespace

Cell text_cell(std::string text) { return {.text = std::move(text)}; }

Cell count_cell(long value) { return {.text = std::to_string(value), .value = static_cast<double>(value)}; }

Cell number_cell(std::optional<double> value) {
  return value ? Cell{.text = format_number(*value), .value = value} : Cell{.text = ""};
}

Cell setting_cell(double value) { return {.text = format_setting(value), .value = value}; }

Cell quotient_cell(double value, double low, double high) {
  Cell cell{.text = format_number(value) + " (" + format_range(low, high) + ")", .value = value};
  if (std::isfinite(low)) cell.low = low;
  if (std::isfinite(high)) cell.high = high;
  return cell;
}

Cell record_cell(const Record* record) {
  if (record == nullptr) return {.text = ""};
  Cell cell{.text = format_record(*record), .value = {}, .bar = record->error_bar, .status = record->status};
  if (is_usable(*record)) {
    cell.value = record->value;
    if (is_time(*record) && is_perturbed(*record)) {
      cell.text += ", perturbed";
      cell.status = "perturbed";
    }
  } else if (cell.status == "ok") {
    cell.status = "not_finite";
  }
  return cell;
}

std::vector<Sheet> split(const Sheet& table) {
  std::map<std::vector<std::string>, Sheet> groups;
  for (const auto& row : table.rows) {
    std::vector<std::string> key;
    std::string title = table.title;
    for (std::size_t j = 0; j < static_cast<std::size_t>(table.n_keys); ++j) {
      key.push_back(row[j].text);
      if (row[j].text.empty()) continue;  // a check on a table has no truth
      title += (j == 0 ? ": " : ", ") + table.columns[j].name + " " + row[j].text;
    }
    Sheet empty{.name = table.name, .title = title, .note = table.note, .columns = table.columns, .rows = {}};
    groups.try_emplace(key, std::move(empty)).first->second.rows.push_back(row);
  }
  std::vector<bool> keep(table.columns.size(), true);
  std::fill_n(keep.begin(), table.n_keys, false);
  std::vector<Sheet> result;
  for (const auto& [key, group] : groups) {
    Sheet part = without_empty_columns(without_columns(group, keep));
    const std::string largest = bars(part);
    if (!part.note.empty() && !largest.empty()) part.note += ' ';
    part.note += largest;
    result.push_back(std::move(part));
  }
  return result;
}

std::string header(const Column& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

}  // namespace mb
