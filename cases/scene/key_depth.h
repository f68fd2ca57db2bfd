// Dotted keys nest a table a dot. A file of one megabyte may nest half a million of them, which overflows the stack of
// any recursive parser: such a key is found before parsing.
#pragma once

#include <optional>
#include <string_view>

#include "cases/scene/diagnostics.h"

namespace mb {

// Position of the first key with more than `most` dots outside strings and comments; a number holds one dot.
std::optional<Position> too_deep_key(std::string_view text, int most);

}  // namespace mb
