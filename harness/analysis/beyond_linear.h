// What a body of finite deformation does beyond linear theory, from its stored energy alone. Its answer to a u that
// grows is a series, each term static behind the one before,
//
//   f(e u + e^2 v2 + e^3 v3) = e K u + O(e^4):   K v2 = -f2(u),   K v3 = -c3(u, v2)
//   f2 = (f(e u) + f(-e u)) / 2e^2,   c3 = ((f(e u + e^2 v2) - f(-e u + e^2 v2)) / 2 - e K u) / e^3
//
// v2: bending shortens what it turns; v3: what stretch and turn do to the stiffness. Idelsohn & Cardona 1985, Comput.
// Methods Appl. Mech. Engng 49, for v2 of single modes.
#pragma once

#include "mechanics/system/static_response.h"

namespace mb {

struct BeyondLinear {
  VectorXd v2, v3;  // [m]
};
// system: with a stored energy, of a body that supports hold; u [m] n; extent [m] of the body. Throws
// std::invalid_argument for another system and a u that is 0 or not finite, std::runtime_error where a thousandth of
// the body's extent inverts it.
BeyondLinear beyond_linear(const System& system, const ShiftedFactor& shifted, const VectorXd& u, double extent);

}  // namespace mb
