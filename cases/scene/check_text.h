// A case file is UTF-8 text without control characters other than tab and line ends.
#pragma once

#include <string_view>

#include "cases/scene/diagnostics.h"

namespace mb {

// Records the first byte or character that may not stand there; whether there was none.
bool check_text(std::string_view text, Findings& findings);

}  // namespace mb
