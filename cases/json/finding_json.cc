#include "cases/json/finding_json.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/json/json.h"
#include "cases/json/members.h"
#include "cases/scene/printable.h"

namespace mb {

namespace {

constexpr std::size_t max_columns = 64;
constexpr std::size_t max_rows = 100000;
constexpr std::size_t max_text = 4096;  // [bytes]

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Json cell_json(const FindingCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return one_line(*text, max_text);
  const double value = std::get<double>(cell);
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return nullptr;
  return {{"special", value > 0 ? "inf" : "-inf"}};
}

FindingCell cell_from(const Json& json, const char* key) {
  if (json.is_string()) return text(json, key);
  if (json.is_number()) {
    if (!std::isfinite(json.get<double>())) refuse(key, "hold a number that is not finite");
    return json.get<double>();
  }
  if (json.is_null()) return not_a_number;
  const Json special = json.is_object() && json.size() == 1 ? json.value("special", Json()) : Json();
  if (special == "inf") return infinity;
  if (special == "-inf") return -infinity;
  refuse(key, "hold a cell that is no text, no number, not null and none of the named specials");
}

Json columns_json(const std::vector<FindingColumn>& columns) {
  Json json = Json::array();
  for (const FindingColumn& column : columns) json.push_back({{"name", column.name}, {"unit", column.unit}});
  return json;
}

const Json& array_of(Members& members, const char* key, std::size_t least, std::size_t most) {
  const Json& json = members.get(key);
  if (!json.is_array() || json.size() < least || json.size() > most) {
    refuse(key, "is not a list of " + std::to_string(least) + " to " + std::to_string(most) + " entries");
  }
  return json;
}

std::vector<FindingColumn> columns_from(Members& members) {
  std::vector<FindingColumn> columns;
  for (const Json& json : array_of(members, "columns", 1, max_columns)) {
    Members column(json, "columns");
    columns.push_back({column.text("name"), column.text("unit")});
    column.expect_no_more();
  }
  return columns;
}

std::vector<std::vector<FindingCell>> rows_from(Members& members, std::size_t n_columns) {
  std::vector<std::vector<FindingCell>> rows;
  for (const Json& json : array_of(members, "rows", 0, max_rows)) {
    if (!json.is_array() || json.size() != n_columns) refuse("rows", "has a row that is not as long as the columns");
    auto& row = rows.emplace_back();
    for (const Json& cell : json) row.push_back(cell_from(cell, "rows"));
  }
  return rows;
}

// As rows, null where a cell has none, infinite where it is unknown.
Json bars_json(const std::vector<std::vector<double>>& bars) {
  Json json = Json::array();
  for (const auto& row : bars) {
    Json& cells = json.emplace_back(Json::array());
    for (const double bar : row) cells.push_back(cell_json(bar));
  }
  return json;
}

std::vector<std::vector<double>> bars_from(Members& members, std::size_t n_rows, std::size_t n_columns) {
  const Json& all = array_of(members, "bars", 0, n_rows);
  if (!all.empty() && all.size() != n_rows) refuse("bars", "are not as many as the rows");
  std::vector<std::vector<double>> bars;
  for (const Json& json : all) {
    if (!json.is_array() || json.size() != n_columns) refuse("bars", "have a row that is not as long as the columns");
    auto& row = bars.emplace_back();
    for (const Json& cell : json) {
      const FindingCell bar = cell_from(cell, "bars");
      const auto* number = std::get_if<double>(&bar);
      if (!number || *number < 0) refuse("bars", "hold what is neither null, infinite nor a number from 0");
      row.push_back(*number);
    }
  }
  return bars;
}

Json footing_json(const Footing& footing) {
  return {{"reference", footing.reference}, {"kind", footing.kind}, {"uncertainty", footing.uncertainty}};
}

Footing footing_from(Members& members) {
  Members footing(members.get("footing"), "footing");
  const Footing read{footing.text("reference"), footing.text("kind"), footing.text("uncertainty")};
  footing.expect_no_more();
  return read;
}

std::string name_of(Members& members, const char* key) {
  std::string name = members.name(key);
  if (name.empty()) refuse(key, "is empty");
  return name;
}

void require_size(std::size_t size, std::size_t most, const std::string& what) {
  if (size > most) throw std::invalid_argument("finding: " + what + " beyond " + std::to_string(most));
}

void require_bounds(const Finding& finding) {
  if (finding.columns.empty()) throw std::invalid_argument("finding: no columns");
  require_size(finding.columns.size(), max_columns, "columns");
  require_size(finding.rows.size(), max_rows, "rows");
  const auto& [reference, kind, uncertainty] = finding.footing;
  for (const std::string* text : {&finding.title, &finding.note, &reference, &kind, &uncertainty})
    require_size(text->size(), max_text, "bytes of text");
  if (!finding.bars.empty() && finding.bars.size() != finding.rows.size())
    throw std::invalid_argument("finding: bars not as many as rows");
  for (const auto& row : finding.bars)
    if (row.size() != finding.columns.size()) throw std::invalid_argument("finding: bars not as long as the columns");
  for (const auto& column : finding.columns)
    for (const std::string* text : {&column.name, &column.unit}) require_size(text->size(), max_text, "bytes of text");
  for (const auto& row : finding.rows) {
    if (row.size() != finding.columns.size()) throw std::invalid_argument("finding: a row not as long as the columns");
    for (const FindingCell& cell : row) {
      if (const auto* text = std::get_if<std::string>(&cell)) require_size(text->size(), max_text, "bytes of a cell");
    }
  }
}

}  // namespace

Json to_json(const Finding& finding) {
  require_bounds(finding);
  Json json;
  json["schema"] = finding_schema;
  json["run"] = finding.run;
  json["analysis"] = finding.analysis;
  json["name"] = finding.name;
  json["title"] = finding.title;
  json["note"] = one_line(finding.note, max_text);  // what failed may be told in several lines
  json["case"] = finding.case_name;
  json["profile"] = finding.profile;
  json["columns"] = columns_json(finding.columns);
  json["rows"] = Json::array();
  for (const auto& row : finding.rows) {
    Json cells = Json::array();
    for (const FindingCell& cell : row) cells.push_back(cell_json(cell));
    json["rows"].push_back(std::move(cells));
  }
  json["bars"] = bars_json(finding.bars);
  json["footing"] = footing_json(finding.footing);
  json["provenance"] = finding.provenance;
  return json;
}

Finding finding_from_json(const Json& json) {
  Members members(json, "finding");
  members.integer("schema", finding_schema, finding_schema);
  Finding finding;
  finding.run = members.hash("run");
  finding.analysis = name_of(members, "analysis");
  finding.name = name_of(members, "name");
  finding.title = members.text("title");
  finding.note = members.text("note");
  finding.case_name = name_of(members, "case");
  finding.profile = members.one_of("profile", {"quick", "standard", "full"});
  finding.columns = columns_from(members);
  finding.rows = rows_from(members, finding.columns.size());
  finding.bars = bars_from(members, finding.rows.size(), finding.columns.size());
  finding.footing = footing_from(members);
  finding.provenance = members.texts("provenance");
  members.expect_no_more();
  return finding;
}

}  // namespace mb
