// Whether a run is past the limit of its step. What is, is a result with a name of its own, "unstable", without a
// value:
//
//   by a conditionally stable integrator: not finite, more than 1000 off the truth, or growing more than tenfold in
//     free vibration over the run by theory (step_growth.h), however small the run stayed
//   in contact, by any: E(t) + D(t) - E(0) above what the contact was brought, where nothing else brings energy; the
//     measure energy-gain (harness/metrics/contact_metrics.cc) above 1
#pragma once

#include <vector>

#include "cases/contract/method.h"
#include "cases/contract/record.h"
#include "cases/scene/scene.h"

namespace mb {

// marks: all measures of one run. growth [-]: NaN where theory knows none.
bool is_past_its_limit(const std::vector<Record>& marks, const Scene& scene, const Integrator& integrator,
                       double growth);

// Gives them that status, and no value.
void name_unstable(std::vector<Record>& marks);

}  // namespace mb
