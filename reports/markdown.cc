#include "reports/render.h"

#include <algorithm>

namespace mb {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return is_letter(c) || is_digit(c); }
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }
bool is_numeric(const Column& column) { return column.kind != Column::Kind::text; }

// Characters with a meaning inside a line, where they have it: `<` and `&` that could begin a tag or an entity, `]`
// that could end the text of a link, `_` outside a word, and at its begin what makes a heading, list or rule. So "<=
// 1e-3", "[m/s]" and "not_finite" stay as they are.
bool needs_escape(std::string_view text, std::size_t i) {
  const char c = text[i];
  const char next = i + 1 < text.size() ? text[i + 1] : ' ';
  if (c == '<') return is_letter(next) || next == '/' || next == '!' || next == '?';
  if (c == '&') return is_letter(next) || next == '#';
  if (c == ']') return next == '(' || next == '[' || next == ':';
  if (c == '_') return i == 0 || !is_word(text[i - 1]) || !is_word(next);
  if (c == '#' || c == '>') return i == 0;
  if (c == '-' || c == '+' || c == '=') return i == 0 && text.size() > 1 && (next == ' ' || next == c);
  if (c == '.' || c == ')') return i > 0 && next == ' ' && std::ranges::all_of(text.substr(0, i), is_digit);
  return std::string_view("\\`*|~$").find(c) != std::string_view::npos;
}

std::string line(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

}  // namespace

std::string markdown_text(std::string_view text) {
  // Blanks at the begin of a line say nothing, but four of them that it is code.
  while (!text.empty() && (text.front() == ' ' || is_control(text.front()))) text.remove_prefix(1);
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_control(text[i])) {
      result += ' ';
      continue;
    }
    if (needs_escape(text, i)) result += '\\';
    result += text[i];
  }
  return result;
}

std::string markdown(const Sheet& table) {
  std::vector<std::string> names, rules;
  for (const Column& column : table.columns) {
    names.push_back(markdown_text(header(column)));
    rules.push_back(is_numeric(column) ? "---:" : "---");
  }
  std::string text = line(names) + line(rules);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const Cell& cell : row) cells.push_back(markdown_text(cell.text));
    text += line(cells);
  }
  return text;
}

}  // namespace mb
