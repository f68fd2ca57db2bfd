// What modes leave out of a contact's local compliance, as static shapes: the response to Hertz's pressure
//
//   p_k(X) = sqrt(1 - (|X - X_c| / a_k)^2) on discs a_k = 2 a, 2 a/sqrt(2), a, ... a/8 about the first touch X_c,
//
// along the normal; where the blow misses the centroid of the body or of the one it meets, so that they roll off the
// disc, and with friction, which makes it lean, also tilted, p_k x/a_k and p_k y/a_k; with friction along the
// tangents, too, less what the modes and rigid motion carry of it (residual flexibility):
// Psi = (G - Phi Lambda^-1 Phi^T) F, then made K-orthonormal, Psi^T K Psi = I [J]. Of law hertz, lumped in a point, the
// response to its force.
#pragma once

#include "cases/contract/model.h"
#include "cases/contract/modes.h"
#include "cases/contract/touchdown.h"

namespace mb {

// n x n_s, n_s as many as are independent; 0 columns where nothing that the body meets, or that meets it, has a first
// touch.
MatrixXd contact_shapes(const Scene& scene, const Body& body, const BodyModel& model, const Modes& modes, double shift);

}  // namespace mb
