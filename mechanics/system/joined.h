// Bodies side by side as one system: what acts between them, contact, sees the unknowns of all,
//
//   M = diag(M_1, M_2, ...),   and so K, R, F and the lumped mass;   u = (u_1, u_2, ...)
//
// Rayleigh's damping stays where it is the same for all; else each body's own becomes
//   V = diag(alpha_b M_b + beta_b K_b),   W = diag(M_b R_b), d = -alpha_b:   no damping of rigid motion.
#pragma once

#include <vector>

#include "mechanics/system/system.h"

namespace mb {

// At least one. Throws as require_consistent.
System joined(const std::vector<System>& systems);

}  // namespace mb
