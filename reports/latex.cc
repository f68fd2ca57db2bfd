#include <algorithm>

#include "reports/render.h"

namespace mb {
namespace {

std::string escaped(char c) {
  switch (c) {
    case '\\':
      return "\\textbackslash{}";
    case '~':
      return "\\textasciitilde{}";
    case '^':
      return "\\textasciicircum{}";
    case '<':
      return "\\textless{}";
    case '>':
      return "\\textgreater{}";
    case '|':
      return "\\textbar{}";
    case '"':
      return "\\textquotedbl{}";
    case '`':
      return "\\textasciigrave{}";
    case '{':
    case '}':
    case '$':
    case '&':
    case '#':
    case '_':
    case '%':
      return std::string("\\") + c;
    case '[':
    case ']':
    case '*':
      return std::string("{") + c + "}";  // after \\ a bracket would be an optional argument, a star its own form
    default:
      return static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? " " : std::string(1, c);
  }
}

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) text += (text.empty() ? "" : " & ") + (cell.empty() ? "{}" : cell);
  return text + " \\\\\n";
}

}  // namespace

std::string latex_text(std::string_view text) {
  // Symbols of the report's own words, which fonts of T1 encoding lack.
  static constexpr std::pair<std::string_view, const char*> symbols[] = {
      {"<=", "$\\le$"},      {">=", "$\\ge$"},     {"±", "$\\pm$"},    {"✔", "$\\surd$"},
      {"▲", "$\\triangle$"}, {"⚡", "$\\uparrow$"}, {"✘", "$\\times$"}, {"–", "--"}};
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto* symbol = std::find_if(std::begin(symbols), std::end(symbols),
                                      [&](const auto& one) { return text.substr(i).starts_with(one.first); });
    if (symbol != std::end(symbols)) {
      result += symbol->second;
      i += symbol->first.size();
    } else {
      result += escaped(text[i++]);
    }
  }
  return result;
}

std::string latex(const Sheet& table) {
  std::string alignment;
  std::vector<std::string> names;
  for (const Column& column : table.columns) {
    alignment += column.kind == Column::Kind::text ? 'l' : 'r';
    names.push_back(latex_text(header(column)));
  }
  std::string text = "% \\usepackage[T1]{fontenc} \\usepackage{booktabs,longtable,textcomp}\n";
  text += "\\begin{longtable}{" + alignment + "}\n";
  text += "\\caption{" + latex_text(table.title) + ". " + latex_text(table.note) + "}\\\\\n\\toprule\n";
  text += line(names) + "\\midrule\\endhead\n\\bottomrule\\endfoot\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const Cell& cell : row) cells.push_back(latex_text(cell.text));
    text += line(cells);
  }
  return text + "\\end{longtable}\n";
}

}  // namespace mb
