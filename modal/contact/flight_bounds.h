// How fast a body in flight turns and deforms at most, from one time on: what proves that it does not touch.
//
// Without coupling every mode keeps to its own energy (modal_bounds.h) and |Omega| <= |L| / J_min. With coupling
// (spin.h) modes and rotation share the energy E, which only falls; with e = sqrt(2E), U = sqrt(J_max) and modes that
// are M-orthonormal (Bessel's inequality: a projection onto them is no longer than what it projects)
//
//   |q| <= e / omega_1,     J - C C^T >= J_min - 2 U |q| - s e^2 =: J_l,     |Omega| <= e / sqrt(J_l)
//   |q'| <= e + |Omega| |q|,   |sum a_i q_i| <= e sqrt(sum a_i^2 / lambda_i)   for any a
//   |q'' + Lambda q + c q'| <= |Omega|^2 (U + |q| + g e) + 2 |Omega| |q'| + |Omega'| |q|
//   (J - C C^T) Omega' = -J' Omega - Omega x Lambda - C (q'' + C^T Omega'),  |J' Omega| <= 2 |Omega| |q'| (U + |q| + g
//   e)
//
// s, g of the stiffening (spin.h); nothing is bounded where J_l <= 0: a body that spins about as fast as it vibrates.
#pragma once

#include <optional>

#include "modal/contact/modal_bounds.h"
#include "modal/frame/spin.h"

namespace mb {

struct FlightBounds {
  double Omega, Omega_t;   // [rad/s], [rad/s^2]
  double u, u_t, u_tt;     // [m], [m/s], [m/s^2] of the displacement in the body's frame
  double bend, bend_rate;  // [1/m], [1/(m s)] of its second derivative in space
};

// From the state on, for duration [s] (of a body that is held; of free ones for ever).
std::optional<FlightBounds> flight_bounds(const FloatingBody& body, const ShapeBounds& shapes, const BodyState& state,
                                          double duration);

}  // namespace mb
