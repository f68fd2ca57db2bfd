#include "harness/analysis/told.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "harness/analysis/footings.h"
#include "harness/analysis/modal_body.h"

namespace mb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Finding one(std::vector<std::vector<FindingCell>> rows) {
  Finding finding = table("a", "a", "A", "", {{"contender", ""}, {"modes", ""}, {"error", "-"}});
  finding.rows = std::move(rows);
  return finding;
}

TEST(AddBars, AreDistancesOfNumbersThatHaveAUnit) {
  std::vector<Finding> found{one({{"x", 4.0, 0.5}, {"y", 8.0, 0.25}})};
  add_bars(found, {one({{"x", 4.0, 0.625}, {"y", 8.0, 0.25}})}, PerDistance(1));
  ASSERT_EQ(found[0].bars.size(), 2u);
  EXPECT_EQ(found[0].bars[0][2], 0.125);
  EXPECT_EQ(found[0].bars[1][2], 0);
  EXPECT_TRUE(std::isnan(found[0].bars[0][0]));
  EXPECT_TRUE(std::isnan(found[0].bars[0][1])) << "a count";
}

// Modes 2 and 3 change places on the other mesh, and 4 has nothing there that moves alike.
TEST(AddBars, OfModesAreOfThoseThatMoveAlike) {
  Finding own = table("a", "a", "A", "", {{"mode", ""}, {"frequency", "Hz"}});
  Finding other = own;
  own.rows = {{1.0, 10.0}, {2.0, 20.0}, {3.0, 22.0}, {4.0, 40.0}};
  other.rows = {{1.0, 9.0}, {2.0, 19.0}, {3.0, 19.5}, {4.0, 41.0}};
  const ElasticPairs elastic{6, {{0}, {2}, {1}, {}}};
  std::vector<Finding> found{own};
  add_bars(found, {other}, PerDistance(2), &elastic);
  EXPECT_EQ(found[0].bars[0][1], 2);
  EXPECT_EQ(found[0].bars[1][1], 1);
  EXPECT_EQ(found[0].bars[2][1], 6);
  EXPECT_EQ(found[0].bars[3][1], 2) << "as by place";
  std::vector<Finding> by_place{own};
  add_bars(by_place, {other}, PerDistance(2));
  EXPECT_EQ(by_place[0].bars[2][1], 5);
}

// At another frame rate other modes stand in the table: rows are of one rate.
TEST(AddBars, OfModesAreOfOneFrameRate) {
  Finding own = table("a", "a", "A", "", {{"frame rate", "Hz"}, {"mode", ""}, {"frequency", "Hz"}});
  Finding other = own;
  own.rows = {{24.0, 5.0, 20.0}, {60.0, 5.0, 20.0}};
  other.rows = {{24.0, 4.0, 15.0}, {60.0, 5.0, 21.0}};
  const ElasticPairs elastic{0, {{0}, {1}, {2}, {3}, {4}}};
  std::vector<Finding> found{own};
  add_bars(found, {other}, PerDistance(1), &elastic);
  EXPECT_EQ(found[0].bars[0][2], 5) << "none of mode 5 at 24 Hz: by place";
  EXPECT_EQ(found[0].bars[1][2], 1);
  EXPECT_EQ(found[0].bars[1][0], 0);
}

// Two of a pair that is rotated share both; an overdamped mode has two rows, told apart by their places.
TEST(AddBars, OfSeveralRowsAndPairsAreTheLargestInTheirPlace) {
  Finding own = table("a", "a", "A", "", {{"complex mode", ""}, {"undamped mode", ""}, {"frequency", "Hz"}});
  Finding other = own;
  own.rows = {{1.0, 7.0, 1.0}, {2.0, 7.0, 100.0}, {3.0, 8.0, 50.0}};
  other.rows = {{1.0, 8.0, 1.5}, {2.0, 7.0, 49.0}, {3.0, 7.0, 60.0}, {4.0, 8.0, 103.0}};
  const ElasticPairs elastic{6, {{1}, {0, 1}}};
  std::vector<Finding> found{own};
  add_bars(found, {other}, PerDistance(1), &elastic);
  EXPECT_EQ(found[0].bars[0][2], 0.5);
  EXPECT_EQ(found[0].bars[1][2], 3);
  EXPECT_EQ(found[0].bars[2][2], 48.5);
}

// 179 and -179 degrees are 2 apart, whatever that is multiplied by.
TEST(AddBars, ArePhasesApartTheShorterWayRound) {
  for (const auto& [a, b, apart] :
       {std::tuple{179.5, -179.5, 1.}, {-90., 90., 180.}, {10., 130., 120.}, {0., -1., 1.}}) {
    Finding finding = table("a", "a", "A", "", {{"of", ""}, {"phase", "deg"}}), other = finding;
    finding.rows = {{"x", a}};
    other.rows = {{"x", b}};
    std::vector<Finding> found{finding};
    add_bars(found, {other}, PerDistance(2));
    EXPECT_NEAR(found[0].bars.at(0).at(1), 2 * apart, 1e-12) << a << " " << b;
  }
}

