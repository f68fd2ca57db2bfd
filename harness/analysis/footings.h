// What the numbers of each table are held to, and how uncertain they are.
#pragma once

#include <string>

#include "cases/contract/finding.h"

namespace mb {

Footing footing_of(const std::string& table);  // throws std::out_of_range naming a table that has none

}  // namespace mb
