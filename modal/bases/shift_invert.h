// The lowest elastic modes by block Lanczos on the shift-inverted pencil, rigid modes kept out:
//
//   (K - sigma M)^-1 M phi = theta phi,   lambda = sigma + 1/theta,   sigma < 0
//
// Ericsson & Ruhe 1980, Math. Comp. 35(152).
#pragma once

#include <optional>

#include "mechanics/system/static_response.h"
#include "modal/bases/rayleigh_ritz.h"

namespace mb {

struct Effort {
  Index block;       // columns solved for at once
  double tolerance;  // [-] relative residual of an eigenvalue of the shift-inverted operator, in the M norm
  Index n_spare;     // modes beyond the last one kept
  unsigned seed;     // of the start
};

// n_elastic rounded up to whole multiplets (modes.h); nothing where the last of lambda (ascending, n_all in all) may
// not be whole. lambda_max 0: not known.
std::optional<Index> whole_multiplets(const VectorXd& lambda, Index n_elastic, Index n_all, double lambda_max = 0);

// At least n_elastic modes, whole multiplets, and n_spare beyond, or all there are. The system must have about twice as
// many degrees of freedom.
ElasticModes shift_invert(const System& system, Index n_elastic, const ShiftedFactor& shifted, const Effort& effort);

// Degrees of freedom below which shift_invert finds no room for its vectors.
Index least_size(Index n_elastic, const Effort& effort);

}  // namespace mb
