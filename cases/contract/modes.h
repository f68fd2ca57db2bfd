// Natural modes of one body:   K phi = lambda M phi,   lambda = omega^2,   Phi^T M Phi = I.
#pragma once

#include "mechanics/types.h"

namespace mb {

// lambda_{i+1} and lambda_i belong to one multiplet where they differ by at most this part of the larger.
inline constexpr double multiplet_gap = 1e-6;

struct Modes {
  Index n_rigid = 0;      // the first n_rigid columns are rigid: omega = 0
  VectorXd omega;         // [rad/s] ascending
  MatrixXd Phi;           // n x number of modes
  VectorXd residual;      // [-] elastic: |K phi - lambda M phi| / |lambda M phi|; rigid: |K phi| / (lambda_1 |M phi|)
  double lambda_max = 0;  // [1/s^2] largest eigenvalue of (K, M), at most 3 % above it
  Index size() const { return omega.size(); }
};

}  // namespace mb
