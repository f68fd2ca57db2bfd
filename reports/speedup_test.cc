#include "reports/speedup.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/synthetic.h"
#include "reports/verdict.h"
#include "reports/views.h"

namespace mb {
namespace {

using synthetic::full;
using synthetic::record;
using synthetic::reduced;
using synthetic::seconds;

void add(std::vector<Record>& records, const Contender& contender, double error, double bar, double time,
         double spread) {
  records.push_back(record("displacement-error", error, bar, contender));
  records.push_back(seconds("online-time", time, contender));
  records.back().error_bar = spread;
}

std::vector<Record> one_reduced(double error, double bar = 0) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), error, bar, 2.0, 0.5);
  return records;
}

SpeedUp only(const std::vector<Record>& records) {
  const auto all = speed_ups(records, "displacement-error");
  EXPECT_EQ(all.size(), 1u);
  return all.at(0);
}

std::vector<SpeedUp> at(double target, const std::vector<Record>& records) {
  return speed_ups_at(target, group_runs(records), "displacement-error");
}

TEST(SpeedUps, TakesTheCheapestRivalThatIsAsExact) {
  std::vector<Record> records = one_reduced(0.01);
  add(records, full(1, {1, 2}, 0.01), 0.02, 0, 1, 0);    // cheap, not exact enough
  add(records, full(2, {1, 2}, 0.01), 0.01, 0, 20, 1);   // as exact: a tie counts
  add(records, full(3, {1, 2}, 0.01), 0.001, 0, 50, 0);  // more exact, dearer
  const SpeedUp result = only(records);
  ASSERT_EQ(result.rival.size(), 2u);
  EXPECT_EQ(result.rival[0].contender.resolution.degree, 2);
  EXPECT_EQ(result.rival[1].metric, "online-time");
  EXPECT_DOUBLE_EQ(result.ratio, 10);
  EXPECT_DOUBLE_EQ(result.ratio_low, 19 / 2.5);
  EXPECT_DOUBLE_EQ(result.ratio_high, 21 / 1.5);
}

TEST(SpeedUps, OfTwoEquallyCheapRivalsTheMoreExact) {
  std::vector<Record> records = one_reduced(0.01);
  add(records, full(1, {1, 2}, 0.01), 0.009, 0, 20, 0);
  add(records, full(2, {1, 2}, 0.01), 0.002, 0, 20, 0);
  EXPECT_EQ(only(records).rival.at(0).contender.resolution.degree, 2);
}

TEST(SpeedUps, NoneReachedIsNoRatio) {
  std::vector<Record> records = one_reduced(0.01);
  add(records, full(1, {1, 2}, 0.01), 0.0100001, 0, 1, 0);
  const SpeedUp result = only(records);
  EXPECT_TRUE(result.rival.empty());
  EXPECT_EQ(result.ratio, 0);
}

TEST(SpeedUps, ErrorsBelowTheirBarCountAsTheBar) {
  std::vector<Record> records = one_reduced(1e-6, 1e-3);
  add(records, full(1, {1, 2}, 0.01), 8e-4, 1e-3, 4, 0);  // both count as 1e-3
  EXPECT_DOUBLE_EQ(only(records).ratio, 2);
  std::vector<Record> exact = one_reduced(1e-3);
  add(exact, full(1, {1, 2}, 0.01), 1e-6, 2e-3, 4, 0);  // counts as 2e-3: not reached
  EXPECT_TRUE(only(exact).rival.empty());
}

TEST(SpeedUps, FailedRecordsNeitherWinNorLose) {
  std::vector<Record> records = one_reduced(0.01);
  add(records, full(1, {1, 2}, 0.01), 0.001, 0, 1, 0);
  records[2].status = std::string("not_finite");
  EXPECT_TRUE(only(records).rival.empty());
  records[2].status = std::string("ok");
  records[3].status = std::string("failed: timer");
  EXPECT_TRUE(only(records).rival.empty());
  records[0].value = std::nan("");
  EXPECT_TRUE(speed_ups(records, "displacement-error").empty());
}

