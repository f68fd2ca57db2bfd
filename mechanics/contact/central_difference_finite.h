// Central differences of systems with a stored energy (finite_force.h), with the lumped mass where there is one: in
// velocities half way between steps
//
//   M (w+ - w)/h = F s + Q F' s' - r(u, w) + f_C(u, w),   u+ = u + h w+,   v = (w + w+)/2
//
// All damping lags half a step, that of the contacts and the mass, too, which `central_difference` takes implicitly of
// linear systems: first order in it, and a lower limit (stability.h, "central-difference, lagged damping"). The limit
// is that of the body as it is deformed. Belytschko, Liu & Moran 2000, Nonlinear Finite Elements, sect. 6.2.
#pragma once

#include <memory>
#include <vector>

#include "mechanics/contact/contact.h"
#include "mechanics/system/system.h"

namespace mb {

// h [s] > 0; contacts: any number, also none. They and the system must outlive the stepper. A deformation that inverts
// ends the run as not_finite: past a step's limit nothing tells it from growth beyond bounds. Throws as FiniteForce.
std::unique_ptr<Stepper> central_difference_finite(const System& system, const std::vector<Contact>& contacts,
                                                   double h);

}  // namespace mb
