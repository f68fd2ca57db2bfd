// Manufactured solutions: a box held on all its faces is deformed by
//
//   u = sum_k a_k sin(k_x pi x/l_x) sin(k_y pi y/l_y) sin(k_z pi z/l_z),   B_i = -A_iKjL(F) d_K d_L u_j
//
// as the body force B [N/m^3] balances it. Strains reach a half.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/geometry/gauss.h"
#include "mechanics/material/neo_hookean.h"
#include "reference/finite_bodies_test.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using Eigen::Matrix3d;

const Vector3d size(0.3, 0.2, 0.4);  // [m]
const Material rubber{2.3e4, 0.35, 1100};

struct Field {
  Vector3d u;
  Matrix3d gradient;
  std::array<Matrix3d, 3> second;  // of component j
};
Field field(const Vector3d& X) {
  Field f{Vector3d::Zero(), Matrix3d::Zero(), {Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()}};
  const std::array<std::pair<Vector3d, Vector3d>, 2> waves{
      std::pair{Vector3d(0.012, -0.009, 0.02), Vector3d(1, 1, 1)},
      std::pair{Vector3d(-0.004, 0.006, 0.005), Vector3d(1, 1, 2)}};
  for (const auto& [a, k] : waves) {
    const Vector3d q = pi * k.cwiseQuotient(size);
    Vector3d s, c;
    for (int i = 0; i < 3; ++i)
      s[i] = std::sin(q[i] * (X[i] + size[i] / 2)), c[i] = std::cos(q[i] * (X[i] + size[i] / 2));
    const double product = s.prod();
    const Vector3d first(q[0] * c[0] * s[1] * s[2], q[1] * s[0] * c[1] * s[2], q[2] * s[0] * s[1] * c[2]);
    Matrix3d second;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        second(i, j) = i == j ? -q[i] * q[i] * product : q[i] * q[j] * c[i] * c[j] * s[3 - i - j];
    f.u += a * product;
    f.gradient += a * first.transpose();
    for (int j = 0; j < 3; ++j) f.second[static_cast<size_t>(j)] += a[j] * second;
  }
  return f;
}

Vector3d body_force(const Lame& c, const Field& f) {
  const Matrix9d A = neo_hookean::tangent(c, deformation(Matrix3d::Identity() + f.gradient).value());
  Vector3d B = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int K = 0; K < 3; ++K)
        for (int L = 0; L < 3; ++L) B[i] -= A(i + 3 * K, j + 3 * L) * f.second[static_cast<size_t>(j)](K, L);
  return B;
}

// Gauss's rule in every cell, p + 2 points a direction.
Quadrature rule_of(const Resolution& mesh) {
  const Rule rule = gauss_legendre(mesh.degree + 2);
  const Index n = rule.x.size();
  std::array<VectorXd, 3> x, w;
  for (size_t d = 0; d < 3; ++d) {
    const auto i = static_cast<Index>(d);
    const double h = size[i] / mesh.cells[d];
    x[d].resize(n * mesh.cells[d]), w[d].resize(n * mesh.cells[d]);
    for (Index cell = 0; cell < mesh.cells[d]; ++cell)
      for (Index q = 0; q < n; ++q)
        x[d][n * cell + q] = -size[i] / 2 + h * (static_cast<double>(cell) + rule.x[q]),
                        w[d][n * cell + q] = h * rule.w[q];
  }
  Quadrature all{Matrix3Xd(3, x[0].size() * x[1].size() * x[2].size()),
                 VectorXd(x[0].size() * x[1].size() * x[2].size())};
  Index at = 0;
  for (Index i = 0; i < x[0].size(); ++i)
    for (Index j = 0; j < x[1].size(); ++j)
      for (Index k = 0; k < x[2].size(); ++k, ++at)
        all.points.col(at) << x[0][i], x[1][j], x[2][k], all.weights[at] = w[0][i] * w[1][j] * w[2][k];
  return all;
}

// L2 norm of the error [-], relative.
double error(const Resolution& mesh) {
  Scene scene = testing::finite_body(Box{size}, rubber, mesh);
  for (const char* face : {"x-min", "x-max", "y-min", "y-max", "z-min", "z-max"})
    scene.bodies[0].supports.push_back(testing::support(Support::Kind::fixed, testing::face(face)));
  const auto model = testing::model_of(scene);
  const System& s = model->system();
  const Quadrature rule = rule_of(mesh);
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
  for (const auto& [degree, coarse] : {std::pair{1, std::vector{4, 4, 6}}, {2, {2, 2, 3}}, {3, {2, 1, 2}}}) {
    std::vector<int> fine = coarse;
    for (int& n : fine) n *= 2;
    const double e_coarse = error({degree, coarse}), e_fine = error({degree, fine});
    EXPECT_GT(std::log2(e_coarse / e_fine), degree + 1 - 0.2);  // not yet in the asymptotic range
  }
}

}  // namespace
}  // namespace mb
