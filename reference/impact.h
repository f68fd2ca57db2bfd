// Full order among rigid obstacles and of two bodies that meet, in the inertial frame: axes do not turn,
//
//   x = c0 + Q0 (X + d(t) + u),   d rigid flight to the first touch of surfaces, in closed form;   u by the integrator
//
// from there on, of all bodies together as one system (mechanics/system/joined.h); what supports hold is integrated
// alone until then, finite bodies that spin from the start. Orders of magnitude that `u` reaches rule the steps, not
// the height of the fall. The faces of linear bodies that may touch an obstacle are picked at the first touch of all:
// of what is touched then those nearby; of planes met later or never those that would come first; of other obstacles
// met later or never all. Of finite bodies all are watched.
#pragma once

#include "cases/contract/method.h"

namespace mb {

// For scenes with contact; those of several bodies have one contact, of two of them. Throws std::invalid_argument for a
// linear body that spins at the start (its axes would turn) and for integrators without prepare_in_contact. Answers
// with displacements that go beyond linear kinematics are none: std::runtime_error for such a body that turns by more
// than 0.1 rad, or that at a sample is within an obstacle with a part not picked (impact_limits.h). For an explicit
// integrator that gained energy by it the status is unstable instead.
std::unique_ptr<Prepared> prepare_impact(const Model& model, const Integrator& integrator, const Settings& settings);

}  // namespace mb
