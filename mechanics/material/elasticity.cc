#include "mechanics/material/elasticity.h"

#include <cmath>

namespace mb {

double shear_modulus(const Material& m) { return m.youngs_modulus / (2 * (1 + m.poissons_ratio)); }

Matrix6d elasticity_matrix(const Material& m) {
  const double nu = m.poissons_ratio, mu = shear_modulus(m), lambda = m.youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu));
  Matrix6d D = Matrix6d::Zero();
  D.topLeftCorner<3, 3>().setConstant(lambda);
  D.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
  return D;
}

double shear_wave_speed(const Material& m) { return std::sqrt(shear_modulus(m) / m.density); }

}  // namespace mb
