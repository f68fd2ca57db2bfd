// Numbers that have no error bar beside them, column by column of analyses' tables and metric by metric of records, and
// the reason why they need none.
#pragma once

#include <string>

#include "reports/views.h"

namespace mb {

// "" where none is known: such a number is not to be trusted before it has a bar or a reason. Some reasons are those of
// single rows: where no number of the column has a bar (`of_all`) they are none.
std::string reason_without_bar(const std::string& table, const std::string& column, bool of_all);

// table, column, unit, numbers, those without a bar, why; a row for every column with a unit that has such in some
// table of the input, and for every metric that has such in some usable record, of the table "records".
Sheet unbarred_columns(const std::vector<Finding>& findings, const std::vector<Record>& records);

}  // namespace mb
