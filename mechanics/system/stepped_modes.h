// What one step of a scheme makes of a system in modal coordinates: its elastic modes one by one (stability.h), or all
// together where damping couples them (one_step.h).
#pragma once

#include "mechanics/system/one_step.h"
#include "mechanics/system/stability.h"
#include "mechanics/system/system.h"

namespace mb {

struct SteppedModes {
  VectorXd omega, zeta;  // [rad/s], [-] of elastic modes; coupled: by the diagonal of C
  CoupledModes coupled;  // all modes, rigid ones first; 0 x 0 where damping couples none
  // [-] The part of zeta that is of the mass, where it does not lag and the rest does (central_difference.h); else
  // empty.
  VectorXd zeta_by_mean = {};
};

bool is_in_modes(const System& system);  // M = I, K diagonal

// The first R.cols() coordinates are rigid. Damping couples where an entry beside the diagonal is above 1e-8 of the
// larger of their coefficients: modes are known to about that. Throws std::invalid_argument where not is_in_modes.
SteppedModes stepped_modes(const System& system);

// Largest spectral radius [-] of a step h [s] > 0; 0 without elastic modes.
double step_radius(const SteppedModes& modes, const Scheme& scheme, double h);

}  // namespace mb
