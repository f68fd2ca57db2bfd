#include "cases/scene/printable.h"

#include <algorithm>

#include "cases/scene/utf8.h"

namespace mb {

namespace {

struct Span {
  char32_t first, last;
};
// Controls; soft hyphen, marks of direction, joiners; fillers of Hangul and vowels of Khmer that show nothing, a blank
// of Braille; selectors of variants; marks of annotations; tags.
constexpr Span deceptive[] = {{0x0, 0x1f},      {0x7f, 0x9f},       {0xad, 0xad},       {0x34f, 0x34f},
                              {0x61c, 0x61c},   {0x115f, 0x1160},   {0x17b4, 0x17b5},   {0x180b, 0x180f},
                              {0x200b, 0x200f}, {0x2028, 0x202e},   {0x2060, 0x206f},   {0x2800, 0x2800},
                              {0x3164, 0x3164}, {0xfe00, 0xfe0f},   {0xfeff, 0xfeff},   {0xffa0, 0xffa0},
                              {0xfff9, 0xfffb}, {0x1d173, 0x1d17a}, {0xe0000, 0x10ffff}};

bool is_deceptive(char32_t c) {
  return std::ranges::any_of(deceptive, [c](const Span& span) { return c >= span.first && c <= span.last; });
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
