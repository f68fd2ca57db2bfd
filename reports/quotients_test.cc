// What is left of quotients of uncertain numbers: both ends, and what a table says where there are none.
#include <gtest/gtest.h>

#include <cmath>

#include "reports/render.h"
#include "reports/speedup.h"
#include "reports/synthetic.h"
#include "reports/views.h"

namespace mb {
namespace {

using synthetic::full;
using synthetic::reduced;

Record seconds(double value, double spread) {
  Record time = synthetic::seconds("online-time", value, reduced("eigenmodes", 8));
  time.error_bar = spread;
  return time;
}

Record single(double value) {
  Record time = seconds(value, 0);
  time.error_bar.reset();
  return time;
}

SpeedUp graded(double own, double own_bar, double rivals, double rivals_bar) {
  SpeedUp one{
      .error = synthetic::record("displacement-error", own, own_bar, reduced("eigenmodes", 8)),
      .time = seconds(2, 0.5),
      .rival = {synthetic::record("displacement-error", rivals, rivals_bar, full(2, {1, 2}, 0.01)), seconds(20, 1)},
      .near_miss = {synthetic::record("displacement-error", 2 * own, own_bar, full(1, {1, 2}, 0.01)), seconds(10, 2)}};
  one.ratio = 10, one.ratio_low = 19 / 2.5, one.ratio_high = 21 / 1.5, one.miss_ratio = 5;
  return one;
}

TEST(Quotients, OfTimesReachFromTheEndsOfEither) {
  const Range ratio = ratio_range(seconds(2, 0.5), seconds(20, 1));
  EXPECT_DOUBLE_EQ(ratio.low, 19 / 2.5);
  EXPECT_DOUBLE_EQ(ratio.high, 21 / 1.5);
  EXPECT_TRUE(std::isinf(ratio_range(seconds(1, 2), seconds(20, 1)).high));
  for (const Range& none : {ratio_range(single(2), seconds(20, 1)), ratio_range(seconds(2, 1), single(20))}) {
    EXPECT_TRUE(std::isnan(none.low));
    EXPECT_TRUE(std::isnan(none.high));
  }
  const Range real_time = real_time_range(seconds(2, 0.5), 10);
  EXPECT_DOUBLE_EQ(real_time.low, 4);
  EXPECT_DOUBLE_EQ(real_time.high, 10 / 1.5);
  EXPECT_TRUE(std::isnan(real_time_range(single(2), 10).high));
}

TEST(Quotients, OfErrorsReachFromTheEndsOfTheirBars) {
  const Range margin = margin_range(graded(0.01, 0.002, 0.005, 0.001));
  EXPECT_DOUBLE_EQ(margin.low, 0.008 / 0.006);
  EXPECT_DOUBLE_EQ(margin.high, 0.012 / 0.004);
  const Range below = margin_range(graded(0.01, 0.02, 0.005, 0.01));  // both may be exact
  EXPECT_EQ(below.low, 0);
  EXPECT_TRUE(std::isinf(below.high));
  EXPECT_EQ(margin_range(graded(0, 0, 0, 0)).low, 1);
}

TEST(Quotients, OfCostsHaveEndsWhereEveryTimeHasASpread) {
  const Costs own{seconds(10, 1), seconds(1, 0.5)}, rival{seconds(2, 0.5), seconds(5, 1)};
  const Range range = break_even_range(own, rival, 1);
  EXPECT_DOUBLE_EQ(range.low, (9 - 2.5) / (6 - 0.5));
  EXPECT_DOUBLE_EQ(range.high, (11 - 1.5) / (4 - 1.5));
  EXPECT_LT(range.low, break_even(10, 1, 2, 5).value());
  EXPECT_GT(range.high, break_even(10, 1, 2, 5).value());
  EXPECT_TRUE(std::isinf(break_even_range(own, {rival.offline, seconds(2, 1)}, 1).high));  // it may never happen
  EXPECT_TRUE(std::isnan(break_even_range({single(10), own.online}, rival, 1).low));
}

TEST(Quotients, StandWithTheirRange) {
  const SpeedUp one = graded(0.01, 0.002, 0.005, 0.001);
  EXPECT_EQ(margin_cell(one).text, "2.00 (1.33 to 3.00)");
  EXPECT_EQ(miss_ratio_cell(one).text, "5.00 (3.20 to 8.00)");
  EXPECT_EQ(margin_cell(graded(0.01, 0.01, 0.005, 0.01)).text, "1.00 (0 to unbounded)");
  SpeedUp once = one;
  once.near_miss[1] = single(10);
  EXPECT_EQ(miss_ratio_cell(once).text, "5.00 (single run)");
}

// A reader of the file has both ends as numbers of their own, and nothing where there are none.
TEST(Quotients, HaveColumnsForBothEndsInCsv) {
  const Sheet table{.name = "t",
                    .title = "",
                    .note = "",
                    .columns = {{"margin", "-", Column::Kind::quotient}},
                    .rows = {{quotient_cell(2, 1.5, 3)},
                             {quotient_cell(2, 0, INFINITY)},
                             {quotient_cell(2, NAN, NAN)},
                             {text_cell("never")}}};
  EXPECT_EQ(csv(table), "margin [-],margin low,margin high\n2,1.5,3\n2,0,\n2,,\nnever,,\n");
}

// The table has no number without an uncertainty: errors, times and quotients alike.
TEST(Quotients, LeaveNoNumberOfTheTableWithoutAnUncertainty) {
  const Evaluation evaluation = evaluate(synthetic::input());
  const Sheet table = speed_up_table(evaluation, evaluation.speed_ups);
  int n_quotients = 0;
  for (const Column& column : table.columns) {
    EXPECT_TRUE(column.kind != Column::Kind::number || column.name == "r") << column.name;
    n_quotients += column.kind == Column::Kind::quotient;
  }
  EXPECT_EQ(n_quotients, 6);
}

}  // namespace
}  // namespace mb
