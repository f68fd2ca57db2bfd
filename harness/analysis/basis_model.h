// A body in a basis as a body of full order again, so that all that full order does in contact, on the surface of its
// mesh and with its integrators, is done in that basis, too:
//
//   u = V q,   V = sqrt(m) Phi,   V^T M V = m 1:      x_i = X_i + (U V q)_i,   f_q = V^T U^T t w
//
// q [m] is a displacement, as tolerances take unknowns to be. Static shapes are independent of each other there, with
// their mass or, like those of the floating frame, with hardly any of it:
//
//   Psi^T M Psi y = mu Psi^T K Psi y,   omega = mu^(-1/2),   phi = Psi y,  y^T Psi^T M Psi y = 1
#pragma once

#include <span>

#include "cases/contract/model.h"
#include "cases/contract/modes.h"

namespace mb {

struct Basis {
  Modes modes;                // M-orthonormal and K-orthogonal, rigid modes first
  Index n_shapes = 0;         // the last ones: static shapes
  double mass_of_shapes = 1;  // [-] > 0 of their own: how much of it they have
};

// modes, followed by static shapes Psi n x n_s which are M- and K-orthogonal to them (contact_shapes.h).
Basis with_shapes(const Modes& modes, const MatrixXd& Psi, const System& system, double mass_of_shapes = 1);

// One basis a body. Of small strains, whatever the body's kinematics: the scene has to state them (linearised,
// contact_variants.h). Elastic starts are those of least energy.
Model in_bases(const Model& model, std::span<const Basis> bases);

}  // namespace mb
