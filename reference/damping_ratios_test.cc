#include <gmock/gmock.h>

#include "mechanics/algebra/dense_eigen.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

const Material rubber{2e4, 0.45, 1100};

// All modes by a dense solver; asked for n elastic ones it returns n + extra.
ModeSolver dense_modes(int extra) {
  return [extra](const System& s, const Body&, int n_elastic) {
    const EigenPairs eigen = generalized_eigen(MatrixXd(s.K), MatrixXd(s.M)).value();
    Modes modes;
    modes.n_rigid = s.R.cols();
    const Index n = std::min<Index>(s.K.rows(), modes.n_rigid + n_elastic + extra);
    modes.omega = eigen.values.head(n).cwiseMax(0).cwiseSqrt();
    modes.omega.head(modes.n_rigid).setZero();
    modes.Phi = eigen.vectors.leftCols(n);
    return modes;
  };
}

Scene bar(const Rayleigh& damping, const std::vector<double>& ratios) {
  Scene scene = one_body(Box{{0.1, 0.12, 0.3}}, rubber, {2, {1, 1, 2}});
  scene.bodies[0].damping = damping;
  scene.bodies[0].damping_ratios = ratios;
  return scene;
}

// Phi^T C Phi = diag(2 zeta omega), with C = alpha (M - M R R^T M) + beta K + W diag(d) W^T written out.
TEST(DampingRatios, AreWhatTheModesGet) {
  const std::vector<double> ratios = {0.02, 0.01, 0.05};
  for (const Rayleigh& rayleigh : {Rayleigh{}, Rayleigh{1.5, 2e-3}})  // the second exceeds the ratios in higher modes
    for (const bool free : {true, false}) {
      Scene scene = bar(rayleigh, ratios);
      if (!free) scene.bodies[0].supports = {testing::support(Support::Kind::fixed, testing::face("z-min"))};
      const auto model = full_model(scene, scene.bodies[0], scene.bodies[0].resolution, dense_modes(2));
      const System& s = model->system();
      ASSERT_EQ(s.modal_damping.d.size(), 5);
      const MatrixXd M = s.M, MR = s.M * s.R;
      const MatrixXd C = rayleigh.alpha * (M - MR * MR.transpose()) + rayleigh.beta * MatrixXd(s.K) +
                         s.modal_damping.W * s.modal_damping.d.asDiagonal() * s.modal_damping.W.transpose();
      const Modes modes = dense_modes(4)(s, scene.bodies[0], 3);  // two more than have ratios
      const MatrixXd c = modes.Phi.transpose() * C * modes.Phi;
      for (Index i = 0; i < modes.size(); ++i) {
        const Index elastic = i - modes.n_rigid;
        const double omega = modes.omega[i];
        double expected = 0;  // rigid modes: undamped
        if (elastic >= 5)
          expected = rayleigh.alpha + rayleigh.beta * omega * omega;
        else if (elastic >= 0)
          expected = 2 * ratios[static_cast<size_t>(std::min<Index>(elastic, 2))] * omega;
        EXPECT_NEAR(c(i, i), expected, 1e-8 * modes.omega.maxCoeff()) << i << (free ? " free" : " fixed");
      }
      const double off = (c - MatrixXd(c.diagonal().asDiagonal())).cwiseAbs().maxCoeff();
      EXPECT_LT(off, 1e-8 * modes.omega.maxCoeff());
    }
}

TEST(DampingRatios, NeedASolverAndSense) {
  const auto model = [](const std::vector<double>& ratios, const ModeSolver& modes) {
    const Scene scene = bar({}, ratios);
    return full_model(scene, scene.bodies[0], scene.bodies[0].resolution, modes);
  };
  EXPECT_EQ(model({}, {})->system().modal_damping.d.size(), 0);
  EXPECT_EQ(model({}, {})->system().modal_damping.W.rows(), model({}, {})->system().M.rows());
  EXPECT_THROW(model({0.02}, {}), std::invalid_argument);
  for (const double bad : {-0.01, 1.1e9, std::nan("")})
    EXPECT_THROW(model({bad}, dense_modes(0)), std::invalid_argument);
  EXPECT_THROW(model({0.02, 0.02}, dense_modes(-1)), std::invalid_argument);  // one mode for two ratios
}

TEST(DampingRatios, MustAgreeWithinAMultiplet) {
  const auto of_square_bar = [](const std::vector<double>& ratios) {
    Scene scene = one_body(Box{{0.1, 0.1, 0.3}}, rubber, {1, {1, 1, 2}});  // bends alike both ways
    scene.bodies[0].supports = {testing::support(Support::Kind::fixed, testing::face("z-min"))};
    scene.bodies[0].damping_ratios = ratios;
    return full_model(scene, scene.bodies[0], scene.bodies[0].resolution, dense_modes(0));
  };
  EXPECT_EQ(of_square_bar({0.02, 0.02, 0.1})->system().modal_damping.d.size(), 3);
  EXPECT_THAT(
      [&] {
        of_square_bar({0.02, 0.2});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(
          ::testing::HasSubstr("damping ratios 0.02 and 0.2 of the elastic modes 1 and 2, which have one frequency")));
}

TEST(BuildModel, HandsTheSolverOn) {
  const auto scene = std::make_shared<Scene>(bar({}, {0.02, 0.02}));
  EXPECT_EQ(build_model(scene, nullptr, dense_modes(0)).bodies[0].full->system().modal_damping.d.size(), 2);
  EXPECT_THROW(build_model(scene), std::invalid_argument);
}

}  // namespace
}  // namespace mb
