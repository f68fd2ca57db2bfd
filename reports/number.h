// How numbers are printed for people. Files for machines carry the shortest text that reads back exactly.
#pragma once

#include <optional>
#include <string>

#include "cases/contract/record.h"

namespace mb {

// At most `digits` significant digits; powers of ten outside [1e-3, 1e5): 0.0123, 123, 4.56e-5. Not finite: "not
// finite".
std::string format_number(double value, int digits = 3);

// "340 to 370", "340 to unbounded"; "single run" where one end is NaN: a time without a spread is behind it.
std::string format_range(double low, double high);

std::string percent(double fraction);  // of a target: 0.05 is "5 %"

// A number that somebody chose: no more digits than it has, at most six. 0.0025, 1e-6.
std::string format_setting(double value);

// Shortest decimal that reads back to the same double; "" where not finite.
std::string exact_number(double value);

// No more digits than the bar supports (1 to 3); "<= |value| + bar" where |value| is below it; "value +- unknown", with
// its sign, where it is infinite.
std::string format_with_bar(double value, std::optional<double> bar);

// format_with_bar; "failed (status)", "failed" or "undefined" where the record has no number to show. Reasons that are
// sentences stand once, in the table of failures.
std::string format_record(const Record& record);

}  // namespace mb
