// SUNDIALS ARKODE, adaptive ESDIRK of order 5 (A- and L-stable), for any System:
//
//   (u, v)' = (v, M^-1 (F s - C v - K u)),   per stage (M + gamma C + gamma^2 K) dv = ...: one SPD factor per gamma
#pragma once

#include <memory>

#include "mechanics/contact/contact.h"
#include "mechanics/system/system.h"

namespace mb {

// relative_tolerance [-] in [1e-12, 1e-2]; absolute ones are it times scales of displacement and velocity. It alone
// rules the steps, whatever the times asked for, up to a quarter of the duration and to the next breakpoint of a load;
// output between steps is interpolated by ARKODE's Hermite polynomial of degree 4. duration [s]: the longest time that
// will be asked for.
std::unique_ptr<Stepper> sundials(const System& system, double relative_tolerance, double duration);

// The same in contact, from its first touch on: tolerances are relative to the contacts' scales alone, and the steps at
// which the least gap passes zero are found. Loads must be steady; contacts must outlive the stepper.
std::unique_ptr<Stepper> sundials(const System& system, const std::vector<Contact>& contacts, double tolerance,
                                  double duration);

}  // namespace mb
