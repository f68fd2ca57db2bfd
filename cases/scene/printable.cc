#include "cases/scene/printable.h"

#include <algorithm>

#include "cases/scene/utf8.h"

namespace mb {

namespace {

bool is_deceptive(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xad || c == 0x61c || (c >= 0x200b && c <= 0x200f) ||
         (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff || c >= 0xe0000;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string out;
  std::size_t n_characters = 0;
  for (std::size_t at = 0; at < text.size(); ++n_characters) {
    if (n_characters == most) return out + "...";
    const CodePoint c = decode(text, at);
    if (c.value == '\t') {
      out += ' ';
    } else if (!c.valid || is_deceptive(c.value)) {
      out += '?';
    } else {
      out += text.substr(at, c.bytes);
    }
    at += c.bytes;
  }
  return out;
}

std::string one_line(std::string_view text, std::size_t most_bytes) {
  std::string line(text.substr(0, most_bytes));
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return printable(line, line.size());
}

std::optional<char32_t> unprintable(std::string_view text, bool prose) {
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decode(text, at);
    const bool layout = c.value == '\n' || c.value == '\t' || text.substr(at).starts_with("\r\n");
    if (!c.valid || (is_deceptive(c.value) && !(prose && layout))) return c.value;
    at += c.bytes;
  }
  return std::nullopt;
}

}  // namespace mb
