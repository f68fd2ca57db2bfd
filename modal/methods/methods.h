// Reduced methods: the body moves in its lowest r elastic modes and its rigid ones.
//
//   eigenmodes          u = Phi q
//   static-correction   u = Phi q + (G - Phi_e Lambda_e^-1 Phi_e^T) F s      (mode acceleration)
//
// The modes left out follow the load quasi-statically in the second. G: static_response.h; Phi_e, Lambda_e: elastic.
// Craig 1981, Structural Dynamics, sect. 15.5.
#pragma once

#include <memory>

#include "cases/contract/method.h"

namespace mb {

std::unique_ptr<Method> eigenmodes();
std::unique_ptr<Method> static_correction();

}  // namespace mb
