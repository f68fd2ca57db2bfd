// The best modes within the span of given functions, rigid ones included: an approximation from above,
//
//   X = (I - R R^T M) Y,   (X^T K X) z = lambda (X^T M X) z,   Phi = [R, X z]
//
// Polynomials make the mode classes of Pentland & Williams 1989, sect. 3.1.1.
#pragma once

#include "cases/contract/modes.h"
#include "mechanics/system/system.h"

namespace mb {

// Y: n x k of full rank, k >= m, whose span contains the m rigid modes R: k - m elastic modes, maybe none. residual
// says how far they are from modes of the system; lambda_max is not found (0). Throws std::invalid_argument where sizes
// do not fit, std::runtime_error where the columns depend on one another or do not contain the rigid modes.
Modes ritz_modes(const System& system, const MatrixXd& Y);

}  // namespace mb
