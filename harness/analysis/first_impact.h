// The first contact of one answer in four numbers.
#pragma once

#include "cases/contract/method.h"

namespace mb {

struct FirstImpact {
  double start, duration, peak, impulse;  // [s], [s], [N], [N s]; NaN where it has none, or failed
};
// Of the first body, as the metrics of contact count touches (contact_metrics.h); the truth may be the answer itself.
FirstImpact first_impact(const Trajectory& answer, const Trajectory& truth);

}  // namespace mb
