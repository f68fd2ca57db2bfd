#include "harness/metrics/gci.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/types.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

// Pressure recovery on three meshes: NASA's worked example, in double precision.
TEST(GridConvergenceVerification, WorkedExample) {
  const auto g = grid_convergence(0.97050, 0.96854, 0.96178, 2, 1.8);
  ASSERT_TRUE(g);
  testing::expect_verified(
      {.quantity = "observed order and extrapolated pressure recovery, from three meshes",
       .reference = "published",
       .source =
           "NASA Glenn, Examining Spatial (Grid) Convergence, worked example, its digits continued to nine places",
       .uncertainty = "5e-10, nine digits after the point",
       .tolerance = 1e-9,
       .why = "Differences of 2e-3 of answers near 1 are known to 1e-13; the figures end at nine digits."},
      Eigen::Vector2d(g->order - 1.786169592, g->extrapolated - 0.971300333)
          .cwiseAbs()
          .maxCoeff<Eigen::PropagateNaN>());
  EXPECT_NEAR(100 * g->fine, 0.10308260, 1e-8);
  EXPECT_NEAR(100 * g->coarse, 0.35624927, 1e-8);
  EXPECT_NEAR(g->asymptotic, 0.97050 / 0.96854, 1e-12);  // |f1/f2|
}

// Of f = f* + c h^p the order and the limit are found exactly, from above and below, at any ratio.
TEST(GridConvergenceTest, PowersOfTheSpacing) {
  for (const double order : {0.5, 1.0, 2.0, 3.7})
    for (const double ratio : {1.3, 2.0, 3.0})
      for (const double c : {0.02, -0.02})
        for (const double limit : {5.0, -5.0}) {
          const auto f = [&](double h) { return limit + c * std::pow(h, order); };
          const auto g = grid_convergence(f(1), f(ratio), f(ratio * ratio), ratio, order);
          ASSERT_TRUE(g);
          // differences of 0.003 of numbers of size 5: eps x 5/0.003, over ln 1.3
          EXPECT_NEAR(g->order, order, 1e-11);
          EXPECT_NEAR(g->extrapolated, limit, 1e-11);
          EXPECT_NEAR(g->fine, 1.25 * std::abs(c / f(1)), 1e-11);
          EXPECT_NEAR(g->coarse, 1.25 * std::abs(f(ratio) - limit) / std::abs(f(ratio)), 1e-11);
        }
}

TEST(GridConvergenceTest, NothingWithoutMonotoneConvergence) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(grid_convergence(1, 1, 1, 2, 2));
  EXPECT_FALSE(grid_convergence(1, 1, 2, 2, 2));    // the finer two agree: of any order
  EXPECT_FALSE(grid_convergence(1, 2, 2, 2, 2));    // the coarser two agree
  EXPECT_FALSE(grid_convergence(1, 2, 1.5, 2, 2));  // oscillates
  EXPECT_FALSE(grid_convergence(1, 2, 2.5, 2, 2));  // drifts apart
  EXPECT_FALSE(grid_convergence(1, 2, 3, 2, 2));    // order 0
  EXPECT_FALSE(grid_convergence(0, 1, 5, 2, 2));    // relative to nothing
  EXPECT_FALSE(grid_convergence(-1, 0, 5, 2, 2));
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_FALSE(grid_convergence(bad, 1, 3, 2, 2));
    EXPECT_FALSE(grid_convergence(1, bad, 3, 2, 2));
    EXPECT_FALSE(grid_convergence(1, 2, bad, 2, 2));
  }
}

// Differences that are small by chance, and orders below that of theory.
TEST(GridConvergenceTest, OffTheOrderOfTheoryTheBandIsWide) {
  const auto lucky = grid_convergence(1, 1.0001, 2, 2, 2), slow = grid_convergence(1, 1.1, 1.25, 2, 2);
  ASSERT_TRUE(lucky && slow);
  EXPECT_NEAR(lucky->order, std::log2(0.9999 / 1e-4), 1e-9);
  EXPECT_NEAR(lucky->fine, 3 * 1e-4 / (4 - 1), 1e-12) << "no better than of order 2";
  EXPECT_NEAR(slow->fine, 3 * 0.1 / (1.5 - 1), 1e-12);
  for (const double bad : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(grid_convergence(1, 2, 4, 2, bad), std::invalid_argument);
}

TEST(GridConvergenceTest, OfTwoMeshesIsThreeTimesTheErrorOfTheOrderOfTheory) {
  const auto f = [](double h) { return 5 - 0.02 * std::pow(h, 3); };
  EXPECT_NEAR(*gci_of_two(f(1), f(1.5), 1.5, 3), 3 * 0.02 / f(1), 1e-12);
  EXPECT_EQ(gci_of_two(5, 5, 2, 1), 0);
  EXPECT_FALSE(gci_of_two(0, 1, 2, 1));
  EXPECT_FALSE(gci_of_two(std::nan(""), 1, 2, 1));
  EXPECT_FALSE(gci_of_two(1, std::numeric_limits<double>::infinity(), 2, 1));
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(gci_of_two(1, 2, 2, bad), std::invalid_argument);
    EXPECT_THROW(gci_of_two(1, 2, bad, 1), std::invalid_argument);
  }
}

TEST(GridConvergenceTest, BadRatio) {
  for (const double ratio : {1.0, 0.5, 0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(grid_convergence(1, 2, 4, ratio, 2), std::invalid_argument);
}

}  // namespace
}  // namespace mb