// What is not known well enough for its verdict has a bar more than anything.
TEST(AddBars, DoNotDependOnVerdicts) {
  const auto with_verdict = [](double value, const char* verdict) {
    Finding finding = table("a", "a", "A", "", {{"of", ""}, {"error", "-"}, {"verdict", ""}});
    finding.rows = {{"x", value, verdict}};
    return finding;
  };
  std::vector<Finding> found{with_verdict(0.5, "holds")};
  add_bars(found, {with_verdict(0.75, "fails")}, PerDistance(1));
  EXPECT_EQ(found[0].bars.at(0).at(1), 0.25);
  EXPECT_TRUE(std::isnan(found[0].bars[0][2]));
}

TEST(AddBars, AreNoneWhereRowsTellOfSomethingElse) {
  const std::vector<std::vector<FindingCell>> rows{{"x", 4.0, 0.5}};
  std::vector<Finding> found{one(rows)};
  add_bars(found, {one({{"z", 4.0, 0.6}})}, PerDistance(1));
  EXPECT_TRUE(std::isnan(found[0].bars[0][2])) << "another contender";
  add_bars(found, {one({{"x", 4.0, nan}})}, PerDistance(1));
  EXPECT_TRUE(std::isnan(found[0].bars[0][2])) << "no number";
  std::vector<Finding> alone{one(rows)};
  add_bars(alone, {}, PerDistance(1));
  EXPECT_TRUE(alone[0].bars.empty());
}

// A mesh may know fewer modes than another.
TEST(AddBars, AreOfTheRowsThatBothHaveByTheirCounts) {
  std::vector<Finding> found{one({{"x", 4.0, 0.5}, {"x", 8.0, 0.5}, {"x", 9.0, 0.5}})};
  add_bars(found, {one({{"x", 4.0, 0.625}, {"x", 9.0, 0.75}})}, PerDistance(1));
  EXPECT_EQ(found[0].bars.at(0)[2], 0.125);
  EXPECT_TRUE(std::isnan(found[0].bars.at(1)[2])) << "another count";
  EXPECT_TRUE(std::isnan(found[0].bars.at(2)[2])) << "no row";
}

// One neighbour leaves a number as it is, another has none like it: that is no uncertainty of 0.
TEST(AddBars, AreUnknownWhereOneNeighbourMovesNothingAndAnotherHasNoRow) {
  std::vector<Finding> found{one({{"x", 4.0, 0.5}, {"x", 8.0, 0.5}, {"x", 9.0, 0.5}})};
  add_bars(found, {one({{"x", 4.0, 0.5}, {"x", 8.0, 0.5}, {"x", 9.0, 0.5}})}, PerDistance(1));
  EXPECT_EQ(found[0].bars.at(1)[2], 0) << "both have it, and the same";
  add_bars(found, {one({{"x", 4.0, 0.625}, {"x", 8.0, 0.5}})}, PerDistance(1));
  EXPECT_EQ(found[0].bars[0][2], 0.125);
  EXPECT_EQ(found[0].bars[1][2], 0) << "both have it, and the same";
  EXPECT_TRUE(std::isinf(found[0].bars[2][2])) << "no row";
}

TEST(AddBars, LargerOnesOfTheTableItselfStay) {
  std::vector<Finding> found{one({{"x", 4.0, 0.5}})};
  found[0].bars = {{nan, nan, 0.2}};
  add_bars(found, {one({{"x", 4.0, 0.6}})}, PerDistance(1));
  EXPECT_EQ(found[0].bars[0][2], 0.2);
}

TEST(Footings, AreStatedOfATableOrItIsNamed) {
  const auto named = [](const char* analysis, const char* name) { return table(analysis, name, "", "", {}); };
  EXPECT_EQ(footing_of(named("multiplets", "multiplets")).kind, "second route");
  for (const auto& [name, analysis] : analyses_of_tables()) {
    const Footing footing = footing_of(named(analysis.c_str(), name.c_str()));
    EXPECT_FALSE(footing.reference.empty() || footing.kind.empty() || footing.uncertainty.empty()) << name;
  }
  EXPECT_THROW(footing_of(named("multiplets", "surprise")), std::out_of_range);
  EXPECT_THROW(footing_of(named("budget", "multiplets")), std::out_of_range);
}

TEST(Footings, AreOfEveryAnalysisThatThereIs) {
  std::set<std::string> makers, analyses;
  for (const auto& [name, maker] : analyses_of_tables()) makers.insert(maker);
  for (const Analysis& analysis : analysis_catalogue()) analyses.insert(analysis.name);
  EXPECT_EQ(makers, analyses);
}

TEST(BarFits, TakeTheStandardErrorBesideThem) {
  Finding fits = table("a", "a", "A", "", {{"of", ""}, {"exponent", "-"}, {"standard error", "-"}});
  fits.rows = {{"x", 2.0, 0.125}, {"y", 1.0, nan}, {"z", 1.0, 0.25}};
  fits.bars = {{nan, nan, nan}, {nan, nan, nan}, {nan, 0.5, nan}};
  bar_fits(fits);
  EXPECT_EQ(fits.bars[0][1], 0.125);
  EXPECT_TRUE(std::isnan(fits.bars[1][1])) << "of two points there is none";
  EXPECT_EQ(fits.bars[2][1], 0.5) << "the larger of two";
  EXPECT_TRUE(std::isnan(fits.bars[0][2]));
  std::vector<Finding> other{one({{"x", 4.0, 0.5}})};
  bar_fits(other[0]);
  EXPECT_TRUE(other[0].bars.empty()) << "no fit";
}

}  // namespace
}  // namespace mb
