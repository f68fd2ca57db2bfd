// Exact time integration of a system with few degrees of freedom: K phi = lambda M phi, then every mode in closed form
//
//   q_i'' + c_i q_i' + lambda_i q_i = phi_i^T F s(t),   c_i = alpha + beta lambda_i (0 for rigid modes)
//
// on each segment of s(t), or its exact means over time. Damping that couples modes: their complex modes in closed form
// (complex_modes.h). Systems with M = I and diagonal K skip the eigenproblem.
#pragma once

#include <memory>

#include "mechanics/system/system.h"

namespace mb {

// load_tolerance [-]: error allowed in resampling chirps and expressions (history.h: load_error); duration [s] > 0
// bounds the times that may be asked for. Throws std::invalid_argument for a dense eigenproblem of n > 6000, for sizes
// that disagree and for times out of order or range; std::runtime_error where the rigid modes are not those which R
// states, and what complex_modes.h throws. Work: steps counts closed forms evaluated, one a mode and output time or
// piece of the load passed; load_evaluations counts segments of s(t) projected, one a load and piece.
std::unique_ptr<Stepper> exact(const System& system, double duration, double load_tolerance = 1e-6);

}  // namespace mb
