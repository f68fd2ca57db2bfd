#include "harness/analysis/poisson_sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "harness/analysis/context_test.h"
#include "harness/analysis/stability_grid.h"

namespace mb {
namespace {

// A short bar held at its foot and pushed aside at its top, of as few cells as show what elements of a degree can.
Scene bar() {
  Scene scene = one_body(Box{{0.1, 0.12, 0.2}}, {1e6, 0.3, 1000}, {2, {1, 1, 2}});
  scene.bodies[0].supports = {{Support::Kind::fixed, {"z-min", {}}, {}}};
  scene.loads = {{"push", Step{}, {{scene.bodies[0].name, {"z-max", {}}, {100, 40, 0}}}}};
  scene.truth.finer = {2, {1, 1, 1}};
  return scene;
}

std::vector<LockingError> errors(const PoissonSweep& sweep, int degree) {
  std::vector<LockingError> all;
  for (size_t i = 0; i < sweep.ratios.size(); ++i)
    all.push_back(locking_error(sweep.answers.at(degree)[i], sweep.truths[i], sweep.weights));
  return all;
}

// Nothing locks where nothing is kept from changing its volume.
TEST(PoissonSweep, HasNoLockingAtZero) {
  const PoissonSweep sweep = poisson_sweep(bar(), {0, 0.02});
  for (const int degree : {1, 2, 3}) {
    const std::vector<LockingError> at = errors(sweep, degree);
    EXPECT_NEAR(at[1].of_displacement / at[0].of_displacement, 1, 0.05) << degree;
    EXPECT_NEAR(at[1].of_frequency / at[0].of_frequency, 1, 0.05) << degree;
  }
}

TEST(PoissonSweep, FindsThatLinearElementsLock) {
  const PoissonSweep sweep = poisson_sweep(bar(), {0.3, 0.4999});
  const auto growth = [&](int degree) {
    const std::vector<LockingError> at = errors(sweep, degree);
    EXPECT_GT(at[1].of_frequency, at[0].of_frequency) << degree;
    return at[1].of_displacement / at[0].of_displacement;
  };
  EXPECT_GT(growth(1), 2);
  EXPECT_LT(errors(sweep, 3)[1].of_displacement, errors(sweep, 1)[1].of_displacement / 2) << "a single cubic";
}

// A bar drawn at its ends, free to shrink: linear displacements, which every element has.
TEST(PoissonSweep, OfUniformStrainHasNoError) {
  Scene scene = bar();
  const std::string name = scene.bodies[0].name;
  scene.bodies[0].supports.clear();
  for (const char* face : {"x-min", "y-min", "z-min"})
    scene.bodies[0].supports.push_back({Support::Kind::sliding, {face, {}}, {}});
  scene.loads = {{"draw", Step{}, {{name, {"z-max", {}}, {0, 0, 300}}}}};
  const PoissonSweep sweep = poisson_sweep(scene, {0, 0.49});
  for (const int degree : {1, 2, 3})  // a residual of 1e-12 of the load times the condition of a few cells, 1e3
    for (const LockingError& at : errors(sweep, degree)) EXPECT_LT(at.of_displacement, 1e-9) << degree;
  const VectorXd along = sweep.truths[0].u.reshaped(3, sweep.truths[0].u.size() / 3).row(2);
  EXPECT_NEAR(along.maxCoeff(), 300 / 1e6 * 0.2, 300 / 1e6 * 0.2 * 0.2) << "of points near the end";
}

TEST(PoissonSweep, RefusesWhatItCannotSweep) {
  Scene ball = bar();
  ball.bodies[0].shape = Sphere{0.1};
  EXPECT_THROW(test::analysed("locking", ball), std::invalid_argument);
  Scene unloaded = bar();
  unloaded.loads.clear();
  EXPECT_THROW(poisson_sweep(unloaded, {0.3}), std::invalid_argument);
  EXPECT_THROW(poisson_sweep(bar(), {0.5}), std::invalid_argument);
  Scene huge = bar();
  huge.truth.finer = {2, {40, 40, 40}};  // of degree 4 and 80 cells a side: a hundred million unknowns
  EXPECT_THAT([&] { poisson_sweep(huge, {0.3}); },
              ::testing::ThrowsMessage<std::runtime_error>(::testing::HasSubstr("takes about")));
}

TEST(Locking, ModesAndStepsTellOfOneMotionAtEveryRatio) {
  const std::vector<Finding> tables = test::analysed("locking", bar());
  const auto dynamics = std::ranges::find(tables, "locking-dynamics", &Finding::name);
  ASSERT_NE(dynamics, tables.end());
  ASSERT_EQ(dynamics->rows.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const auto number = [&](size_t column) { return std::get<double>(dynamics->rows[i][column]); };
    EXPECT_LT(number(3), 0.05) << number(0);
    EXPECT_LT(dynamics->bars[i][3], 1e-3) << number(0);
    EXPECT_LE(number(4), 1 + 1e-9) << number(0);
    EXPECT_LE(number(5), 1 + 1e-9) << number(0);
    EXPECT_GE(number(6), energy_bound) << number(0);
  }
}

}  // namespace
}  // namespace mb
