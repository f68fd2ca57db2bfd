// What became of a check, in cells and words.
#pragma once

#include "reports/content.h"
#include "reports/sheet.h"

namespace mb {

std::string bound(const Check& check);  // "<= 0.01"
Cell measured_cell(const CheckResult& result);
Cell bar_cell(const CheckResult& result);        // "" where there is none
std::string verdict(const CheckResult& result);  // "holds", "does not hold", "failed (...)", ...

}  // namespace mb
