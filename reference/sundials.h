// SUNDIALS ARKODE, adaptive ESDIRK of order 5 (A- and L-stable), for any System:
//
//   (u, v)' = (v, M^-1 (F s - C v - K u)),   per stage (M + gamma C + gamma^2 K) dv = ...: one SPD factor per gamma
#pragma once

#include <memory>

#include "mechanics/system/system.h"

namespace mb {

// relative_tolerance [-] in [1e-12, 1e-2]; absolute ones are it times scales of displacement and velocity. duration
// [s].
std::unique_ptr<Stepper> sundials(const System& system, double relative_tolerance, double duration);

}  // namespace mb
