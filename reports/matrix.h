// Every contender on every case at a glance: symbol and number, so that nothing depends on colour.
//
//   ✔ within 1 %   ▲ above   ⚡ unstable   ✘ failed   – not run in this case   ? undefined
#pragma once

#include <string>

#include "reports/views.h"

namespace mb {

inline constexpr double blown_up = 1e3;  // [-] error of a finite answer that has left the truth by this factor

// Least displacement error of any run of the family against the headline's truth, with the setting that gave it; of the
// others how many were unstable (not finite, or an error above blown_up) or failed.
Sheet matrix_table(const Evaluation& evaluation);

}  // namespace mb
