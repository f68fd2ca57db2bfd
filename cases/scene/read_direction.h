// A direction: three numbers, not all zero, of any length.
#pragma once

#include "cases/scene/section.h"

namespace mb {

std::optional<Vector3d> read_direction(Section& section, const std::string& key);  // normalised

}  // namespace mb
