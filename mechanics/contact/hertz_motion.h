// A rigid mass m meets a Hertzian contact of stiffness k at speed v and rebounds:
//
//   m x'' = -k x^(3/2),   x = L xi(tau),   t = (L/v) tau,   L = (m v^2/k)^(2/5)
//   xi'' = -xi^(3/2),     xi'^2 + 4/5 xi^(5/2) = 1,   largest xi_m = (5/4)^(2/5),   tau_c = 4/5 xi_m B(2/5, 1/2)
//
// so that, with k = 4/3 E* sqrt(R), the contact lasts T = 2.868265699 (m^2/(R E*^2 v))^(1/5) under at most
// F = 1.282689390 (m^3 v^6 R E*^2)^(1/5). Johnson 1985, Contact Mechanics, sect. 11.4.
#pragma once

#include "mechanics/types.h"

namespace mb {

struct HertzImpact {
  double mass;      // m [kg] > 0; of two bodies m_1 m_2 / (m_1 + m_2)
  double stiffness; /* k [N/m^1.5] > 0 */
  double speed;     /* v [m/s] > 0 of approach */
};

struct HertzPeaks {
  double duration;  // T [s]
  double force;     // [N] largest
  double approach;  // [m] largest
};
HertzPeaks hertz_peaks(const HertzImpact& impact);

struct HertzMotion {
  VectorXd approach, rate;  // x [m], x' [m/s]; free flight before and after contact, x < 0
  VectorXd force;           // [N] >= 0
};
// t [s], any finite values in any order; touch at t = 0. To 1e-13 of the greatest approach, of v and of the peak force.
HertzMotion hertz_motion(const HertzImpact& impact, const VectorXd& t);
// Both throw std::invalid_argument for what is not finite or out of range.

}  // namespace mb
