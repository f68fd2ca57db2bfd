// What contacts may not do to momentum, by the answer's own mass (BodyTrajectory::momentum), whatever the mesh:
//
//   P(t) - P(0) = J(t)  of a free body,   J_a + J_b = 0  of two that meet,   sum P, sum L constant  of free bodies
//   alone
//
// P less the weight's, J impulse of contacts since t = 0. While contacts press J is interpolated between the steps that
// the momentum is handed over in: of a single body it is looked at where nothing presses.
#pragma once

#include "harness/metrics/metric.h"

namespace mb {

// [-] by the largest impulse. NaN of a held body that meets none, where momenta were not recorded or loads act.
double momentum_drift(const Trajectory& answer, const Trajectory& truth, const MetricContext& context);
// [-] by the largest impulse times the body's extent. NaN for scenes with anything but free bodies and their contacts.
double angular_drift(const Trajectory& answer, const Trajectory& truth, const MetricContext& context);

}  // namespace mb
