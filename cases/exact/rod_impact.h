// A rod, nu = 0, runs end-on against a rigid wall with a penalty layer of stiffness k_n: one dimension, complete.
//
//   rho c (g' - v) = -p(t) - 2 sum_m p(t - m tau),   p = k_n max(g, 0),   tau = 2 L/c,   c = sqrt(E/rho)
//
// g: penetration of the end; p there sends a wave up the rod, which the free end returns as its release, and so on. In
// y = kappa t and Y = kappa tau, kappa = k_n/(rho c), until the end leaves the wall:
//
//   p/(rho c v) = 1 - e^-y                                t < tau
//               = -1 + (2 - e^-Y + 2 y) e^-y,  y = kappa (t - tau)    until it falls to zero, y_end = 1.678 for large Y
//
// The largest pressure is 2 exp(-e^-Y/2) - 1, at y = e^-Y/2; thereafter the end never comes back: it moves off at 0.63
// v at least. Above, z from the end that touches, P = int p dt, and the rod flying in with -v:
//
//   u = -v t + sum_m (P(t - z/c - m tau) + P(t + z/c - (m+1) tau)) / (rho c)
//
// The layer takes 0.103/Y of the speed, as vibration. k_n to infinity: rho c v for 2 L/c, rebound at v, at rest within.
// Graff 1975, Wave Motion in Elastic Solids, sect. 2.4; the layer's part is elementary.
#pragma once

#include "mechanics/types.h"

namespace mb {

struct RodImpact {
  double length;           // L [m] > 0
  double youngs_modulus;   // E [Pa] > 0
  double density;          // rho [kg/m^3] > 0
  double speed;            // v [m/s] > 0
  double layer_stiffness;  // k_n [Pa/m], k_n L/E >= 5
};
struct RodContact {
  double duration;   // [s]
  double peak;       // [Pa] largest pressure
  double peak_time;  // [s]
  double impulse;    // [Pa s] per area: rho L v (1 + e)
};
struct RodImpactState {
  double u;       // [m] away from the wall, 0 at the touch
  double strain;  // [-] du/dz; at the foot of a front, the value behind it
};

class RodImpactWaves {
 public:
  // Throws std::invalid_argument for what is not finite or out of range.
  explicit RodImpactWaves(const RodImpact& rod);
  const RodContact& contact() const { return contact_; }
  double pressure(double t) const;                 // p [Pa]; t [s] since the touch, any sign
  double impulse(double t) const;                  // P [Pa s]
  RodImpactState state(double z, double t) const;  // z [m] in [0, L]

 private:
  // p or P summed over m = 0, 1 ... of t - m tau.
  double sum_of_pressures(double t) const;
  double sum_of_impulses(double t) const;

  RodImpact rod_;
  double c_, kappa_, tau_, left_;  // [m/s], [1/s], [s], e^-Y [-]
  RodContact contact_;
};

}  // namespace mb
