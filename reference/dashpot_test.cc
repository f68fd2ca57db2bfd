#include <gtest/gtest.h>

#include "mechanics/algebra/dense_eigen.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

const Material rubber{2e4, 0.3, 1100};

Scene held_bar() {
  Scene scene = one_body(Box{{0.1, 0.12, 0.3}}, rubber, {2, {1, 1, 2}});
  scene.bodies[0].supports = {testing::support(Support::Kind::fixed, testing::face("z-min"))};
  return scene;
}

System braked(const Scene& scene) { return full_model(scene, scene.bodies[0], scene.bodies[0].resolution)->system(); }

// v = a + b x on the face: the dashpot feels the mean, c (v . n), whatever the mesh; and its force is spread alike.
TEST(Dashpot, FeelsTheMeanVelocityOfItsPatch) {
  Scene scene = held_bar();
  scene.bodies[0].dashpots = {{{"z-max", {}}, Vector3d(0.6, 0, 0.8), 3.5}};
  const System s = braked(scene);
  const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
  const VectorXd x = model->places();  // of every free unknown, its own coordinate
  ASSERT_EQ(s.modal_damping.d.size(), 1);
  EXPECT_EQ(s.modal_damping.d[0], 3.5);
  // u_z = z + 0.15 vanishes at the support, is 0.3 all over the face: as nodes have it, u = G (x - x_support).
  const VectorXd along = model->translation({0, 0, 1}).cwiseProduct(VectorXd(x.array() + 0.15));
  EXPECT_NEAR(s.modal_damping.W.col(0).dot(along), 0.8 * 0.3, 1e-14);
  EXPECT_NEAR(s.modal_damping.W.col(0).dot(model->translation({1, 0, 0})), 0.6, 1e-14);
  EXPECT_NEAR(s.modal_damping.W.col(0).dot(model->translation({0, 1, 0})), 0, 1e-14);
  EXPECT_NEAR(along.dot(apply_damping(s, along)), 3.5 * 0.24 * 0.24, 1e-13);
}

TEST(Dashpot, StandsBesideRatiosOfModes) {
  Scene scene = held_bar();
  scene.bodies[0].dashpots = {{{"z-max", Disc{{0, 0, 0.15}, 0.04}}, Vector3d(0, 0, 1), 2}};
  scene.bodies[0].damping_ratios = {0.02};
  const ModeSolver two = [](const System& s, const Body&, int) {
    const EigenPairs eigen = generalized_eigen(MatrixXd(s.K), MatrixXd(s.M)).value();
    Modes modes;
    modes.n_rigid = 0;
    modes.omega = eigen.values.head(2).cwiseSqrt();
    modes.Phi = eigen.vectors.leftCols(2);
    return modes;
  };
  const System s = full_model(scene, scene.bodies[0], scene.bodies[0].resolution, two)->system();
  ASSERT_EQ(s.modal_damping.d.size(), 3);
  EXPECT_EQ(s.modal_damping.d[2], 2);
  EXPECT_EQ(s.modal_damping.W.cols(), 3);
}

}  // namespace
}  // namespace mb
