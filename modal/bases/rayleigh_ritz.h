// The best elastic modes within a subspace (Rayleigh-Ritz), the rigid modes projected out first:
//
//   X = (I - R R^T M) Y,   (X^T K X) z = lambda (X^T M X) z,   phi = X z
//
// Parlett 1998, The Symmetric Eigenvalue Problem, ch. 11.
#pragma once

#include "cases/contract/modes.h"
#include "mechanics/system/system.h"

namespace mb {

struct ElasticModes {
  VectorXd lambda;  // [1/s^2] ascending
  MatrixXd Phi;     // n x number of modes, M-orthonormal, M-orthogonal to R
};

// Y: n x k of full rank, columns of comparable size. Throws std::runtime_error where the columns depend on one another.
ElasticModes rayleigh_ritz(const System& system, const MatrixXd& Y);

// The system's rigid modes, then these. A lambda below 0 becomes an omega that is NaN; lambda_max is not filled in.
Modes with_rigid(const System& system, const ElasticModes& elastic);

}  // namespace mb
