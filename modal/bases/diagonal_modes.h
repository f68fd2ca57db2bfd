// Modes of a system that stands in them already, as that of a body of beam or plate theory does:
//
//   M = diag(m), K = diag(k), R of unit vectors:   lambda_i = k_i/m_i,   phi_i = e_i / sqrt(m_i)
#pragma once

#include <optional>

#include "modal/bases/rayleigh_ritz.h"

namespace mb {

// The lowest elastic modes, to the end of a multiplet, and one beyond it where there is one; nothing for systems that
// are not diagonal. n_elastic in [0, all of them].
std::optional<ElasticModes> diagonal_modes(const System& system, Index n_elastic);

}  // namespace mb
