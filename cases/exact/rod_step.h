// Step traction on one end of a rod in one dimension (nu = 0), the other end held or free: d'Alembert's solution.
//
//   u'' = u_tt / c^2,   c = sqrt(E/rho),   E u'(L) = tau H(t),   u(0) = 0 or u'(0) = 0,   at rest before
//   u = (c tau / E) sum_m s^m (<c t - (2m+1) L + x> + s <c t - (2m+1) L - x>) / c,   <a> = max(a, 0)
//
// x runs from the other end to the loaded one; s = -1 where the other end is held, +1 where it is free. The wave leaves
// the loaded end, and every reflection at the other multiplies it by s. Graff 1975, Wave Motion in Elastic Solids,
// sect. 2.3.
#pragma once

#include "cases/exact/exact.h"

namespace mb {

struct RodStep {
  double length;         // [m] > 0
  double youngs_modulus; /* [Pa] > 0 */
  double density;        // [kg/m^3] > 0
  double traction;       // [Pa] on the loaded end, outward
  bool is_held;          // the other end: held or free
};
struct RodState {
  double u;       // [m] outward at the loaded end is positive
  double strain;  // [-] du/dx; at a wave front, the value behind it
};
// x [m] in [0, length] from the other end; t [s] since the step, any sign.
RodState rod_state(const RodStep& rod, double x, double t);

ExactSolution rod_step();

}  // namespace mb
