// Full order of one body of finite kinematics (fem/finite_strain.h) that loads act on and nothing touches, in the axes
// of the body at t = 0:
//
//   M u'' + ... + f(u, u') = F s,     u(0) = 0,   u'(0) rigid,     any rotation
//
// Strains of a free body are those seen from a frame that turns with it, as in contact (impact_member.h).
#pragma once

#include "cases/contract/method.h"

namespace mb {

// Throws std::invalid_argument for more than one body and for integrators that have no steps for it.
std::unique_ptr<Prepared> prepare_finite(const Model& model, const Integrator& integrator, const Settings& settings);

}  // namespace mb
