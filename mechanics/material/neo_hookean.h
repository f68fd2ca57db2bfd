// Compressible neo-Hookean material. With F = dx/dX, J = det F > 0 and G = F^-1:
//
//   W = mu/2 (F:F - 3 - 2 ln J) + lambda/2 (ln J)^2                                       energy per reference volume
//   P = dW/dF = mu (F - G^T) + lambda ln J G^T                                            first Piola-Kirchhoff stress
//   A_iKjL = dP_iK/dF_jL = mu d_ij d_KL + (mu - lambda ln J) G_Kj G_Li + lambda G_Ki G_Lj
//
// lambda, mu of Hooke's law (elasticity.h), to which it linearises. W goes to infinity as J goes to 0 or to infinity.
// Bonet & Wood 2008, Nonlinear Continuum Mechanics for Finite Element Analysis, sect. 6.4.3.
//
// Its viscosity is Kelvin's and Voigt's, with S_v = beta C : E' pulled through F, so that a rigid velocity, E' = 0, is
// not braked, and beta K is what is left about rest:
//
//   P_v = beta F (lambda tr(E') 1 + 2 mu E'),   E' = sym(F^T F'),   P_v : F' = beta E' : C : E' >= 0
#pragma once

#include <optional>

#include "mechanics/material/elasticity.h"

namespace mb {

struct Lame {
  double lambda, mu; /* [Pa] lambda > -2 mu/3, mu > 0 */
};
Lame lame(const Material& material);  // throws std::invalid_argument for an orthotropic one

using Matrix9d = Eigen::Matrix<double, 9, 9>;

// What all of the above share.
struct Deformation {
  Eigen::Matrix3d F, G;  // [-] G = F^-1
  double log_J;          // [-]
};
std::optional<Deformation> deformation(const Eigen::Matrix3d& F);  // nothing where it inverts, J <= 0, or is no number

namespace neo_hookean {

double energy(const Lame& c, const Deformation& d);           // W [J/m^3] >= 0
Eigen::Matrix3d stress(const Lame& c, const Deformation& d);  // P [Pa]
Matrix9d tangent(const Lame& c, const Deformation& d);        // A [Pa], rows and columns i + 3 K: P by its columns
Eigen::Matrix3d viscous_stress(const Lame& c, double beta, const Eigen::Matrix3d& F,
                               const Eigen::Matrix3d& F_rate);  // P_v [Pa], F_rate [1/s], beta [s] >= 0

}  // namespace neo_hookean

}  // namespace mb
