// Who competes in a case: every reduced method at every mode count, every full-order rival on every mesh at every step.
#pragma once

#include <string>
#include <vector>

#include "cases/contract/record.h"

namespace mb {

// Grouped by resolution, so that each mesh is made once.
std::vector<Contender> contenders(const Scene& scene);

// The truths `finer` and, on the body's mesh, the one at the scene's tolerance, under whose names their own marks
// stand.
std::vector<Contender> truth_contenders(const Scene& scene);

std::string label(const Contender& contender);  // "static-correction r=32 exact Q4 1x4"
bool is_full_order(const Contender& contender);

}  // namespace mb
