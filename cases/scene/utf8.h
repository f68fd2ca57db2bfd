// UTF-8, strictly: overlong forms, surrogates and values above U+10FFFF are invalid.
#pragma once

#include <cstddef>
#include <string_view>

namespace mb {

struct CodePoint {
  char32_t value;
  std::size_t bytes;  // in [1, 4]; 1 where invalid
  bool valid;
};
CodePoint decode(std::string_view text, std::size_t at);  // at < text.size()

std::size_t n_code_points(std::string_view text);  // an invalid byte counts as one

}  // namespace mb
