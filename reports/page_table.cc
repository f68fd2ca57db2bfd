// Tables in the page's data, made small.
#include <fmt/format.h>

#include <cmath>

#include "cases/json/json.h"
#include "reports/page.h"

namespace mb {
namespace {

const char* name_of(Column::Kind kind) {
  switch (kind) {
    case Column::Kind::text:
      return "text";
    case Column::Kind::number:
    case Column::Kind::quotient:
      return "number";
    case Column::Kind::error:
      return "error";
    case Column::Kind::time:
      return "time";
  }
  return "text";
}

Json rounded_or_null(const std::optional<double>& value) { return value ? rounded(*value) : Json(nullptr); }

// A cell is "text", [text, value], [text, value, bar] or [text, value, bar, status]; status "ok" is left out.
Json cell_json(const Cell& cell) {
  const bool has_status = !cell.status.empty() && cell.status != "ok";
  if (!cell.value && !cell.bar && !has_status) return cell.text;
  Json json = Json::array({cell.text, rounded_or_null(cell.value)});
  if (cell.bar || has_status) json.push_back(rounded_or_null(cell.bar));
  if (has_status) json.push_back(cell.status);
  return json;
}

// Where a column holds few different cells, they stand once in its pool and the rows hold their places: whole numbers,
// as no cell is by itself.
struct Pooled {
  Json rows;   // arrays of cells
  Json pools;  // one a column: an array, or null where it is not pooled
};

Pooled pooled(Json rows, std::size_t n_columns) {
  Json pools = Json::array();
  for (std::size_t j = 0; j < n_columns; ++j) {
    std::map<std::string, std::size_t> places;
    Json pool = Json::array();
    for (const Json& row : rows) {
      if (places.try_emplace(to_line(row[j]), places.size()).second) pool.push_back(row[j]);
    }
    const bool worth_it = 3 * places.size() < rows.size();
    if (worth_it) {
      for (Json& row : rows) row[j] = places.at(to_line(row[j]));
    }
    pools.push_back(worth_it ? std::move(pool) : Json(nullptr));
  }
  return {std::move(rows), std::move(pools)};
}

}  // namespace

Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);  // stod throws below 2.2e-308
}

Json table_json(const Sheet& table) {
  Json columns = Json::array(), rows = Json::array();
  for (const Column& column : table.columns) {
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"kind", name_of(column.kind)}});
  }
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const Cell& cell : row) cells.push_back(cell_json(cell));
    rows.push_back(std::move(cells));
  }
  Pooled all = pooled(std::move(rows), table.columns.size());
  return {{"name", table.name}, {"title", table.title}, {"note", table.note},
          {"columns", columns}, {"pools", all.pools},   {"rows", all.rows}};
}

}  // namespace mb
