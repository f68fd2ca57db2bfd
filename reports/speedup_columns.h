// How the reduced run of a speed-up is named in a table: case, profile, truth, norm, body, then the contender.
#pragma once

#include <vector>

#include "reports/content.h"
#include "reports/sheet.h"

namespace mb {

std::vector<Column> speed_up_key_columns();
std::vector<Cell> speed_up_key_cells(const SpeedUp& one);  // as many

void append(std::vector<Cell>& row, std::vector<Cell> cells);

}  // namespace mb
