// Hertz's frictionless contact of two smooth elastic bodies, near enough to half-spaces at the scale of the contact:
//
//   1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2,      k_i: principal curvatures of the gap, k_1 <= k_2
//   sphere, k_1 = k_2 = 1/R:   F = k delta^(3/2),  k = 4/3 E* sqrt(R),  a^2 = R delta,  p_0 = 3 F / (2 pi a^2)
//   ellipse a >= b, m = 1 - b^2/a^2:   k_2/k_1 = B(m) a^2 / (D(m) b^2),   D = (K - E)/m,   B = (E - (1 - m) K)/m
//       a^3 = 3 F D / (pi E* k_1),   delta = 3 F K / (2 pi a E*),   p_0 = 3 F / (2 pi a b)
//
// K(m), E(m) the complete elliptic integrals. Hertz 1882, J. reine angew. Math. 92; Johnson 1985, Contact Mechanics,
// sect. 3.5 and 4.1-4.2. Every length stands for that of the relative surfaces: 1/R = 1/R_1 + 1/R_2.
#pragma once

#include "mechanics/material/elasticity.h"

namespace mb {

// E* [Pa] of two isotropic bodies, or of one on a rigid partner. Throws std::invalid_argument for orthotropic or
// impossible materials.
double contact_modulus(const Material& one, const Material& other);
double contact_modulus(const Material& on_rigid);

struct HertzSphere {
  double radius;  /* R [m] > 0, relative */
  double modulus; /* E* [Pa] > 0 */
};
struct HertzState {
  double approach;        // delta [m] >= 0
  double force;           // F [N]
  double contact_radius;  // a [m]
  double peak_pressure;   // p_0 [Pa]
};
double hertz_stiffness(const HertzSphere& contact);                // k [N/m^1.5]
HertzState hertz_at(const HertzSphere& contact, double approach);  // [m]; apart, <= 0: nothing acts
HertzState hertz_under(const HertzSphere& contact, double force);  // [N] >= 0
// All throw std::invalid_argument for what is not finite or out of range.

// Complete elliptic integrals by the arithmetic-geometric mean, Abramowitz & Stegun 1964, sect. 17.6, arranged so that
// nothing cancels, neither at m = 0 nor at m = 1.
struct EllipticIntegrals {
  double K, E;  // [-]
  double D, B;  // [-] (K - E)/m and (E - (1 - m) K)/m: both pi/4 at m = 0; B + D = K
};
EllipticIntegrals elliptic_integrals(double b_over_a);  // sqrt(1 - m) in (0, 1], else std::invalid_argument

struct EllipticGap {
  double k_1, k_2; /* [1/m] principal curvatures of the gap, 0 < k_1 <= k_2, k_2/k_1 <= 1e12 */
  double modulus;  /* E* [Pa] > 0 */
};
struct EllipticContact {
  double stiffness;      // k [N/m^1.5], F = k delta^(3/2)
  double approach;       // delta [m]
  double a, b;           // [m] semi-axes, a >= b, a along the direction of k_1
  double peak_pressure;  // p_0 [Pa]
};
// force [N] >= 0. Throws std::invalid_argument for what is out of range.
EllipticContact elliptic_contact(const EllipticGap& gap, double force);

}  // namespace mb
