// Isotropic linear elasticity, small strain:
//
//   sigma = lambda tr(eps) I + 2 mu eps,   lambda = E nu / ((1+nu)(1-2nu)),   mu = E / (2(1+nu))
//
// Voigt order xx yy zz yz xz xy with engineering shear strains.
#pragma once

#include "mechanics/types.h"

namespace mb {

struct Material {
  double youngs_modulus;  // [Pa] > 0
  double poissons_ratio;  // [-] in (-1, 1/2)
  double density;         // [kg/m^3] > 0
};

double shear_modulus(const Material& material);        // [Pa]
Matrix6d elasticity_matrix(const Material& material);  // [Pa] sigma = D eps, SPD
double shear_wave_speed(const Material& material);     // [m/s] sqrt(mu/rho)

}  // namespace mb
