#include "harness/analysis/telescope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/metrics/motion.h"

namespace mb {
namespace {

Telescope of(const std::vector<MatrixXd>& chain) { return telescope({chain.begin(), chain.end()}); }

TEST(Telescope, PartsAndCrossTermsMakeUpTheTotal) {
  std::vector<MatrixXd> chain;
  for (int i = 0; i < 4; ++i) chain.push_back(MatrixXd::Random(30, 7));
  const Telescope found = of(chain);
  EXPECT_NEAR(found.parts.squaredNorm() + found.cross.sum(), found.total * found.total, 1e-12);
  EXPECT_NEAR(found.parts(1), (chain[1] - chain[2]).norm() / chain[3].norm(), 1e-14);
  EXPECT_NEAR(found.total, (chain[0] - chain[3]).norm() / chain[3].norm(), 1e-14);
}

TEST(Telescope, TellsPartsThatAddFromPartsThatHideEachOther) {
  const MatrixXd truth = MatrixXd::Ones(2, 2), step = MatrixXd::Constant(2, 2, 0.1);
  const Telescope adding = of({truth + 2 * step, truth + step, truth});
  EXPECT_NEAR(adding.total, adding.parts.sum(), 1e-14);
  EXPECT_NEAR(adding.cross(0, 1), 2 * 0.1 * 0.1, 1e-14);
  const Telescope hiding = of({truth, truth + step, truth});
  EXPECT_EQ(hiding.total, 0);
  EXPECT_NEAR(hiding.cross(0, 1), -2 * 0.1 * 0.1, 1e-14);
}

TEST(Telescope, RefusesBadInputAndVanishingTruths) {
  EXPECT_THROW(of({}), std::invalid_argument);
  EXPECT_THROW(of({MatrixXd::Ones(2, 2)}), std::invalid_argument);
  EXPECT_THROW(of({MatrixXd::Ones(2, 2), MatrixXd::Ones(2, 3)}), std::invalid_argument);
  const Telescope of_nothing = of({MatrixXd::Ones(2, 2), MatrixXd::Zero(2, 2)});
  EXPECT_TRUE(std::isnan(of_nothing.total));
  EXPECT_TRUE(std::isnan(of({MatrixXd::Constant(2, 2, NAN), MatrixXd::Ones(2, 2)}).total));
}

// The norms are those of the metrics: a telescope of one part is displacement-error and strain-error.
TEST(Telescope, OfOnePartIsTheMetric) {
  Scene scene;
  scene.bodies.push_back({.name = "box",
                          .shape = Box{{0.1, 0.2, 0.3}},
                          .material = {2e4, 0.3, 1100},
                          .damping = {},
                          .damping_ratios = {},
                          .resolution = {1, {1, 1, 1}},
                          .supports = {}});
  const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  const MetricContext context{scene, 0, points, true};
  Trajectory truth{VectorXd::LinSpaced(5, 0, 1), {}, {}, Status::ok}, answer = truth;
  const Index n = points.volume.points.cols();
  truth.bodies.push_back({1e-3 * MatrixXd::Random(3 * points.size(), 5), 1e-2 * MatrixXd::Random(6 * n, 5)});
  answer.bodies.push_back({1e-3 * MatrixXd::Random(3 * points.size(), 5), 1e-2 * MatrixXd::Random(6 * n, 5)});
  const Telescope mass = of({in_mass_norm(answer, context), in_mass_norm(truth, context)});
  EXPECT_NEAR(mass.total, mark(metric("displacement-error"), answer, truth, context).value, 1e-10 * mass.total);
  const Telescope energy = of({in_energy_norm(answer, context), in_energy_norm(truth, context)});
  EXPECT_NEAR(energy.total, mark(metric("strain-error"), answer, truth, context).value, 1e-10 * energy.total);
}

}  // namespace
}  // namespace mb
