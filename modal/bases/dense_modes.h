// All modes of a small system, by a dense solver.
#pragma once

#include "modal/bases/rayleigh_ritz.h"

namespace mb {

inline constexpr Index largest_dense = 6000;  // rows: beyond it memory and hours, not minutes

// Every elastic mode. Throws std::invalid_argument for more than largest_dense rows.
ElasticModes dense_modes(const System& system);

}  // namespace mb
