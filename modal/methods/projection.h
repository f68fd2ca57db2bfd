// A system in modal coordinates (Galerkin projection onto M-orthonormal modes), which is a System again:
//
//   u = Phi q:   q'' + Phi^T C Phi q' + Lambda q = Phi^T F s,   q(0) = Phi^T M u0,   q'(0) = Phi^T M v0
#pragma once

#include "cases/contract/linear.h"
#include "cases/contract/modes.h"
#include "mechanics/system/static_response.h"

namespace mb {

// M = I, K = Lambda (rigid: 0), R = the first n_rigid unit vectors, damping as it was.
System project(const System& system, const Modes& modes);

// Static response of the modes left out, (G - Phi_e Lambda_e^-1 Phi_e^T) F [m], n x loads; G_F = G F.
MatrixXd residual_flexibility(const System& system, const Modes& modes, const MatrixXd& G_F);

// A body of the model in its lowest settings.modes elastic modes, statically corrected or not.
struct ReducedBody {
  LinearBody body;
  int n_elastic;  // after rounding up to whole multiplets
};
ReducedBody reduce(const BodyModel& model, const ShiftedFactor& shifted, int n_modes, bool corrected);

}  // namespace mb
