// Static response of a body that may be free (inertia relief):
//
//   K G F = F - M R R^T F,   R^T M G F = 0
//
// G is the inverse of K on the M-orthogonal complement of the rigid modes R: the part of F that accelerates the body as
// a whole is balanced by d'Alembert forces. Without rigid modes G F = K^-1 F. MacNeal 1971, Computers & Structures
// 1(4); Craig 1981, Structural Dynamics, sect. 19.5.
#pragma once

#include "mechanics/algebra/cholesky.h"
#include "mechanics/system/system.h"

namespace mb {

// The factor that both the eigensolver and static solves need, made once.
struct ShiftedFactor {
  double shift;     // sigma [1/s^2] < 0
  Cholesky factor;  // of K - sigma M
};
ShiftedFactor shifted_factor(const System& system, double shift);

// v - R R^T M v: v without its rigid part, column by column.
MatrixXd without_rigid_part(const System& system, const MatrixXd& v);

// G F, one column a load; F [N] n x any number. Conjugate gradients on K, preconditioned by the factor; a column's
// residual |K x - f| is at most 1e-12 |F| or what rounding leaves. Throws std::runtime_error where that is not reached.
MatrixXd inertia_relief(const System& system, const ShiftedFactor& shifted, const MatrixXd& F);

}  // namespace mb
