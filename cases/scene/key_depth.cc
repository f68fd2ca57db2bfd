#include "cases/scene/key_depth.h"

#include <algorithm>
#include <cctype>

#include "cases/scene/utf8.h"

namespace mb {

namespace {

// Index behind the string that opens at `at`. An unclosed single-line string ends with its line: the parser will say
// so.
std::size_t behind_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = quote == '"' ? R"(""")" : "'''";
  const bool multiline = text.substr(at, 3) == three;
  for (std::size_t i = at + (multiline ? 3 : 1); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (multiline ? text.substr(i, 3) == three : text[i] == quote || text[i] == '\n') {
      if (!multiline) return text[i] == '\n' ? i : i + 1;
      const std::size_t content_quotes = std::min(text.find_first_not_of(quote, i), text.size()) - i - 3;
      return i + 3 + std::min<std::size_t>(content_quotes, 2);  // one or two quotes may end the content itself
    }
  }
  return text.size();
}

// Characters that may stand between the dots of one key.
bool in_key(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == ' ' || c == '\t';
}

Position position_of(std::string_view text, std::size_t at) {
  Position where{1, 1, 1};
  std::size_t line_start = 0;
  for (std::size_t i = 0; i < at; ++i) {
    if (text[i] != '\n') continue;
    ++where.line;
    line_start = i + 1;
  }
  where.column = 1 + static_cast<int>(n_code_points(text.substr(line_start, at - line_start)));
  return where;
}

}  // namespace

std::optional<Position> too_deep_key(std::string_view text, int most) {
  int n_dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = behind_string(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.' && ++n_dots > most) return position_of(text, at);
    if (c != '.' && !in_key(c)) n_dots = 0;
    ++at;
  }
  return std::nullopt;
}

}  // namespace mb
