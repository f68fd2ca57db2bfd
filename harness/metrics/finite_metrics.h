// What only the motion of finite strain and rotation is asked for: linear steps have an amplification that foretells
// whether they grow, these have none, and average acceleration may gain, too.
//
// Once the last load has ended, at t0, energy only falls: of E, kinetic and stored,
//   gain = (max_{t >= t0} E(t) - E(t0)) / max_{t <= t0} E(t)   [-]
#pragma once

#include <vector>

#include "harness/metrics/metric.h"

namespace mb {

// "free-gain", of bodies of finite kinematics alone.
std::vector<Metric> finite_metrics();

// The gain above. NaN where loads do not end before the last time or a support is driven, where the scene has weight or
// contacts, whose energy is not in E, and where E was not recorded, as of modes, or is 0.
double free_gain(const Trajectory& answer, const Scene& scene);

}  // namespace mb
