// Full order among rigid obstacles, in the inertial frame with linear kinematics: the body's axes do not turn,
//
//   x = c0 + Q0 (X + d(t) + u),   d rigid flight to the first touch of surfaces, in closed form;   u by the integrator
//
// from there on. Orders of magnitude that `u` reaches rule the steps, not the height of the fall. The faces that may
// touch an obstacle are picked at the first touch of all: of what is touched then those nearby; of planes met later or
// never those that would come first; of other obstacles met later or never all.
#pragma once

#include "cases/contract/method.h"

namespace mb {

// For scenes with contact, of one body of linear kinematics (else finite_answer.h). Throws std::invalid_argument for a
// body that spins at the start (its axes would turn) and for integrators without prepare_in_contact. Answers with
// displacements that go beyond this are none: std::runtime_error for a body that turns by more than 0.1 rad, or that at
// a sample is within an obstacle with a part not picked (impact_limits.h). For an explicit integrator that gained energy
// by it the status is unstable instead.
std::unique_ptr<Prepared> prepare_impact(const Model& model, const Integrator& integrator, const Settings& settings);

}  // namespace mb
