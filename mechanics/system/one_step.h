// One step of a scheme on modes that damping or contact couples, as a matrix:
//
//   q'' + C q' + K q = 0:   y+ = A y,   y = (s q, q'),   s_i = sqrt(K_ii), of modes without stiffness 1/h
//
// What stability.h says of single modes, of all of them together. In y, whose square is twice the energy where K is
// diagonal, matrices of schemes that keep energy are nearly orthogonal: eigenvalues are known to rounding, those of
// rigid modes, which are double, to its root.
#pragma once

#include <string>

#include "mechanics/types.h"

namespace mb {

struct CoupledModes {
  MatrixXd K, C;          // [1/s^2], [1/s] n x n, symmetric positive semi-definite
  VectorXd by_mean = {};  // [1/s] n, or 0: the diagonal part of C that does not lag where the rest of it does
};

// By the scheme's name (stability.h): "explicit-euler", "symplectic-euler", "central-difference" (damping implicit),
// "central-difference, lagged damping" (but by_mean) or "newmark"; else std::invalid_argument. h [s] > 0.
MatrixXd one_step(const CoupledModes& modes, const std::string& scheme, double h);

VectorXd energy_scales(const MatrixXd& K, double h);  // s

double spectral_radius(const MatrixXd& A);

// The largest step [s] up to which rho <= 1; 0: at none, infinity: at any. K, C symmetric positive semi-definite:
// average acceleration knows no limit; central differences are stable while 4 - h^2 K, those of lagged damping and
// symplectic Euler while 4 - 2 h C - h^2 K is positive definite, C that which lags, explicit Euler while |1 + h mu| <=
// 1 for every complex mode mu.
double stable_step(const CoupledModes& modes, const std::string& scheme);

}  // namespace mb