TEST(SpeedUps, ComparesOnlyLikeWithLike) {
  for (int variant = 0; variant < 4; ++variant) {
    std::vector<Record> records = one_reduced(0.01);
    add(records, full(1, {1, 2}, 0.01), 0.001, 0, 20, 0);
    if (variant == 0) records[2].truth = std::string("same_mesh");
    if (variant == 1) records[2].subject = std::string("another body");
    for (std::size_t i : {2, 3}) {
      if (variant == 2) records[i].case_name = std::string("another");
      if (variant == 3) records[i].profile = std::string("full");
    }
    EXPECT_TRUE(only(records).rival.empty()) << variant;
  }
}

TEST(SpeedUps, ASpreadAsLargeAsTheTimeLeavesTheRatioOpenAbove) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), 0.01, 0, 1, 1);
  add(records, full(1, {1, 2}, 0.01), 0.001, 0, 3, 5);
  EXPECT_TRUE(std::isinf(only(records).ratio_high));
  EXPECT_EQ(only(records).ratio_low, 0);
}

TEST(SpeedUps, ATimeWithoutSpreadLeavesTheRatioWithoutRange) {
  for (const std::size_t single : {1u, 3u}) {  // the time of the reduced run, that of its rival
    std::vector<Record> records = one_reduced(0.01);
    add(records, full(1, {1, 2}, 0.01), 0.001, 0, 20, 1);
    records[single].error_bar.reset();
    const SpeedUp result = only(records);
    EXPECT_DOUBLE_EQ(result.ratio, 10);
    EXPECT_TRUE(std::isnan(result.ratio_low) && std::isnan(result.ratio_high)) << single;
    EXPECT_EQ(ratio_cell(result).text, "10.0 (single run)");
  }
}

TEST(SpeedUps, TheNearMissIsTheMostExactOfThoseThatAreCheaperThanTheRival) {
  std::vector<Record> records = one_reduced(0.01);
  add(records, full(1, {1, 2}, 0.01), 0.5, 0, 1, 0);       // far off
  add(records, full(2, {1, 2}, 0.01), 0.012, 0, 8, 0);     // just misses
  add(records, full(2, {1, 2}, 0.005), 0.0025, 0, 20, 1);  // the rival
  add(records, full(3, {1, 2}, 0.01), 0.011, 0, 25, 0);    // misses by less, but is dearer than the rival
  const SpeedUp result = only(records);
  ASSERT_EQ(result.near_miss.size(), 2u);
  EXPECT_DOUBLE_EQ(result.near_miss[0].value, 0.012);
  EXPECT_EQ(result.near_miss[1].metric, "online-time");
  EXPECT_DOUBLE_EQ(result.miss_ratio, 4);
  EXPECT_DOUBLE_EQ(rival_margin(result), 4);
}

TEST(SpeedUps, WithoutACheaperContenderThereIsNoNearMiss) {
  std::vector<Record> records = one_reduced(0.01);
  add(records, full(2, {1, 2}, 0.01), 0.02, 0, 20, 0);  // misses, and costs as much as the rival
  add(records, full(3, {1, 2}, 0.01), 0.0, 0, 20, 0);
  EXPECT_TRUE(only(records).near_miss.empty());
  EXPECT_EQ(miss_ratio_cell(only(records)).text, "");
  EXPECT_TRUE(std::isinf(rival_margin(only(records))));
  EXPECT_EQ(margin_cell(only(records)).text, "unbounded");
  EXPECT_TRUE(only(one_reduced(0.01)).near_miss.empty());
  EXPECT_EQ(margin_cell(only(one_reduced(0.01))).text, "");
}

