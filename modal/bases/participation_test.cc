// Degrees and participation of modes: sums over all of them, and shapes whose degree is known.
#include "modal/bases/participation.h"
#include "mechanics/algebra/dense_eigen.h"

#include <gtest/gtest.h>

#include "mechanics/algebra/box_test_system.h"
#include "modal/bases/verification_test.h"

namespace mb {
namespace {

using testing::box_system;
using testing::BoxSystem;
using testing::radius;
using testing::steel;
using testing::with_supports;

MatrixXd translations(Index n_nodes) { return Eigen::Matrix3d::Identity().replicate(n_nodes, 1); }

// All modes of K phi = lambda M phi, rigid ones included.
MatrixXd every_mode(const System& system) {
  return generalized_eigen(MatrixXd(system.K), MatrixXd(system.M)).value().vectors;
}

TEST(ParticipationTest, OfAClampedBoxAddsUpToWhatItsFreeNodesCarry) {
  testing::BoxMesh mesh{.cells = {2, 2, 3}, .size = {0.1, 0.1, 0.3}, .rho = 1000};
  const BoxSystem free = box_system(mesh);
  mesh.fixed = [](const Vector3d& x, int) { return x[2] == 0; };
  const BoxSystem clamped = box_system(mesh);
  const MatrixXd r = translations(free.nodes.cols());
  MatrixXd at_free(clamped.system.M.rows(), 3);
  for (size_t i = 0; i < clamped.dof.size(); ++i)
    if (clamped.dof[i] >= 0) at_free.row(clamped.dof[i]) = r.row(static_cast<Index>(i));
  const double mass = 1000 * 0.1 * 0.1 * 0.3;
  const MatrixXd Mr = clamped.system.M * at_free;
  const MatrixXd shares = participation(every_mode(clamped.system), Mr, mass);
  const VectorXd carried = (at_free.transpose() * Mr).diagonal() / mass;
  EXPECT_LT((shares.colwise().sum().transpose() - carried).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_GT(shares.minCoeff(), -1e-30);
  EXPECT_NEAR(carried(0), 7. / 9, 1e-12);  // of the first of three layers int (z/h)^2 dz/h = 1/3
}

TEST(ParticipationTest, OfAFreeBodyIsAllInItsRigidModes) {
  const Scene scene = one_body(Cylinder{radius, 4 * radius}, steel, {2, {1, 2}});
  const auto full = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const Modes modes = lowest_modes(full->system(), 8, physical_shift(scene.bodies[0]));
  const MatrixXd Mr = translated_mass(*full, volume_quadrature(scene.bodies[0].shape), steel.density);
  const MatrixXd shares = participation(modes.Phi, Mr, steel.density * full->mesh_volume());
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(shares.col(d).head(6).sum(), 1, 1e-4) << d;  // points of the exact circle
  EXPECT_LT(shares.bottomRows(modes.size() - 6).maxCoeff(), 1e-12);
}

TEST(ParticipationTest, OfAClampedBodyIsMostlyInItsFirstBendingModesAndNeverMoreThanAll) {
  const Scene scene =
      with_supports(one_body(Cylinder{radius, 4 * radius}, steel, {2, {1, 2}}), Support::Kind::fixed, {"z-min"});
  const auto full = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const Modes modes = lowest_modes(full->system(), 12, physical_shift(scene.bodies[0]));
  const MatrixXd Mr = translated_mass(*full, volume_quadrature(scene.bodies[0].shape), steel.density);
  const MatrixXd shares = participation(modes.Phi, Mr, steel.density * full->mesh_volume());
  EXPECT_NEAR(shares.col(0).head(2).sum(), 0.61, 0.04);  // 0.613 of a slender cantilever (Clough & Penzien)
  EXPECT_NEAR(shares.col(0).sum(), shares.col(1).sum(), 1e-3);
  for (int d = 0; d < 3; ++d) EXPECT_LT(shares.col(d).sum(), 1) << d;
}

TEST(PolynomialDegreeTest, OfRigidMotionsIsZeroOrOneAndOfMonomialsTheirOwn) {
  const Scene scene = one_body(Box{{1, 1, 1}}, steel, {4, {2, 2, 2}});
  const auto full = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const Modes modes = lowest_modes(full->system(), 0, physical_shift(scene.bodies[0]));
  for (const int degree : polynomial_degrees(*full, modes.Phi.leftCols(6))) EXPECT_LE(degree, 1);
  const MatrixXd translation = full->polynomials(0).leftCols(1);
  EXPECT_EQ(polynomial_degrees(*full, translation), std::vector{0});
  // What degree p adds to degree p - 1.
  for (int p = 1; p <= most_degree; ++p) {
    const MatrixXd lower = full->polynomials(p - 1), all = full->polynomials(p);
    MatrixXd added = all.rightCols(1);
    const SparseMatrix& M = full->system().M;
    const MatrixXd gram = lower.transpose() * (M * lower);
    added -= lower * gram.ldlt().solve(lower.transpose() * (M * added));
    EXPECT_EQ(polynomial_degrees(*full, added), std::vector{p}) << p;
  }
}

TEST(PolynomialDegreeTest, WhatNoPolynomialHoldsIsBeyond) {
  const Scene scene = one_body(Box{{1, 1, 1}}, steel, {1, {8, 8, 8}});
  const auto full = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  VectorXd zigzag(full->system().M.rows());
  for (Index i = 0; i < zigzag.size(); ++i) zigzag(i) = i % 2 ? 1 : -1;
  EXPECT_EQ(polynomial_degrees(*full, zigzag), std::vector{beyond});
}

TEST(ParticipationTest, RefusesWhatDoesNotFit) {
  const MatrixXd Phi = MatrixXd::Ones(6, 2), Mr = MatrixXd::Ones(6, 3);
  EXPECT_THROW(participation(Phi, Mr, 0), std::invalid_argument);
  EXPECT_THROW(participation(Phi, Mr.topRows(3), 1), std::invalid_argument);
  EXPECT_THROW(participation(Phi, Mr.leftCols(2), 1), std::invalid_argument);
}

}  // namespace
}  // namespace mb
