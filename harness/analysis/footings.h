// What the numbers of each table are held to, and how uncertain they are.
#pragma once

#include <map>
#include <string>

#include "cases/contract/finding.h"

namespace mb {

Footing footing_of(const Finding& table);  // by analysis and name; throws std::out_of_range naming what has none

std::map<std::string, std::string> analyses_of_tables();  // every table that checks may name, and who makes it

}  // namespace mb
