// The hard cases of an evaluation (Scene::hard): what is hard, what must hold, and whether it did. A verdict is that of
// the case's own checks, and of its runs: numbers which are not finite are never stored as such, an instability is a
// status.
#pragma once

#include "reports/views.h"

namespace mb {

Sheet hard_cases_table(const Evaluation& evaluation);  // without rows where no case is hard

}  // namespace mb
