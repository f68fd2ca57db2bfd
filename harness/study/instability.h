// Whether a run is past the limit of its step. What is, is a result with a name of its own, "unstable", without a
// value:
//
//   by a conditionally stable integrator: not finite, more than 1000 off the truth, or growing more than tenfold in
//     free vibration over the run by theory (step_growth.h); of that which shows deformation or strain off by more
//     than the whole. What does not, however small it stayed, is so by theory alone: what would grow was not moved,
//     or has not grown yet. Theory of finite deformation knows rest alone, and counts for nothing there by itself
//   in contact, by any: energy above that at the start by more than the contact was brought, where nothing else brings
//     any (energy_fed, harness/metrics/contact_metrics.h)
//   of finite kinematics, by any: more energy gained once the last load has ended than there ever was until then
//     (harness/metrics/finite_metrics.h)
#pragma once

#include <vector>

#include "cases/contract/method.h"
#include "cases/contract/record.h"
#include "harness/study/step_growth.h"

namespace mb {

// marks: all measures of one run. fed [-]: energy that nothing brought; NaN where nothing is known.
enum class Limit { kept, passed, passed_by_theory };
Limit kept_limit(const std::vector<Record>& marks, const Integrator& integrator, const Grown& grown, double fed);

// Gives them the status of such a limit (cases/contract/status.h), neither value nor bar.
void name_unstable(std::vector<Record>& marks, Limit limit);

// Says of them that their steps may be past their limit, and nobody knows (is_growth_unknown of record.h).
void name_unknown(std::vector<Record>& marks);

}  // namespace mb
