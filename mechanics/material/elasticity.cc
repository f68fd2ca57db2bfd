#include "mechanics/material/elasticity.h"

#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

using Eigen::Matrix3d;

// The normal part of the compliance made free of units: D S D with D = diag(sqrt(E_i)), ones on its diagonal.
Matrix3d scaled_compliance(const Orthotropy& o) {
  const Vector3d root = o.youngs_moduli.cwiseSqrt();
  Matrix3d S = Matrix3d::Identity();
  S(1, 2) = S(2, 1) = -o.poissons_ratios[0] * root[2] / root[1];
  S(0, 2) = S(2, 0) = -o.poissons_ratios[1] * root[2] / root[0];
  S(0, 1) = S(1, 0) = -o.poissons_ratios[2] * root[1] / root[0];
  return S;
}

Matrix6d orthotropic(const Orthotropy& o) {
  if (!is_stable(o)) throw std::invalid_argument("elasticity: the orthotropic compliance is not positive definite");
  const Vector3d root = o.youngs_moduli.cwiseSqrt();
  const Matrix3d normal = root.asDiagonal() * scaled_compliance(o).inverse() * root.asDiagonal();
  Matrix6d D = Matrix6d::Zero();
  D.topLeftCorner<3, 3>() = 0.5 * (normal + normal.transpose());  // symmetric to the last bit
  D.diagonal().tail<3>() = o.shear_moduli;
  return D;
}

}  // namespace

bool is_stable(const Orthotropy& o) {
  const auto positive = [](const Vector3d& x) { return x.allFinite() && (x.array() > 0).all(); };
  if (!positive(o.youngs_moduli) || !positive(o.shear_moduli) || !o.poissons_ratios.allFinite()) return false;
  // Below 1e-12 of the largest eigenvalue, at most 3, rounding decides the sign: incompressible to twelve digits.
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scaled_compliance(o), Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0] > 3e-12;
}

double shear_modulus(const Material& m) {
  if (m.orthotropy) return m.orthotropy->shear_moduli.maxCoeff();
  return m.youngs_modulus / (2 * (1 + m.poissons_ratio));
}

Matrix6d elasticity_matrix(const Material& m) {
  if (m.orthotropy) return orthotropic(*m.orthotropy);
  const double nu = m.poissons_ratio, mu = shear_modulus(m), lambda = m.youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu));
  Matrix6d D = Matrix6d::Zero();
  D.topLeftCorner<3, 3>().setConstant(lambda);
  D.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
  return D;
}

bool is_uniform(const Material& m) { return !m.orthotropy && m.inclusions.empty(); }

double stiffness_factor(const Material& m, const Vector3d& X) {
  for (auto inclusion = m.inclusions.rbegin(); inclusion != m.inclusions.rend(); ++inclusion)
    if ((2 * (X - inclusion->centre).cwiseAbs().array() <= inclusion->size.array()).all())
      return inclusion->stiffness_factor;
  return 1;
}

VectorXd stiffness_factors(const Material& m, const Matrix3Xd& X) {
  return VectorXd::NullaryExpr(X.cols(), [&](Index p) { return stiffness_factor(m, X.col(p)); });
}

double shear_wave_speed(const Material& m) { return std::sqrt(shear_modulus(m) / m.density); }

}  // namespace mb
