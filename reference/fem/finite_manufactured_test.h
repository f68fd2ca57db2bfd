// For tests, manufactured solutions of finite strain: a box held on all its faces is deformed by
//
//   u = f(X) g(t),   B = rho u'' + alpha rho u' - Div P(F) - Div P_v(F, F')
//
// f as in manufactured_test.h, B [N/m^3] the body force that keeps it so. Strains reach a half. The divergences are
// derived here from the stresses that neo_hookean.h states, whose code they do not call. With F_K = dF/dX_K, G = F^-1,
//
//   Div P = sum_K [mu F_K + (mu - lambda ln J) (G F_K G)^T + lambda tr(G F_K) G^T] e_K
#pragma once

#include <cmath>

#include "mechanics/material/elasticity.h"
#include "reference/finite_bodies_test.h"
#include "reference/manufactured_test.h"
#include "reference/static_answer.h"

namespace mb::testing {

// Div P + Div P_v [N/m^3] where u = g f and u' = rate f.
inline Vector3d divergence(const Material& stuff, double beta, const Field& f, double g, double rate) {
  using Eigen::Matrix3d;
  const double mu = shear_modulus(stuff), nu = stuff.poissons_ratio, lambda = 2 * mu * nu / (1 - 2 * nu);
  const auto elastic = [&](const Matrix3d& E) -> Matrix3d {
    return lambda * E.trace() * Matrix3d::Identity() + 2 * mu * E;
  };
  const auto symmetric = [](const Matrix3d& A) -> Matrix3d { return (A + A.transpose()) / 2; };
  const Matrix3d F = Matrix3d::Identity() + g * f.gradient, G = F.inverse(), v = rate * f.gradient;
  const Matrix3d E_rate = symmetric(F.transpose() * v);
  const double log_J = std::log(F.determinant());
  Vector3d sum = Vector3d::Zero();
  for (int K = 0; K < 3; ++K) {
    Matrix3d along;  // d^2 f_i / dX_K dX_L
    for (size_t i = 0; i < 3; ++i) along.row(static_cast<Index>(i)) = f.second[i].row(K);
    const Matrix3d F_K = g * along, v_K = rate * along;
    const Matrix3d P_K =
        mu * F_K + (mu - lambda * log_J) * (G * F_K * G).transpose() + lambda * (G * F_K).trace() * G.transpose();
    const Matrix3d E_rate_K = symmetric(F_K.transpose() * v + F.transpose() * v_K);
    sum += (P_K + beta * (F_K * elastic(E_rate) + F * elastic(E_rate_K))).col(K);
  }
  return sum;
}

class FiniteBox {
 public:
  explicit FiniteBox(const Resolution& mesh, const Rayleigh& damping = {})
      : model_(model_of(held(mesh, damping))), rule_(rule_of(size_, mesh)), U_(model_->displacement_at(rule_.points)) {
    for (Index q = 0; q < rule_.weights.size(); ++q) fields_.push_back(field(size_, waves_, rule_.points.col(q)));
  }
  const System& system() const { return model_->system(); }
  double density() const { return stuff_.density; }
  Vector3d divergence(const Field& f, double beta, double g, double rate) const {
    return testing::divergence(stuff_, beta, f, g, rate);
  }
  double largest_gradient() const {  // [-]
    double largest = 0;
    for (const Field& f : fields_) largest = std::fmax(largest, f.gradient.cwiseAbs().maxCoeff());
    return largest;
  }

  // [N] of a body force [N/m^3] made of the field at each point
  template <typename Force>
  VectorXd load(const Force& force) const {
    VectorXd weighted(U_.rows());
    for (size_t q = 0; q < fields_.size(); ++q) {
      const auto at = static_cast<Index>(q);
      weighted.segment<3>(3 * at) = rule_.weights[at] * force(fields_[q]);
    }
    return U_.transpose() * weighted;
  }

  // L2 norm of u - g f, relative to that of f [-]
  double error(const VectorXd& u, double g) const {
    const VectorXd here = U_ * u;
    double off = 0, size = 0;
    for (size_t q = 0; q < fields_.size(); ++q) {
      const auto at = static_cast<Index>(q);
      off += rule_.weights[at] * (Vector3d(here.segment<3>(3 * at)) - g * fields_[q].u).squaredNorm();
      size += rule_.weights[at] * fields_[q].u.squaredNorm();
    }
    return std::sqrt(off / size);
  }

 private:
  Scene held(const Resolution& mesh, const Rayleigh& damping) const {
    Scene scene = finite_body(Box{size_}, stuff_, mesh, damping);
    for (const char* name : {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"})
      scene.bodies[0].supports.push_back(support(Support::Kind::fixed, face(name)));
    return scene;
  }

  const Vector3d size_{0.3, 0.2, 0.4};       // [m]
  const Material stuff_{2.3e4, 0.35, 1100};  // rubber
  const Waves waves_{{{0.012, -0.009, 0.02}, {1, 1, 1}}, {{-0.004, 0.006, 0.005}, {1, 1, 2}}};
  std::shared_ptr<const FullModel> model_;
  Quadrature rule_;
  SparseMatrix U_;
  std::vector<Field> fields_;
};

}  // namespace mb::testing
