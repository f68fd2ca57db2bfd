// A system in modal coordinates (Galerkin projection onto M-orthonormal modes), which is a System again:
//
//   u = Phi q:   q'' + Phi^T C Phi q' + Lambda q = Phi^T F s,   q(0) = Phi^T M u0,   q'(0) = Phi^T M v0
#pragma once

#include "cases/contract/linear.h"
#include "cases/contract/modes.h"

namespace mb {

// M = I, K = Lambda (rigid: 0), R = the first n_rigid unit vectors, Rayleigh damping as it was. Damping of single modes
// becomes Phi^T W diag(d) W^T Phi; where that is diagonal but for rounding (the modes of W are among Phi or missing),
// as unit vectors. No lumped mass.
System project(const System& system, const Modes& modes);

// Static response of the modes left out, (G - Phi_e Lambda_e^-1 Phi_e^T) F [m], n x loads; G_F = G F.
MatrixXd residual_flexibility(const Modes& modes, const MatrixXd& F, const MatrixXd& G_F);

// A body of the model in a basis; correction [m]: n x loads, or 0 columns for none.
LinearBody reduce(const BodyModel& body, const Modes& modes, const MatrixXd& correction);

}  // namespace mb
