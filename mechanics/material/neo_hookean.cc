#include "mechanics/material/neo_hookean.h"

#include <cmath>
#include <stdexcept>

namespace mb {

using Eigen::Matrix3d;

Lame lame(const Material& m) {
  if (!is_uniform(m))
    throw std::invalid_argument("Lame's constants are those of an isotropic material, the same throughout");
  const double nu = m.poissons_ratio;
  return {m.youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu)), shear_modulus(m)};
}

std::optional<Deformation> deformation(const Matrix3d& F) {
  const double J = F.determinant();
  if (!(J > 0 && std::isfinite(J))) return std::nullopt;
  return Deformation{F, F.inverse(), std::log(J)};
}

namespace neo_hookean {

double energy(const Lame& c, const Deformation& d) {
  // F:F - 3 - 2 ln J without what cancels: with H = F - 1, F:F - 3 = 2 tr H + H:H.
  const Matrix3d H = d.F - Matrix3d::Identity();
  return c.mu / 2 * (2 * (H.trace() - d.log_J) + H.squaredNorm()) + c.lambda / 2 * d.log_J * d.log_J;
}

Matrix3d stress(const Lame& c, const Deformation& d) {
  return c.mu * d.F + (c.lambda * d.log_J - c.mu) * d.G.transpose();
}

Matrix9d tangent(const Lame& c, const Deformation& d) {
  const double turned = c.mu - c.lambda * d.log_J;
  Matrix9d A = c.mu * Matrix9d::Identity();
  for (int L = 0; L < 3; ++L)
    for (int j = 0; j < 3; ++j)
      for (int K = 0; K < 3; ++K)
        for (int i = 0; i < 3; ++i)
          A(i + 3 * K, j + 3 * L) += turned * d.G(K, j) * d.G(L, i) + c.lambda * d.G(K, i) * d.G(L, j);
  return A;
}

Matrix3d viscous_stress(const Lame& c, double beta, const Matrix3d& F, const Matrix3d& F_rate) {
  const Matrix3d product = F.transpose() * F_rate, E_rate = 0.5 * (product + product.transpose());
  return beta * F * (c.lambda * E_rate.trace() * Matrix3d::Identity() + 2 * c.mu * E_rate);
}

}  // namespace neo_hookean

}  // namespace mb
