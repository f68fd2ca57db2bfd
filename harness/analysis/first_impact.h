// The first contact of one answer in four numbers.
#pragma once

#include "harness/analysis/analysis.h"

namespace mb {

struct FirstImpact {
  double start, duration, peak, impulse;  // [s], [s], [N], [N s]; NaN where it has none, or failed
};
// Of the first body, as the metrics of contact count touches (contact_metrics.h); the truth may be the answer itself.
FirstImpact first_impact(const Trajectory& answer, const Trajectory& truth);

// [-] How far an answer on the body's mesh may be off in one of them for that mesh: what full order has on the truth's,
// by own_bars_per_distance (modal_body.h); infinite where one of them has no such number.
double mesh_bar(const AnalysisContext& context, double FirstImpact::*part);

}  // namespace mb
