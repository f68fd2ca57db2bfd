// Natural modes of one body:   K phi = lambda M phi,   lambda = omega^2,   Phi^T M Phi = I.
#pragma once

#include <algorithm>
#include <limits>

#include "mechanics/types.h"

namespace mb {

// Neighbours in one multiplet, lambda_{i+1} - lambda_i <= max(1e-6 lambda_{i+1}, eps lambda_max): what rounding of a
// spectrum of that width cannot tell apart has no frequencies, and no shapes, of its own. lambda_max 0: not known.
inline constexpr double multiplet_gap = 1e-6;
inline bool are_one_multiplet(double lambda, double next, double lambda_max = 0) {
  const double rounding = std::numeric_limits<double>::epsilon() * lambda_max;
  return next - lambda <= std::max(multiplet_gap * next, rounding);
}

struct Modes {
  Index n_rigid = 0;      // the first n_rigid columns are rigid: omega = 0
  VectorXd omega;         // [rad/s] ascending
  MatrixXd Phi;           // n x number of modes
  VectorXd residual;      // [-] elastic: |K phi - lambda M phi| / |lambda M phi|; rigid: |K phi| / (lambda_1 |M phi|)
  double lambda_max = 0;  // [1/s^2] largest eigenvalue of (K, M), at most 3 % above it
  Index size() const { return omega.size(); }
};

}  // namespace mb
