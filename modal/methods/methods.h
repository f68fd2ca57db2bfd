// Reduced methods: the body moves in its lowest r elastic modes and its rigid ones.
//
//   eigenmodes          u = Phi q
//   static-correction   u = Phi q + (G - Phi_e Lambda_e^-1 Phi_e^T) F s      (mode acceleration)
//
// The modes left out follow the load quasi-statically in the second. G: static_response.h; Phi_e, Lambda_e: elastic.
//   linear, quadratic   u = Phi q, Phi by Rayleigh-Ritz from the polynomials of degree 1, 2 which the supports admit
//   full                u = q: every degree of freedom of the mesh, the identity as basis
//
// Craig 1981, Structural Dynamics, sect. 15.5; polynomial classes of modes: Pentland & Williams 1989, sect. 3.1.1.
#pragma once

#include <memory>

#include "cases/contract/method.h"

namespace mb {

std::unique_ptr<Method> eigenmodes();
std::unique_ptr<Method> static_correction();
std::unique_ptr<Method> linear_strain();     // "linear": 6 elastic functions of a free body
std::unique_ptr<Method> quadratic_strain();  // "quadratic": 24
std::unique_ptr<Method> full_basis();        // "full"

}  // namespace mb
