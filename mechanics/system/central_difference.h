// Central differences, the rival that needs no factor of K: stable up to h = 2/omega_max, second order; first
// order where damping lags, see below.
//
//   M (u+ - 2 u + u-)/h^2 + C (u+ - u-)/(2 h) + K u = F s        (damping implicit)
//
// With a lumped (diagonal) mass a step is one product with K. There the damping of K and of single modes would couple
// the degrees of freedom: it lags half a step instead, C (u - u-)/h, and lowers the limit (stability.h). Damping that
// is proportional to mass stays implicit. Bodies of finite deformation: central_difference_finite.h. Belytschko, Liu &
// Moran 2000, Nonlinear Finite Elements, sect. 6.2.
#pragma once

#include <memory>

#include "mechanics/system/system.h"

namespace mb {

// h, M, output times, lifetime: as explicit_euler.h. v at a step's end is (u+ - u-)/(2 h).
std::unique_ptr<Stepper> central_difference(const System& system, double h);

}  // namespace mb