TEST(SpeedUps, HeadlineIsTheCheapestWithinTheTarget) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 4), 0.05, 0, 1, 0);
  add(records, reduced("eigenmodes", 8), 0.01, 0, 2, 0);
  add(records, reduced("eigenmodes", 16), 0.001, 0, 3, 0);
  add(records, full(1, {1, 2}, 0.01), 1e-4, 0, 30, 0);
  const auto best = at(0.01, records);
  ASSERT_EQ(best.size(), 1u);
  EXPECT_EQ(best[0].error.contender.settings.modes, 8);
  EXPECT_DOUBLE_EQ(median_ratio(best).value(), 15);
  EXPECT_TRUE(at(1e-9, records).empty());
  EXPECT_FALSE(median_ratio({}).has_value());
}

TEST(SpeedUps, TheHeadlineHoldsBothSidesToTheTargetAlone) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), 1e-5, 0, 2, 0);
  add(records, full(1, {1, 2}, 0.02), 0.03, 0, 1, 0);       // the most exact below the rival
  add(records, full(1, {1, 2}, 0.01), 0.009, 0.002, 6, 0);  // its bar leaves open whether it is within
  add(records, full(2, {1, 2}, 0.01), 0.007, 0.002, 10, 0);
  add(records, full(3, {1, 2}, 0.01), 1e-5, 0, 900, 0);  // as exact as the reduced run
  EXPECT_DOUBLE_EQ(only(records).ratio, 450);
  const SpeedUp one = at(0.01, records).at(0);
  EXPECT_DOUBLE_EQ(one.ratio, 5);
  EXPECT_EQ(one.rival.at(0).contender.resolution.degree, 2);
  EXPECT_DOUBLE_EQ(one.miss_ratio, 3);  // of the dearest of the cheaper, though not the most exact by its bar
  records[6].error_bar = 0.004;         // no longer sure to be within the target
  EXPECT_DOUBLE_EQ(at(0.01, records).at(0).ratio, 450);
  EXPECT_DOUBLE_EQ(at(0.01, records).at(0).miss_ratio, 5);
  records[8].value = 0.02;
  EXPECT_TRUE(at(0.01, records).at(0).rival.empty());
}

TEST(SpeedUps, AClosedFormReplacesTheFinerTruth) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), 0.004, 0.02, 2, 0);  // its bar leaves 1 % open
  add(records, full(2, {1, 2}, 0.01), 0.004, 0.02, 10, 0);
  EXPECT_TRUE(at(0.01, records).empty());
  EXPECT_DOUBLE_EQ(at(0.05, records).at(0).ratio, 5);
  for (const std::size_t i : {0u, 2u}) {
    Record exact = records.at(i);
    exact.truth = "exact";
    exact.error_bar = 0;
    records.push_back(exact);
  }
  EXPECT_DOUBLE_EQ(at(0.01, records).at(0).ratio, 5);
  EXPECT_EQ(at(0.05, records).at(0).error.truth, "exact");
}

TEST(SpeedUps, TheHeadlineStandsInATableOfPairs) {
  ReportInput input;
  add(input.records, reduced("eigenmodes", 8), 1e-5, 0, 2, 0.1);
  add(input.records, full(2, {1, 2}, 0.01), 0.007, 0.002, 10, 0.1);
  add(input.records, full(3, {1, 2}, 0.01), 1e-5, 0, 900, 1);
  const Sheet table = headline_table(evaluate(input));
  ASSERT_EQ(table.rows.size(), 2u);  // at 1 % and at 5 %
  EXPECT_EQ(table.rows[1][2].text, "5 %");
  std::vector<std::string> texts;
  for (const Cell& cell : table.rows[0]) texts.push_back(cell.text);
  EXPECT_EQ(texts[3], "eigenmodes, r = 8");
  EXPECT_EQ(texts[5], "Q2 1x2, newmark, step 0.01 s");
  EXPECT_EQ(texts[7], "5.00");
  EXPECT_EQ(texts[8], "4.71 to 5.32");
  EXPECT_EQ(texts[10], "rival at the edge of its sweep: largest time step");
  const std::string sentence = verdict_of(evaluate(input)).sentences.at(1);
  EXPECT_EQ(sentence.find("eigenmodes"), std::string::npos);  // pairs stand in the table alone
  EXPECT_NE(sentence.find("median 5.00, in 1 of 1 case with a reduced run"), std::string::npos) << sentence;
}

