// Bodies side by side as one system: what acts between them, contact, sees the unknowns of all,
//
//   M = diag(M_1, M_2, ...),   and so K, R, F and the lumped mass;   u = (u_1, u_2, ...)
//
// Rayleigh's damping stays where it is the same for all; else each body's own becomes
//   V = diag(alpha_b M_b + beta_b K_b),   W = diag(M_b R_b), d = -alpha_b:   no damping of rigid motion.
// With a body of finite deformation all have one stored energy (joined_energy.h), which has the beta of each.
#pragma once

#include <vector>

#include "mechanics/system/system.h"

namespace mb {

// At least one. Throws as require_consistent, and for finite deformation with an alpha that is not the same for all.
System joined(const std::vector<System>& systems);

}  // namespace mb
