// One step of modes in contact, linearised: the layer pressed at one point as hard as at the height of the impact,
//
//   q'' + c q' + Lambda q + kappa g g^T q = 0,   g = Phi^T U(X)^T n,   kappa = k_n pi a^2
//
// by each of the schemes of modal/contact/contact_step.h; of two bodies the modes of both, g with opposite signs. Where
// the spectral radius of the step passes 1, contact feeds energy: symplectic Euler and central differences beyond one
// step, at about 2/omega of the stiffened modes, explicit Euler beyond what damping takes away, without damping at
// once, average acceleration nowhere (mechanics/system/one_step.h). Kicks between closed forms do so in windows, too,
// about the steps at which two of them come round together, h (omega_i + omega_j) = 2 pi k.
//
// Within that limit, too, energy is gained where the layer opens within a step: the trapezoidal rule takes its work
// kappa delta^2/2 for kappa delta Delta/2, Delta the way of the step, at most kappa Delta^2/8 too much.
#pragma once

#include <string>
#include <vector>

#include "mechanics/types.h"

namespace mb {

// Static shapes of a body under the contact: massless, in series with the layer, as damped as Rayleigh's beta has them.
struct StaticYield {
  double c, beta;  // [m/N], [s] >= 0
};

struct PressedModes {
  VectorXd lambda, c;  // [1/s^2], [1/s] n, rigid modes with 0
  VectorXd g;          // [kg^-1/2] n
  double kappa;        // [N/m] > 0
  std::vector<StaticYield> yields = {};

  // [N/m] Of layer and static shapes in steps h [s]:
  //
  //   1/kappa' = 1/kappa + sum c/(1 + 4 beta/h)
  //
  // which is what backward differences of order 2 make of c (1 + beta d/dt)^-1 where a step turns its sign. Where it
  // turns by less, and for explicit Euler at h = infinity, they yield more.
  double stiffness(double h) const;
};

// scheme: "exact", "symplectic-euler", "central-difference", "explicit-euler" or "newmark"; else std::invalid_argument.
// h [s] > 0.
double pressed_radius(const PressedModes& pressed, const std::string& scheme, double h);

// The least step [s] at which that is above 1 by more than 1e-6, to a thousandth of it; infinity: none up to `most` [s]
// from 1e-4 of it on. Kicks are tried at steps 3 % apart and at resonances(), so that a window is missed only where it
// is narrower than that and first order in the layer puts it elsewhere. Of the other schemes it is stable_step() of
// one_step.h: 0 where no step is stable, infinity of average acceleration.
double pressed_limit(const PressedModes& pressed, const std::string& scheme, double most);

// The most that is gained where the layer opens, of m v^2/2, by each scheme but explicit Euler, and the step [s] at
// which that is `gain`:
//
//   gain = g/(1 - g),   g = kappa h^2/(4 m)
//
// of average acceleration since Delta = h (v0 + v1)/2 is at most h v1, the speed with the gain; of kicks between drifts
// and of symplectic Euler since from the touch on u_n = A sin n theta, sin^2(theta/2) = g, and what leaves is at most
// 1/cos(theta/2) as fast as what came. Infinity for g >= 1. Of a rigid mass m [kg] > 0 that starts where it touches;
// kappa [N/m], h [s], gain [-] > 0.
double opening_gain(double kappa, double m, double h);
double opening_limit(double kappa, double m, double gain);
double opening_limit(const PressedModes& pressed, double m, double gain);  // by its stiffness at that step

// Middles [s] of those windows of kicks between closed forms that are narrower than 6 %, below `most`, ascending: with
// omega' = omega + kappa g^2/(2 omega)
//
//   h = 2 pi k / (omega_i' + omega_j'),   width/h = 2 w/(omega_i + omega_j),   w = kappa |g_i g_j|/sqrt(omega_i
//   omega_j)
//
// Left out: where w < sqrt(c_i c_j), which damping closes, or width/h < 1e-7, where a step grows by less than 1e-6.
std::vector<double> resonances(const PressedModes& pressed, double most);

}  // namespace mb
