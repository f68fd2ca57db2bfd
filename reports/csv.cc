#include <algorithm>

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
    if (!has_bar(column)) continue;
    names.push_back(csv_text(column.name + (column.kind == Column::Kind::time ? " spread" : " bar")));
    names.push_back(csv_text(column.name + " status"));
  }
  std::string text = line(names);
  for (const auto& row : table.rows) {
    std::vector<std::string> fields;
    for (std::size_t j = 0; j < row.size(); ++j) {
      fields.push_back(number_or_text(table.columns[j], row[j]));
      if (!has_bar(table.columns[j])) continue;
      fields.push_back(row[j].bar ? exact_number(*row[j].bar) : "");
      fields.push_back(csv_text(row[j].status));
    }
    text += line(fields);
  }
  return text;
}

}  // namespace mb
