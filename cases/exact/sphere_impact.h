// Elastic sphere against a rigid plane through a penalty layer of stiffness k_n, its waves left out: what Hertz's
// impact becomes for a finite sphere on a finite stiffness. With alpha = a/R by Hertz, F = 4/3 E* R^2 alpha^3, the
// centre of mass approaches by
//
//   x/R = alpha^2 (1 + alpha (C + D ln alpha) + alpha^2 (E + G ln alpha)) + alpha E*/(pi k_n R),    m x'' = -F(x)
//
// C, D: small_contact of sphere_series.h; E, G such that sphere_on_plane is met at Hertz's greatest alpha and at half
// of it; the layer's share is the first order of its complementary energy, int p^2/(2 k_n) dA, for Hertz's pressure, of
// error (E*/(k_n a))^2. Energy integral: m v^2/2 = W(alpha_m), W = int F dx in closed form, T = 2 int dx/x'. Gravity g
// along the way, uniform like the body's acceleration, deforms nothing: m x'' = m g - F, W less m g x.
//
// Left out is what stays behind in the sphere as waves: of a half-space it is of the order of (v/c)^(3/5) of the
// energy, c the speed of sound (Hunter 1957, J. Mech. Phys. Solids 5).
#pragma once

#include "mechanics/material/elasticity.h"

namespace mb {

struct SphereImpact {
  Material material;       // isotropic, of the sphere
  double radius;           // R [m] > 0
  double speed;            // v [m/s] > 0
  double layer_stiffness;  // k_n [Pa/m] > 0; infinity: no layer
  double gravity = 0;      // g [m/s^2] >= 0 towards the plane; m g at most a hundredth of the largest force
};
struct SphereImpactPeaks {
  double duration;        // T [s]
  double force;           // [N] largest
  double approach;        // x [m] largest, of the centre of mass
  double contact_radius;  // a [m] by Hertz of the largest force
};
// Throws std::invalid_argument for what is not finite or out of range, and where Hertz's a/R leaves [0.004, 0.25] or
// E*/(pi k_n a) exceeds 0.1, beyond which the expansion does not hold.
SphereImpactPeaks sphere_impact(const SphereImpact& impact);

struct SphereImpactMotion {
  SphereImpactPeaks peaks;
  VectorXd approach, rate;  // x [m], x' [m/s] of the centre of mass; before and after contact its flight, x <= 0
  VectorXd force;           // [N] >= 0
  VectorXd layer_energy;    // [J] int p^2/(2 k_n) dA = E*^2 a^4/(pi k_n R^2) by Hertz's pressure
};
// t [s], any finite values in any order; touch at t = 0. The law above to 1e-9 of the largest force. Throws as
// sphere_impact does.
SphereImpactMotion sphere_impact_motion(const SphereImpact& impact, const VectorXd& t);

}  // namespace mb
