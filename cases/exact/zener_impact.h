// Elastic ball on a thin infinite elastic plate: Hertz's contact in series with the plate, which moves like a dashpot.
//
//   m w_1'' = -F,   w_2' = F / (8 sqrt(D rho_2 h)),   F = k sigma^(3/2),   sigma = w_1 - w_2,   D = E_2' h^3 / 12
//   in units of T_0 = (m^2/(k^2 v))^(1/5) and v T_0:   sigma'' + (1 + lambda d/dtau) sigma^(3/2) = 0
//   lambda = m / (8 sqrt(D rho_2 h) T_0)
//          = pi^(3/5)/sqrt(3) (r/h)^2 (v/c)^(1/5) (rho_1/rho_2)^(3/5) (E_1'/(E_1' + E_2'))^(2/5),   c =
//          sqrt(E_2'/rho_2)
//
// from sigma = 0, sigma' = 1 until sigma = 0 again; E' = E/(1 - nu^2). The ball leaves at e = -sigma' of its speed, as
// the plate rests when F does. Valid while the plate's waves have not come back from its rim. Zener 1941, Phys.
// Rev. 59.
//
// The equation is integrated in s = sqrt(sigma) and a time xi with dtau = 2 s dxi, where it is polynomial, so that
// touch and release are points like any other:   s' = v,   v' = -2 s^4 - 3 lambda s^2 v,   tau' = 2 s.
#pragma once

#include "mechanics/material/elasticity.h"

namespace mb {

struct ZenerImpact {
  double restitution;  // e [-] in (0, 1]
  double duration;     // [T_0]
  double peak_force;   // [m v/T_0]
  double peak_time;    // [T_0] of the largest force and approach
};
// lambda [-] in [0, 50]. e to 1e-12, relative; beyond lambda = 5, e ~ 0.6793/lambda^5.
ZenerImpact zener_impact(double lambda);

struct ZenerMotion {
  VectorXd sigma, rate;  // approach [v T_0] and its rate [v]; after release the ball's flight, < 0
  VectorXd force;        // [m v/T_0] >= 0
};
// tau [T_0] ascending; before touch, tau < 0, the ball flies in.
ZenerMotion zener_motion(double lambda, const VectorXd& tau);

struct PlateImpact {
  Material ball, plate;  // isotropic
  double radius;         /* r [m] > 0 of the ball */
  double thickness;      // h [m] > 0 of the plate
  double speed;          // v [m/s] > 0
};
double zener_parameter(const PlateImpact& impact);  // lambda [-]
double zener_time(const PlateImpact& impact);       // T_0 [s]

// All throw std::invalid_argument for what is not finite or out of range.

}  // namespace mb
