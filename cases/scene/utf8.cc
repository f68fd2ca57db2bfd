#include "cases/scene/utf8.h"

namespace mb {

namespace {

std::size_t n_bytes_of(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  if (lead >= 0xf0 && lead < 0xf5) return 4;
  return 0;
}

}  // namespace

CodePoint decode(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const CodePoint invalid{0xfffd, 1, false};
  const std::size_t n = n_bytes_of(byte(0));
  if (n == 0 || n > text.size() - at) return invalid;
  if (n == 1) return {byte(0), 1, true};
  auto value = static_cast<char32_t>(byte(0) & (0xff >> (n + 1)));
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return invalid;
    value = (value << 6) | (byte(i) & 0x3fu);
  }
  const bool overlong = (n == 3 && value < 0x800) || (n == 4 && value < 0x10000);
  const bool surrogate = value >= 0xd800 && value < 0xe000;
  if (overlong || surrogate || value > 0x10ffff) return invalid;
  return {value, n, true};
}

std::size_t n_code_points(std::string_view text) {
  std::size_t n = 0;
  for (std::size_t at = 0; at < text.size(); ++n) at += decode(text, at).bytes;
  return n;
}

}  // namespace mb
