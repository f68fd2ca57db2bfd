// A body's motion taken apart for comparison: pose and deformation at every time.
#pragma once

#include <vector>

#include "harness/metrics/metric.h"
#include "harness/metrics/pose.h"

namespace mb {

struct FramedMotion {
  std::vector<RigidFrame> frames;  // one a time; of a body that is not free: at rest
  MatrixXd volume;                 // [m] 3 p_volume x n_t deformation
  MatrixXd surface;                // [m] 3 p_surface x n_t, in the same frames
};

FramedMotion motion(const Trajectory& trajectory, const MetricContext& context);

// [m^3] weights of eps^T D eps over a body, D outside of inclusions: those of the rule times the factor on stiffness.
VectorXd stiffness_weights(const Material& material, const Quadrature& volume);

}  // namespace mb
