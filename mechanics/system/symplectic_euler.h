// Symplectic (semi-implicit) Euler: first order, conserves a nearby energy up to h = 2/omega without damping.
//
//   v+ = v + h M^-1 (F s - C v - K u),   u+ = u + h v+
#pragma once

#include <memory>

#include "mechanics/system/system.h"

namespace mb {

// h, M, output times, lifetime: as explicit_euler.h.
std::unique_ptr<Stepper> symplectic_euler(const System& system, double h);

}  // namespace mb
