// Linear elasticity, small strain, isotropic or orthotropic with the axes of the body's frame:
//
//   sigma = lambda tr(eps) I + 2 mu eps,   lambda = E nu / ((1+nu)(1-2nu)),   mu = E / (2(1+nu))
//   eps_i = sigma_i/E_i - sum_j nu_ji/E_j sigma_j,   nu_ij/E_i = nu_ji/E_j,   gamma_ij = tau_ij/G_ij
//
// Voigt order xx yy zz yz xz xy with engineering shear strains. Lekhnitskii 1963, Theory of Elasticity of an
// Anisotropic Elastic Body, sect. 3.
#pragma once

#include <optional>

#include "mechanics/types.h"

namespace mb {

// Moduli along and between the axes x, y, z. nu_ij: contraction along j under tension along i.
struct Orthotropy {
  Vector3d youngs_moduli;   /* [Pa] E_x, E_y, E_z, each > 0 */
  Vector3d poissons_ratios; /* [-] nu_yz, nu_xz, nu_xy; such that the compliance is SPD */
  Vector3d shear_moduli;    /* [Pa] G_yz, G_xz, G_xy, each > 0 */
};
bool is_stable(const Orthotropy& orthotropy);  // whether its compliance is SPD, beyond doubt of rounding

struct Material {
  double youngs_modulus;  // [Pa] > 0; of an orthotropic material the largest of its moduli: a scale, no more
  double poissons_ratio;  // [-] in (-1, 1/2); not used where orthotropic
  double density;         // [kg/m^3] > 0
  std::optional<Orthotropy> orthotropy = std::nullopt;
};

double shear_modulus(const Material& material);  // [Pa]; orthotropic: the largest of the three
// [Pa] sigma = D eps, SPD. Throws std::invalid_argument where an orthotropic material is not stable.
Matrix6d elasticity_matrix(const Material& material);
double shear_wave_speed(const Material& material);  // [m/s] sqrt(mu/rho)

}  // namespace mb
