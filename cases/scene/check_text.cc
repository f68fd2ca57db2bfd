#include "cases/scene/check_text.h"

#include <fmt/format.h>

#include "cases/scene/utf8.h"

namespace mb {

bool check_text(std::string_view text, Findings& findings) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    findings.error({}, "the file is empty");
    return false;
  }
  Position here{1, 1, 1};
  for (std::size_t at = 0; at < text.size(); ++here.column) {
    const CodePoint c = decode(text, at);
    if (!c.valid) {
      findings.error(here, fmt::format("byte 0x{:02x} is not UTF-8", static_cast<unsigned char>(text[at])));
      return false;
    }
    const bool line_end = c.value == '\n' || (c.value == '\r' && text.substr(at).starts_with("\r\n"));
    if ((c.value < 0x20 && c.value != '\t' && !line_end) || c.value == 0x7f) {
      findings.error(here, fmt::format("control character U+{:04X}", static_cast<unsigned>(c.value)));
      return false;
    }
    at += c.bytes;
    if (c.value == '\n') here = {here.line + 1, 0, 1};
  }
  return true;
}

}  // namespace mb
