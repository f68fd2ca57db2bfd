// Full order of a body of finite kinematics (fem/finite_strain.h), among rigid obstacles or loaded, in the inertial
// axes of the body at t = 0:
//
//   x = c0 + Q0 (X + d(t) + u),     M u'' + ... + f(u, u') = F s + f_contact(u, u'),     any rotation
//
// d is rigid flight: of a body that does not spin in closed form to the first touch of surfaces, and u from there on; a
// body that spins at the start stretches in flight, and is integrated from t = 0, where it is undeformed and moves
// rigidly. Every face of the boundary is watched for every obstacle. Strains of free bodies are those seen from a frame
// that turns with them, which metrics compare with small ones:
//
//   eps = sym(Q^T F) - 1,   Q minimises int rho |x - c - Q (X - X_c)|^2
#pragma once

#include "cases/contract/method.h"

namespace mb {

// For scenes of one body, of finite kinematics. Throws std::invalid_argument for integrators that have no steps for it.
std::unique_ptr<Prepared> prepare_finite(const Model& model, const Integrator& integrator, const Settings& settings);

}  // namespace mb
