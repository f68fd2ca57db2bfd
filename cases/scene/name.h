// Names of cases, bodies, metrics: [a-z0-9][a-z0-9-]{0,63}, so that none is an option of a command, a path or markup.
#pragma once

#include <algorithm>
#include <string_view>

namespace mb {

inline bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= 64 && text.front() != '-' &&
         std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

}  // namespace mb
