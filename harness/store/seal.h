// Text with its own checksum in a last line, so that a flipped bit is no other number and a file cut at a line's end no
// shorter list:
//
//   TEXT {"checksum":"<content_hash(TEXT)>"}
#pragma once

#include <string>
#include <string_view>

namespace mb {

// text: whole lines.
std::string sealed(std::string_view text);

// The text without its seal. Throws std::runtime_error where it has none or another's.
std::string unsealed(std::string_view text);

}  // namespace mb
