// The hard cases of an evaluation (Scene::hard): what is hard, what must hold, and whether it did. A verdict is that of
// the case's own checks, and of its runs: numbers which are not finite are never stored as such, an instability is a
// status.
#pragma once

#include "reports/views.h"

namespace mb {

Sheet hard_cases_table(const Evaluation& evaluation);  // without rows where no case is hard

// Which integrators each of them went through, in full order and in modes: runs, cells of its stability maps and runs
// beside the limits of their steps, and how many of each are unstable.
Sheet hard_integrators_table(const Evaluation& evaluation);

}  // namespace mb
