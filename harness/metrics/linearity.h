// How far from linear theory a motion is: its largest strain and its largest rotation of a piece of the body,
//
//   strain   = largest |eigenvalue| of eps over points and times
//   rotation = largest |curl u|/2 over points and times, u the deformation, polynomials of degree 3 fitted to it
//
// What they may be: cases/contract/linear_limits.h.
#pragma once

#include "harness/metrics/metric.h"

namespace mb {

double largest_strain(const Trajectory& trajectory, const MetricContext& context);    // [-]; NaN where it has none
double largest_rotation(const Trajectory& trajectory, const MetricContext& context);  // [rad] rigid motion taken out

}  // namespace mb
