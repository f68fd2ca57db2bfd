#include "reference/fem/stress_stiffness.h"

#include <gtest/gtest.h>

#include "cases/scene/one_body.h"
#include "reference/fem/assembly.h"
#include "reference/full_model.h"

namespace mb::fem {
namespace {

const Material steel{2e11, 0.3, 7800};
const Vector3d size{0.3, 0.02, 0.05};

VectorXd field(const Discretisation& d, const Eigen::Matrix3d& H) { return (H * d.node_positions()).reshaped(); }

TEST(StressStiffness, IsTheWorkOfAStressOnSecondOrderStrain) {
  const Discretisation d(Box{size}, {2, {3, 1, 2}}, {});
  const double e = 1e-4, V = size.prod(), E = steel.youngs_modulus;
  const Eigen::Matrix3d pulled = Vector3d(e, -0.3 * e, -0.3 * e).asDiagonal();  // sigma_xx = E e alone
  const SparseMatrix G = stress_stiffness(d, steel, field(d, pulled));
  EXPECT_LT((G - SparseMatrix(G.transpose())).norm(), 1e-14 * G.norm());
  const auto work = [&](const Eigen::Matrix3d& H) { return field(d, H).dot(G * field(d, H)); };
  Eigen::Matrix3d H;
  H << 0.1, 0.4, -0.2, 0.7, 0.3, 0.5, -0.6, 0.2, 0.9;
  EXPECT_NEAR(work(H), E * e * V * H.col(0).squaredNorm(), 1e-12 * E * e * V);
  const Vector3d shift = Vector3d::Ones();
  EXPECT_LT((G * shift.replicate(d.n_nodes(), 1)).norm(), 1e-12 * G.norm());
}

TEST(StressStiffness, IsLinearInTheStress) {
  const Discretisation d(Sphere{0.1}, {2, {1}}, {});
  const VectorXd u = VectorXd::LinSpaced(d.n_dofs(), -1e-3, 2e-3), v = u.array().square();
  const SparseMatrix both = stress_stiffness(d, steel, u - 2 * v),
                     parts = stress_stiffness(d, steel, u) - 2 * stress_stiffness(d, steel, v);
  EXPECT_LT((both - parts).norm(), 1e-13 * both.norm());
  EXPECT_THROW(stress_stiffness(d, steel, u.head(5)), std::invalid_argument);
}

TEST(StressStiffness, OfAModelIsItsMeshs) {
  const Scene scene = one_body(Box{size}, steel, {1, {2, 1, 1}});
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const Discretisation d(Box{size}, {1, {2, 1, 1}}, {});
  const VectorXd u = VectorXd::LinSpaced(d.n_dofs(), -1e-3, 2e-3);
  const SparseMatrix G = stress_stiffness(d, steel, u);
  EXPECT_LT((model->stress_stiffness(u) - G).norm(), 1e-14 * G.norm());
}

}  // namespace
}  // namespace mb::fem
