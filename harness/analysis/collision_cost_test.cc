// What must hold between the numbers of the contest of collision detection, but for times, which are as they are.
#include "harness/analysis/collision_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mb {
namespace {

const CollisionSizes small{{2, 3, 5, 8}, 3, 2e6, 1, 0};  // three of brute force: no fewer tell an exponent

const Finding& table_of(const std::vector<Finding>& all, const std::string& name) {
  for (const Finding& one : all)
    if (one.name == name) return one;
  throw std::out_of_range(name);
}

struct Row {
  const Finding& table;
  const std::vector<FindingCell>& cells;
  const FindingCell& cell(const std::string& column) const {
    for (size_t j = 0; j < table.columns.size(); ++j)
      if (table.columns[j].name == column) return cells.at(j);
    throw std::out_of_range(column);
  }
  double number(const std::string& column) const { return std::get<double>(cell(column)); }
  std::string text(const std::string& column) const { return std::get<std::string>(cell(column)); }
};
std::vector<Row> rows(const Finding& table) {
  std::vector<Row> all;
  for (const auto& cells : table.rows) all.push_back({table, cells});
  return all;
}

const std::vector<Finding>& findings() {
  static const std::vector<Finding> all = collision_cost(Cylinder{0.4, 1.2}, small);
  return all;
}

TEST(CollisionCost, TablesAreWhole) {
  for (const Finding& table : findings()) {
    EXPECT_EQ(table.analysis, "collision-cost");
    EXPECT_FALSE(table.rows.empty());
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.name;
  }
}

TEST(CollisionCost, TestsAreCountedExactly) {
  for (const Row& row : rows(table_of(findings(), "collision-cost"))) {
    const double n = row.number("polygons n"), m = row.number("points m"), tests = row.number("tests");
    const std::string contender = row.text("contender");
    EXPECT_DOUBLE_EQ(row.number("tests a point"), tests / m);
    EXPECT_GE(row.number("time"), 0);
    EXPECT_EQ(std::isnan(n), contender.starts_with("analytic"));
    if (contender == brute_force) {
      EXPECT_EQ(tests, n * m);
    }
    if (contender == analytic_distance || contender == analytic_function) {
      EXPECT_EQ(tests, m);
    }
    if (contender == tree || contender == tree_within_reach) {
      EXPECT_LT(tests, n * m);
    }
    if (row.text("sweep") == "n = m" && !std::isnan(n)) {
      EXPECT_EQ(n, m);
    }
    if (row.text("sweep") == "n = 432" && !std::isnan(n)) {
      EXPECT_EQ(n, 432);
    }
    EXPECT_EQ(std::isnan(row.number("building")), !contender.starts_with(tree));
  }
}

// By counts, not by times: O(n m), O(m), and between them the tree, by theory m log n near the surface, m sqrt(n) from
// afar.
TEST(CollisionCostVerification, TestsGrowAsTheorySays) {
  for (const Row& row : rows(table_of(findings(), "collision-cost-exponents"))) {
    const double p = row.number("exponent of tests"), theory = row.number("theory");
    const std::string contender = row.text("contender");
    if (!std::isnan(theory)) {
      const bool counts_what_it_finds =
          contender == tree || contender == tree_within_reach || contender == depth_inside;
      EXPECT_NEAR(p, theory, counts_what_it_finds ? 0.1 : 1e-12) << contender;  // 200 points are few
    } else {
      EXPECT_GT(p, 1);
      EXPECT_LT(p, 1.5);
    }
  }
}

TEST(CollisionCost, ExponentsOfItsClaimHaveTheirStandardErrors) {
  const Finding& claim = table_of(findings(), "collision-cost-claim");
  ASSERT_EQ(claim.rows.size(), 6u);
  for (const Row& row : rows(table_of(findings(), "collision-cost-exponents")))
    for (std::size_t i = 0; i < claim.rows.size(); ++i) {
      const std::string against = row.text("contender") + "; " + row.text("partner");
      if (row.text("sweep") != "n = m" || std::get<std::string>(claim.rows[i][1]) != against) continue;
      EXPECT_EQ(std::get<double>(claim.rows[i][3]), row.number("exponent of tests")) << against;
      EXPECT_EQ(claim.bars.at(i)[3], row.number("standard error of tests")) << against;
      EXPECT_TRUE(std::isfinite(claim.bars[i][2])) << against;
    }
}

// Chords: n^-1 in n polygons, the square of their size.
TEST(CollisionCostVerification, DepthsOfPolygonsAreOffByTheirChords) {
  for (const char* partner : {"sphere", "superquadric"}) {
    std::vector<double> n, error;
    for (const Row& row : rows(table_of(findings(), "collision-cost")))
      if (row.text("partner") == partner && row.text("sweep") == "n = m" && row.text("contender") == tree) {
        n.push_back(row.number("polygons n"));
        error.push_back(row.number("depth error"));
      } else if (row.text("contender") == analytic_distance || row.text("contender") == depth_inside) {
        EXPECT_LT(row.number("depth error"), 1e-15);
      }
    const auto size = static_cast<Index>(n.size());
    const PowerLaw law =
        power_law(Eigen::Map<const VectorXd>(n.data(), size), Eigen::Map<const VectorXd>(error.data(), size));
    EXPECT_NEAR(law.exponent, -1, 0.25) << partner;  // of the largest error, at points that differ
  }
}

TEST(CollisionCost, BruteForceGivesUpAndNoOneElse) {
  int n_brute = 0, n_tree = 0;
  for (const Row& row : rows(table_of(findings(), "collision-cost"))) {
    n_brute += row.text("contender") == brute_force;
    n_tree += row.text("contender") == tree;
    if (row.text("contender") == brute_force) {
      EXPECT_LE(row.number("tests"), small.most_products);
    }
  }
  EXPECT_EQ(n_tree, 16);
  EXPECT_LT(n_brute, n_tree);
}

TEST(CollisionCost, VerdictsFollowFromExponentsAndCrossover) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(collision_verdict(1.02, 1.95, 192, 192, false), "holds");
  EXPECT_EQ(collision_verdict(1.02, 1.95, 500, 192, false), "holds within limits: cheaper from m = 500 on");
  EXPECT_EQ(collision_verdict(1.02, 1.95, nan, 192, false), "holds within limits: not cheaper at the largest size");
  EXPECT_EQ(collision_verdict(1.02, 1.2, 192, 192, false), "does not hold: the rival ~ m^1.20; cheaper at all sizes");
  EXPECT_EQ(collision_verdict(1.3, 2, 500, 192, false), "does not hold: analytic ~ m^1.30; cheaper from m = 500 on");
  EXPECT_EQ(collision_verdict(1, 2, nan, 192, true), "not decided: times perturbed by other work");
  EXPECT_EQ(collision_verdict(1, 1.3, nan, 192, true),
            "does not hold: the rival ~ m^1.30; times perturbed by other work");
  EXPECT_EQ(collision_verdict(1, nan, 500, 192, false), "not decided: too few sizes");
}

TEST(CollisionCost, BadSizesAndPartnersAreRefused) {
  EXPECT_THROW(collision_contest(Sphere{1}, Box{{1, 1, 1}}, small), std::invalid_argument);
  EXPECT_THROW(collision_contest(Sphere{1}, Sphere{1}, {{}, 1, 1, 1, 0}), std::invalid_argument);
  EXPECT_THROW(collision_contest(Sphere{1}, Sphere{1}, {{0}, 1, 1, 1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
