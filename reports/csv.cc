#include <algorithm>
#include <utility>

#include "cases/scene/utf8.h"
#include "reports/number.h"
#include "reports/render.h"

namespace mb {
namespace {

// What a terminal or spreadsheet would obey. Line ends and tabs are cells' own business.
bool is_control(char c) {
  return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t') || c == 0x7f;
}

// Behind blanks of any width, one of those that a spreadsheet takes for the begin of a formula, wide forms included.
bool begins_formula(std::string_view field) {
  static constexpr std::u32string_view blanks = U" \u00a0\u1680\u202f\u205f\u3000";
  static constexpr std::u32string_view begins = U"=+-@\t\r\n\uff1d\uff0b\uff0d\uff20";
  for (std::size_t at = 0; at < field.size();) {
    const CodePoint c = decode(field, at);
    const bool blank = blanks.find(c.value) != blanks.npos || (c.value >= 0x2000 && c.value <= 0x200a);
    if (!c.valid || !blank) return c.valid && begins.find(c.value) != begins.npos;
    at += c.bytes;
  }
  return false;
}

bool has_bar(const Column& column) { return column.kind == Column::Kind::error || column.kind == Column::Kind::time; }

// Columns of their own behind the number: of an uncertainty, or of what one leaves.
std::vector<std::string> headers_behind(const Column& column) {
  const std::string& name = column.name;
  if (column.kind == Column::Kind::quotient) return {name + " low", name + " high"};
  if (!has_bar(column)) return {};
  return {name + (column.kind == Column::Kind::time ? " spread" : " bar"), name + " status"};
}

std::string number_or_nothing(const std::optional<double>& value) { return value ? exact_number(*value) : ""; }

std::vector<std::string> fields_behind(const Column& column, const Cell& cell) {
  if (column.kind == Column::Kind::quotient) return {number_or_nothing(cell.low), number_or_nothing(cell.high)};
  if (!has_bar(column)) return {};
  return {number_or_nothing(cell.bar), csv_text(cell.status)};
}

std::string line(const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& field : fields) {
    if (&field != &fields.front()) text += ',';
    text += field;
  }
  return text + "\n";
}

std::string number_or_text(const Column& column, const Cell& cell) {
  if (cell.value) return exact_number(*cell.value);
  return has_bar(column) ? "" : csv_text(cell.text);  // the status column says why there is no number
}

}  // namespace

std::string csv_text(std::string_view text) {
  std::string field(text);
  std::ranges::replace_if(field, is_control, ' ');
  if (begins_formula(field)) field.insert(field.begin(), '\'');
  if (field.find_first_of(",;\t\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv(const Sheet& table) {
  std::vector<std::string> names;
  for (const Column& column : table.columns) {
    names.push_back(csv_text(header(column)));
    for (const std::string& name : headers_behind(column)) names.push_back(csv_text(name));
  }
  std::string text = line(names);
  for (const auto& row : table.rows) {
    std::vector<std::string> fields;
    for (std::size_t j = 0; j < row.size(); ++j) {
      fields.push_back(number_or_text(table.columns[j], row[j]));
      for (std::string& field : fields_behind(table.columns[j], row[j])) fields.push_back(std::move(field));
    }
    text += line(fields);
  }
  return text;
}

}  // namespace mb
