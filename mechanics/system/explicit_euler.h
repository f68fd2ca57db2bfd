// Explicit Euler, which Pentland and Williams 1989 name: first order, unstable without damping at any step.
//
//   u+ = u + h v,   v+ = v + h M^-1 (F s - C v - K u)
#pragma once

#include <memory>

#include "mechanics/system/system.h"

namespace mb {

// h [s] > 0. M: lumped_mass where the system has one, else M with one factor. Output times between steps are read off
// the cubic Hermite polynomial of (u, v) at both ends; a run that grows beyond what is finite stops as not_finite. The
// system must outlive the stepper.
std::unique_ptr<Stepper> explicit_euler(const System& system, double h);

}  // namespace mb
