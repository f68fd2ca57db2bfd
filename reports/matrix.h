// Every contender on every case at a glance: symbol and number, so that nothing depends on colour.
//
//   ✔ within 1 % with its error bar   ▲ not   ⚡ unstable   ✘ failed   – not run in this case   ? undefined
#pragma once

#include <string>

#include "reports/views.h"

namespace mb {

// Least displacement error of any run of the family against the headline's truth, with the setting that gave it; of the
// others how many were unstable or failed.
Sheet matrix_table(const Evaluation& evaluation);

}  // namespace mb
