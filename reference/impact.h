// Full order among rigid obstacles, in the inertial frame with linear kinematics: the body's axes do not turn,
//
//   x = c0 + Q0 (X + d(t) + u),   d rigid flight to the first touch of surfaces, in closed form;   u by the integrator
//
// from there on. Orders of magnitude that `u` reaches rule the steps, not the height of the fall.
#pragma once

#include "cases/contract/method.h"

namespace mb {

// For scenes with contact, of one body. Throws std::invalid_argument for a body that spins at the start (its axes would
// turn) and for integrators without prepare_in_contact.
std::unique_ptr<Prepared> prepare_impact(const Model& model, const Integrator& integrator, const Settings& settings);

}  // namespace mb
