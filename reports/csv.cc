#include <algorithm>

#include "reports/number.h"
#include "reports/render.h"

namespace mb {
namespace {

// What a terminal or spreadsheet would obey. Line ends and tabs are cells' own business.
bool is_control(char c) {
  return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t') || c == 0x7f;
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
  const auto first = std::min(field.find_first_not_of(' '), field.size());
  const bool is_formula =
      first < field.size() && std::string_view("=+-@\t\r\n").find(field[first]) != std::string_view::npos;
  if (is_formula) field.insert(field.begin(), '\'');
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
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
