// What `newmark` makes of systems with a stored energy.
#pragma once

#include <memory>
#include <vector>

#include "mechanics/contact/contact.h"
#include "mechanics/system/system.h"

namespace mb {

// h [s] > 0; contacts: any number, also none. They and the system must outlive the stepper. Steps that do not converge,
// or whose deformation inverts, end the run with that status.
std::unique_ptr<Stepper> newmark_finite(const System& system, const std::vector<Contact>& contacts, double h);

}  // namespace mb
