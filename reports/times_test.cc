#include "reports/times.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/runs.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

Record time_of(double value, double spread, const std::string& busy) {
  Record time = synthetic::seconds("online-time", value, synthetic::reduced("eigenmodes", 8));
  time.error_bar = spread;
  if (!busy.empty()) time.provenance["busy"] = busy;
  return time;
}

TEST(Times, AreThoseThatNoTruthGrades) {
  EXPECT_TRUE(is_time(time_of(1, 0, "")));
  Record mark = time_of(1, 0, "");
  mark.truth = "finer";  // the time of first touch, say
  EXPECT_FALSE(is_time(mark));
  EXPECT_FALSE(is_time(synthetic::record("displacement-error", 1, 0, {})));
}

TEST(Times, ArePerturbedBelowNineTenthsOfTheCore) {
  EXPECT_TRUE(is_perturbed(time_of(1, 0, "0.899")));
  EXPECT_DOUBLE_EQ(busy_share(time_of(1, 0, "0.5")), 0.5);
  for (const char* busy : {"", "0.9", "0.95", "1.000", "1.2", "0", "-0.5", "nan", "x", "0.5x"}) {
    EXPECT_FALSE(is_perturbed(time_of(1, 0, busy))) << busy;
    EXPECT_EQ(busy_share(time_of(1, 0, busy)), 1) << busy;
  }
}

TEST(Times, RangeDownToTheShareThatTheyHad) {
  const TimeRange calm = range_of(time_of(2, 0.1, "0.99")), perturbed = range_of(time_of(2, 0.1, "0.5"));
  EXPECT_DOUBLE_EQ(calm.low, 1.9);
  EXPECT_DOUBLE_EQ(perturbed.low, 0.95);
  EXPECT_DOUBLE_EQ(perturbed.high, 2.1);
  EXPECT_EQ(range_of(time_of(2, 3, "")).low, 0);
  Record single = time_of(2, 0, "0.5");
  single.error_bar.reset();
  EXPECT_TRUE(std::isnan(range_of(single).low) && std::isnan(range_of(single).high));
}

// Three times of a case on one machine, one on another that differs in one key.
std::vector<Record> of_two_machines(const std::string& key) {
  std::vector<Record> records;
  for (const int r : {1, 2, 4, 8}) {
    records.push_back(synthetic::record("displacement-error", 0.1 / r, 0, synthetic::reduced("eigenmodes", r)));
    records.push_back(synthetic::seconds("online-time", r, synthetic::reduced("eigenmodes", r)));
    records.back().provenance = {{"processor", "P"}, {"blas", "B"}, {"threads", "1"}, {"commit", std::to_string(r)}};
  }
  records.back().provenance[key] = "another";
  return records;
}

TEST(Times, OfTheMachineThatTookMostOfACaseAreCompared) {
  for (const char* key : {"processor", "blas", "threads"}) {
    const std::vector<Record> records = of_two_machines(key);
    EXPECT_EQ(machines_compared(records).at({"cylinder-compression", "quick"}), (Machine{"P", "B", "1"})) << key;
    EXPECT_EQ(count_times_left_out(records), 1) << key;
    const auto runs = group_runs(records);
    ASSERT_EQ(runs.size(), 4u);
    for (const auto& run : runs) {
      EXPECT_EQ(run.online.has_value(), run.contender.settings.modes < 8) << key;
      EXPECT_EQ(run.measures.size(), 1u) << key;  // errors are the same anywhere
    }
  }
  EXPECT_EQ(count_times_left_out(of_two_machines("commit")), 0);
  EXPECT_EQ(count_times_left_out({}), 0);
}

TEST(Times, EveryCaseHasItsOwnMachine) {
  std::vector<Record> records = of_two_machines("commit");
  for (Record record : of_two_machines("commit")) {
    record.case_name = "shear";
    if (is_time(record)) record.provenance["processor"] = "Q";
    records.push_back(record);
  }
  EXPECT_EQ(count_times_left_out(records), 0);
}

}  // namespace
}  // namespace mb
