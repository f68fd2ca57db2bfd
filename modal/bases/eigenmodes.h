// The lowest natural modes of a body by shift-invert block Lanczos on a CHOLMOD factor:
//
//   K phi = lambda M phi,   theta = 1 / (lambda - sigma),   (K - sigma M)^-1 M phi = theta phi,   sigma < 0
//
// Rigid modes are known from geometry and deflated. Nothing is returned before it has passed the gate (gate.h).
#pragma once

#include "cases/contract/physical_shift.h"
#include "mechanics/system/static_response.h"
#include "modal/bases/gate.h"
#include "modal/bases/rayleigh_ritz.h"

namespace mb {

// Rigid modes of the system, then at least n_elastic elastic ones (>= 0), more where a multiplet would be cut (relative
// gap of lambda <= 1e-6), fewer only where the system has no more. shift [1/s^2] < 0: about -0.01 E/(rho l^2).
// Of either sign of a mode always the same one is returned. n_elastic > n/3 uses a dense solver (n <= 6000, else
// std::invalid_argument). Throws GateFailure, std::runtime_error where Lanczos or a factorisation fails.
Modes lowest_modes(const System& system, int n_elastic, double shift);
// The same with a factor made before (static solves use it, too).
Modes lowest_modes(const System& system, int n_elastic, const ShiftedFactor& shifted);

// Its first try without the gate, for those who time it: the modes found, a few more than asked for.
ElasticModes elastic_modes(const System& system, int n_elastic, const ShiftedFactor& shifted);

}  // namespace mb
