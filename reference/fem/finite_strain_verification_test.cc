// Manufactured solutions: a box held on all its faces is deformed by
//
//   u = sum_k a_k sin(k_x pi x/l_x) sin(k_y pi y/l_y) sin(k_z pi z/l_z),   B_i = -A_iKjL(F) d_K d_L u_j
//
// as the body force B [N/m^3] balances it. Strains reach a half.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/material/neo_hookean.h"
#include "mechanics/verified_test.h"
#include "reference/finite_bodies_test.h"
#include "reference/manufactured_test.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using Eigen::Matrix3d;

const Vector3d size(0.3, 0.2, 0.4);  // [m]
const Material rubber{2.3e4, 0.35, 1100};

const testing::Waves waves{{{0.012, -0.009, 0.02}, {1, 1, 1}}, {{-0.004, 0.006, 0.005}, {1, 1, 2}}};

using testing::Field;
Field field(const Vector3d& X) { return testing::field(size, waves, X); }

Vector3d body_force(const Lame& c, const Field& f) {
  const Matrix9d A = neo_hookean::tangent(c, deformation(Matrix3d::Identity() + f.gradient).value());
  Vector3d B = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int K = 0; K < 3; ++K)
        for (int L = 0; L < 3; ++L) B[i] -= A(i + 3 * K, j + 3 * L) * f.second[static_cast<size_t>(j)](K, L);
  return B;
}

// L2 norm of the error [-], relative.
double error(const Resolution& mesh) {
  Scene scene = testing::finite_body(Box{size}, rubber, mesh);
  for (const char* face : {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"})
    scene.bodies[0].supports.push_back(testing::support(Support::Kind::fixed, testing::face(face)));
  const auto model = testing::model_of(scene);
  const System& s = model->system();
  const Quadrature rule = testing::rule_of(size, mesh);
  const SparseMatrix U = model->displacement_at(rule.points);
  const Lame c = lame(rubber);
  VectorXd exact(U.rows()), wB(U.rows()), w(U.rows());
  for (Index q = 0; q < rule.weights.size(); ++q) {
    const Field f = field(rule.points.col(q));
    exact.segment<3>(3 * q) = f.u;
    wB.segment<3>(3 * q) = rule.weights[q] * body_force(c, f);
    w.segment<3>(3 * q).setConstant(rule.weights[q]);
  }
  const VectorXd load = U.transpose() * wB;
  VectorXd u = s.u0, f;
  std::optional<Cholesky> factor;
  for (int part = 1; part <= 3; ++part)  // of the load
    for (int i = 0; i < 20; ++i) {
      EXPECT_TRUE(s.stored_energy->force(u, s.v0, f));
      const VectorXd r = load * part / 3 - f;
      if (r.norm() < 1e-11 * load.norm()) break;
      EXPECT_LT(i, 15);
      SparseMatrix K = 0 * s.K;
      EXPECT_TRUE(s.stored_energy->add_tangent(u, 1, 0, K));
      factor ? factor->refactor(K) : void(factor.emplace(K));
      u += factor->solve(r);
    }
  const VectorXd e = U * u - exact;
  return std::sqrt(e.dot(w.cwiseProduct(e)) / exact.dot(w.cwiseProduct(exact)));
}

TEST(FiniteStrainVerification, ManufacturedSolutionsConvergeAtFullOrder) {
  const Field middle = field({0.02, 0.05, 0.1});
  EXPECT_GT(middle.gradient.cwiseAbs().maxCoeff(), 0.1);
  double lacking = 0;
  for (const auto& [degree, coarse] : {std::pair{1, std::vector{4, 4, 6}}, {2, {2, 2, 3}}, {3, {2, 1, 2}}}) {
    std::vector<int> fine = coarse;
    for (int& n : fine) n *= 2;
    const double e_coarse = error({degree, coarse}), e_fine = error({degree, fine});
    const double order = std::log2(e_coarse / e_fine);
    EXPECT_GT(order, degree + 1 - 0.2);  // not yet in the asymptotic range
    lacking = worse(lacking, degree + 1 - order);
  }
  testing::expect_verified(
      {.quantity =
           "what the order in the mesh of elements of degree p = 1, 2, 3 lacks to p + 1, absolute: displacement "
           "of a neo-Hookean box at rest under large strain, L2 norm",
       .reference = "manufactured solution",
       .source = "a field of sines; its body force by the code's tangent of the material, pointwise",
       .uncertainty = "1e-11 of the load, at which Newton's method stops",
       .tolerance = 0.2,
       .why = "One halving of meshes of 1 to 6 cells a side is not yet in the asymptotic range."},
      lacking);
}

}  // namespace
}  // namespace mb
