// Columns of analyses' tables whose numbers have no error bar beside them, each with the reason why it needs none.
#pragma once

#include <string>

#include "reports/views.h"

namespace mb {

// "" where none is known: such a number is not to be trusted before it has a bar or a reason.
std::string reason_without_bar(const std::string& table, const std::string& column);

// table, column, unit, why; a row for every column that has numbers with a unit in some table of the input and a bar
// nowhere.
Sheet unbarred_columns(const std::vector<Finding>& findings);

}  // namespace mb
