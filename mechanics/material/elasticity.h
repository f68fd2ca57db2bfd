// Linear elasticity, small strain, isotropic or orthotropic with the axes of the body's frame:
//
//   sigma = lambda tr(eps) I + 2 mu eps,   lambda = E nu / ((1+nu)(1-2nu)),   mu = E / (2(1+nu))
//   eps_i = sigma_i/E_i - sum_j nu_ji/E_j sigma_j,   nu_ij/E_i = nu_ji/E_j,   gamma_ij = tau_ij/G_ij
//
// Voigt order xx yy zz yz xz xy with engineering shear strains. Lekhnitskii 1963, Theory of Elasticity of an
// Anisotropic Elastic Body, sect. 3.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/types.h"

namespace mb {

// Moduli along and between the axes x, y, z. nu_ij: contraction along j under tension along i.
struct Orthotropy {
  Vector3d youngs_moduli;   /* [Pa] E_x, E_y, E_z, each > 0 */
  Vector3d poissons_ratios; /* [-] nu_yz, nu_xz, nu_xy; such that the compliance is SPD */
  Vector3d shear_moduli;    /* [Pa] G_yz, G_xz, G_xy, each > 0 */
};
bool is_stable(const Orthotropy& orthotropy);  // whether its compliance is SPD, beyond doubt of rounding

// A box, edges along the body's axes, in which every modulus is the material's times a factor; density stays.
struct Inclusion {
  Vector3d centre;         // [m] body frame
  Vector3d size;           // [m] each > 0
  double stiffness_factor; /* [-] in [1e-8, 1e8] */
};

struct Material {
  double youngs_modulus;  // [Pa] > 0; of an orthotropic material the largest of its moduli: a scale, no more
  double poissons_ratio;  // [-] in (-1, 1/2); not used where orthotropic
  double density;         // [kg/m^3] > 0
  std::optional<Orthotropy> orthotropy = std::nullopt;
  std::vector<Inclusion> inclusions = {};
};
bool is_uniform(const Material& material);  // isotropic, without inclusions
// [-] by which D is multiplied at X [m], body frame: that of the last inclusion which holds X, 1 outside of all.
double stiffness_factor(const Material& material, const Vector3d& X);
VectorXd stiffness_factors(const Material& material, const Matrix3Xd& X);  // one a column

double shear_modulus(const Material& material);  // [Pa]; orthotropic: the largest of the three; of no inclusion
// [Pa] sigma = D eps, SPD, outside of inclusions. Throws std::invalid_argument where an orthotropic material is not
// stable.
Matrix6d elasticity_matrix(const Material& material);
double shear_wave_speed(const Material& material);  // [m/s] sqrt(mu/rho)

}  // namespace mb
