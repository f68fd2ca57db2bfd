// Elastic sphere under axisymmetric tractions, in Legendre's polynomials of cos(theta), any resultant of which is
// balanced by a uniform body force (d'Alembert: the sphere is accelerated, quasi-statically):
//
//   sigma_rr = sum t_n P_n,   sigma_rtheta = sum s_n dP_n/dtheta,   u_r = sum U_n P_n,   u_theta = sum V_n dP_n/dtheta
//   [U_n; V_n] = C_n [t_n; s_n],   n >= 2, from Lur'e's two regular solutions:
//
//          1 + nu     | 2(1-nu) n^2 + nu n - 1 + 2 nu      -n (n+1) ((1-2nu) n - 2 + nu)     |
//   C_n = --------- * |                                                                      |,  D = n^2+n+1+nu (2n+1)
//         (n - 1) D   | -((1-2nu) n - 2 + nu)              2(1-nu) n^2 + (3nu-1) n + 1 + nu  |
//
// in units of R/E; n = 0 is uniform compression; n = 1 carries the body force, and displacements are relative to the
// centre of mass. Reciprocity: (C_n)_12 = n (n+1) (C_n)_21. Lur'e 1964, Three-Dimensional Problems of the Theory of
// Elasticity, ch. 6; the closed forms by eliminating his two constants.
#pragma once

#include "mechanics/types.h"

namespace mb {

// [R/E] for n >= 0; nu in (-1, 1/2], else std::invalid_argument.
Eigen::Matrix2d surface_compliance(int n, double poissons_ratio);

// How the pressure of a plane acts on the sphere: along the sphere's own normal, as on its undeformed surface, or along
// the plane's, as on the flattened one. They differ by (r/R) p along the surface: at the order of a/R in the approach.
enum class PressureAlong { sphere_normal, plane_normal };

// Approach of the centre of mass to a rigid plane, in terms of Hertz's at the same force, for small contacts:
//
//   delta/delta_H = 1 + alpha (constant + logarithm ln alpha) + O(alpha^2 ln alpha),   alpha = a/R by Hertz
//   logarithm = -2 (1 - 2nu)^2 / (3 pi (1 - nu))
//   constant = (2 (1-2nu)^2 (ln 2 + 19/12) + rho - 2 (1 - 2nu) [plane_normal]) / (3 pi (1 - nu))
//   rho = sum_n ((1 + nu)^-1 (2n+1) (C_n)_11 - 4 (1 - nu) - 4 (1 - 2nu)^2 / (2n + 1))
//
// First-order perturbation of the half-space's kernel 1/d by what the sphere adds, log and constant: by the
// stationarity of the complementary energy Pi, delta_1 = dPi_1/dF with Hertz's pressure, for which the mean of ln(d/a)
// is 2 ln 2 - 7/4. The last term is the work of p r/R along the surface.
struct SmallContact {
  double constant, logarithm;  // [-]
};
SmallContact small_contact(double poissons_ratio, PressureAlong along);  // nu in (-1, 1/2], else std::invalid_argument

}  // namespace mb
