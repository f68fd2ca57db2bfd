// The door of xxHash: 128-bit XXH3, which names runs by their content. Fast, not cryptographic: it finds damage, it
// does not stop a forger.
#pragma once

#include <string>
#include <string_view>

namespace mb {

std::string content_hash(std::string_view content);  // 32 hex digits 0-9 a-f, canonical (big-endian) order
bool is_content_hash(std::string_view text);         // whether text has that form, hence is safe as a file name

}  // namespace mb