TEST(SpeedUps, TheFrontHoldsWhatNoOtherReducedRunBeats) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 4), 0.05, 0, 1, 0);
  add(records, reduced("eigenmodes", 8), 0.06, 0, 2, 0);   // dearer and less exact
  add(records, reduced("eigenmodes", 16), 0.05, 0, 3, 0);  // dearer, no more exact
  add(records, reduced("eigenmodes", 32), 0.01, 0, 4, 0);
  std::vector<int> kept;
  for (const SpeedUp& one : on_front(speed_ups(records, "displacement-error"))) {
    kept.push_back(one.error.contender.settings.modes);
  }
  EXPECT_EQ(kept, (std::vector<int>{4, 32}));
}

TEST(SpeedUps, TheIdentityBasisIsARival) {
  std::vector<Record> records = one_reduced(0.01);
  Contender identity = synthetic::stepped("full", 0, "symplectic-euler", 1e-3);
  add(records, identity, 0.005, 0, 6, 0);
  const SpeedUp result = only(records);
  ASSERT_EQ(result.rival.size(), 2u);
  EXPECT_EQ(result.rival[0].contender.integrator, "symplectic-euler");
}

TEST(SpeedUps, DifferencesBelowTheSpreadAreNoise) {
  std::vector<Record> records = one_reduced(0.01);  // 2 +- 0.5 s
  add(records, full(1, {1, 2}, 0.01), 0.001, 0, 2.4, 0.1);
  EXPECT_TRUE(is_within_noise(only(records)));
  EXPECT_EQ(ratio_cell(only(records)).text, "1.20 (0.920 to 1.67), within noise");
  records[3].value = 20;
  EXPECT_FALSE(is_within_noise(only(records)));
  records[3].error_bar.reset();
  EXPECT_FALSE(is_within_noise(only(records)));
  records[3].value = 2.2;
  EXPECT_TRUE(is_within_noise(only(records)));
  EXPECT_FALSE(is_within_noise(only(one_reduced(0.01))));  // no rival at all
}

TEST(BreakEven, IsWhereTheTwoCostsMeet) {
  const double T = break_even(10, 1, 2, 5).value();
  EXPECT_DOUBLE_EQ(10 + 1 * T, 2 + 5 * T);
  EXPECT_EQ(break_even(1, 1, 2, 5).value(), 0);  // ahead from the start
  EXPECT_FALSE(break_even(10, 5, 2, 5).has_value());
  EXPECT_FALSE(break_even(1, 6, 2, 5).has_value());
}

TEST(BreakEven, StandsInTheTableInSimulatedSeconds) {
  const Evaluation evaluation = evaluate(synthetic::input());
  const Sheet table = speed_up_table(evaluation, on_front(evaluation.speed_ups));
  const auto column = [&](const std::string& name) {
    for (std::size_t j = 0; j < table.columns.size(); ++j) {
      if (table.columns[j].name == name) return j;
    }
    throw std::out_of_range(name);
  };
  int n_known = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    if (row[column("rival")].text == "none reached") continue;
    const double rate = 1 / *row[column("real-time factor")].value;
    const double rival_rate = 1 / *row[column("rival real-time factor")].value;
    const Cell& cell = row[column("break-even")];
    EXPECT_EQ(cell.text == "never", rate >= rival_rate && !cell.value) << i;
    if (cell.value && *cell.value > 0) ++n_known;
  }
  EXPECT_GT(n_known, 0);
}

}  // namespace
}  // namespace mb
