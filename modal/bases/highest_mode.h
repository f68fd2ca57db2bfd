// The mode of highest frequency, on which the step of explicit schemes depends.
#pragma once

#include "mechanics/system/system.h"

namespace mb {

// A mode of the mass with which the integrator steps, phi^T M phi = 1.
struct SteppedMode {
  double omega, zeta;  // [rad/s], [-]
  VectorXd phi, M_phi;
};

// By Lanczos on M^-1 K; zeta by C of the system.
SteppedMode highest_mode(const System& system);

}  // namespace mb
