// How a contender is named in a table: method, integrator, mesh and settings, a column each.
#pragma once

#include <vector>

#include "cases/scene/scene.h"
#include "reports/sheet.h"

namespace mb {

std::vector<Column> contender_columns();

// As many cells as contender_columns(); empty where a setting does not apply or a number was not recorded.
std::vector<Cell> contender_cells(const Contender& contender, int modes_used, long n_unknowns,
                                  Theory theory = Theory::solid);

}  // namespace mb
