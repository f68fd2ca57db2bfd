// What a speed-up may not claim: perturbed times, other machines, error bars, the edge of a sweep.
#include <gmock/gmock.h>

#include "reports/speedup.h"
#include "reports/synthetic.h"
#include "reports/verdict.h"

namespace mb {
namespace {

using synthetic::full;
using synthetic::reduced;
using ::testing::HasSubstr;
using ::testing::Not;

// The time of the contender is the last of the records.
void add(std::vector<Record>& records, const Contender& contender, double error, double time, double spread = 0,
         long n_unknowns = 0) {
  records.push_back(synthetic::record("displacement-error", error, 0, contender));
  records.push_back(synthetic::seconds("online-time", time, contender));
  records.back().error_bar = spread;
  for (std::size_t i = records.size() - 2; i < records.size(); ++i) records[i].n_unknowns = n_unknowns;
}

SpeedUp first(const std::vector<Record>& records) { return speed_ups(records, "displacement-error").at(0); }

std::vector<Record> a_pair(const std::string& busy, const std::string& rival_busy) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), 5e-3, 2, 0.1);
  records.back().provenance["busy"] = busy;
  add(records, full(2, {1, 2}, 0.01), 4e-3, 20, 1);
  records.back().provenance["busy"] = rival_busy;
  return records;
}

TEST(PerturbedTimes, WidenTheRangeByWhatElseHadTheCore) {
  const SpeedUp calm = first(a_pair("0.99", "1.000"));
  EXPECT_EQ(ratio_cell(calm).text, "10.0 (9.05 to 11.1)");
  EXPECT_FALSE(has_perturbed_time(calm));
  const SpeedUp own = first(a_pair("0.5", "1"));
  EXPECT_DOUBLE_EQ(own.ratio_low, calm.ratio_low);
  EXPECT_DOUBLE_EQ(own.ratio_high, 2 * calm.ratio_high);
  EXPECT_EQ(ratio_cell(own).text, "10.0 (9.05 to 22.1), perturbed");
  EXPECT_THAT(limits_of(own), ::testing::Contains("run perturbed (busy 0.50)"));
  const SpeedUp rivals = first(a_pair("1", "0.5"));
  EXPECT_DOUBLE_EQ(rivals.ratio_low, calm.ratio_low / 2);
  EXPECT_DOUBLE_EQ(rivals.ratio_high, calm.ratio_high);
  EXPECT_DOUBLE_EQ(least_ratio(rivals), calm.ratio_low / 2);
}

TEST(PerturbedTimes, WithoutASpreadHaveNoRangeAndMoreNoise) {
  std::vector<Record> records = a_pair("1", "0.5");
  records.back().value = 3.9;
  records.back().error_bar.reset();
  EXPECT_EQ(ratio_cell(first(records)).text, "1.95 (single run), within noise, perturbed");
  records.back().provenance["busy"] = "1";
  EXPECT_EQ(ratio_cell(first(records)).text, "1.95 (single run)");
}

TEST(PerturbedTimes, AreCountedInTheVerdictAndNamedInTheTable) {
  const auto limits = [](const ReportInput& input) {
    std::string text;
    for (const std::string& sentence : verdict_of(evaluate(input)).sentences) {
      if (sentence.starts_with("Limits")) text += sentence;
    }
    return text;
  };
  const auto input_of = [](std::vector<Record> records) {
    ReportInput input;
    input.records = std::move(records);
    return input;
  };
  EXPECT_THAT(limits(input_of(a_pair("0.8", "1"))), HasSubstr("1 rests on perturbed times"));
  EXPECT_THAT(limits(input_of(a_pair("1", "1"))), Not(HasSubstr("perturbed")));
  const Evaluation evaluation = evaluate(input_of(a_pair("0.8", "1")));
  const Sheet table = speed_up_table(evaluation, evaluation.speed_ups);
  EXPECT_EQ(table.columns.back().name, "limits");
  EXPECT_THAT(table.rows.at(0).back().text, HasSubstr("run perturbed (busy 0.80)"));
  const std::vector<Cell> row = contenders_table(evaluation).rows.at(0);
  EXPECT_EQ(row.at(row.size() - 4).text, "10.0, perturbed");  // before margin, miss speed-up and <= 1 %
}

TEST(OtherMachines, GiveNoRival) {
  std::vector<Record> records = a_pair("1", "1");
  add(records, full(1, {1, 2}, 0.01), 4e-3, 3);  // cheaper, on another machine
  records.back().provenance["processor"] = "faster";
  EXPECT_DOUBLE_EQ(first(records).ratio, 10);
  ReportInput input;
  input.records = records;
  EXPECT_THAT(verdict_of(evaluate(input)).sentences, ::testing::Contains(HasSubstr("1 time taken on another machine")));
}

TEST(ErrorTarget, IsReachedWhereErrorAndBarAreWithinIt) {
  std::vector<Record> records = a_pair("1", "1");
  records[0].error_bar = 5e-3;
  EXPECT_EQ(speed_ups_at(0.01, group_runs(records), "displacement-error").size(), 1u);
  records[0].error_bar = 6e-3;  // may be 1.1 %
  EXPECT_TRUE(speed_ups_at(0.01, group_runs(records), "displacement-error").empty());
  ReportInput input;
  input.records = records;
  const Evaluation evaluation = evaluate(input);
  EXPECT_THAT(verdict_of(evaluation).sentences, ::testing::Contains(HasSubstr("leaves open whether any reduced run is "
                                                                              "within the target in 1 case")));
  EXPECT_EQ(contenders_table(evaluation).rows.at(0).back().text, "open");
  EXPECT_EQ(contenders_table(evaluation).rows.at(1).back().text, "yes");
}

struct Rival {
  double time_step;
  long n_unknowns;
  const char* edge;
};

TEST(EdgeOfASweep, IsTheLargestStepOrTheCoarsestMeshThatWasRun) {
  for (const Rival& rival : {Rival{0.01, 200, ""}, Rival{0.02, 200, "largest time step"},
                             Rival{0.01, 100, "coarsest mesh"}, Rival{0.02, 100, "largest time step, coarsest mesh"}}) {
    std::vector<Record> records;
    add(records, reduced("eigenmodes", 8), 5e-3, 1);
    add(records, full(2, {1, 2}, rival.time_step), 5e-3, 2, 0, rival.n_unknowns);
    add(records, full(2, {1, 3}, 0.02), 5e-3, 3, 0, 300);
    add(records, full(1, {1, 1}, 0.005), 5e-3, 3, 0, 100);
    EXPECT_EQ(first(records).edge, rival.edge);
    EXPECT_EQ(stands_at_edge(first(records)), *rival.edge != 0);
  }
}

TEST(EdgeOfASweep, CountsWhatWasTriedAndFailedButNoOtherIntegrator) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), 5e-3, 1);
  add(records, full(2, {1, 2}, 0.01), 5e-3, 2);
  Contender sundials = full(2, {1, 2}, 0.04);
  sundials.integrator = "sundials";
  add(records, sundials, 0.5, 1);
  add(records, synthetic::stepped("eigenmodes", 4, "newmark", 0.04), 0.5, 1);  // reduced: no rival
  EXPECT_EQ(first(records).edge, "largest time step");
  ReportInput input;
  input.records = records;
  EXPECT_THAT(verdict_of(evaluate(input)).sentences, ::testing::Contains(HasSubstr("1 has its rival at the edge")));
  EXPECT_THAT(limits_of(first(records)), ::testing::Contains("rival at the edge of its sweep: largest time step"));
  add(records, full(2, {1, 2}, 0.02), 5e-3, 1);
  records[records.size() - 2].status = "unstable";
  EXPECT_EQ(first(records).edge, "");
}

TEST(EdgeOfASweep, OfAnAdaptiveIntegratorIsItsLargestTolerance) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), 5e-3, 1);
  Contender sundials = full(2, {1, 2}, 0);
  sundials.integrator = "sundials";
  sundials.settings.relative_tolerance = 1e-3;
  add(records, sundials, 5e-3, 2);
  EXPECT_EQ(first(records).edge, "largest tolerance");
  sundials.settings.relative_tolerance = 1e-2;
  add(records, sundials, 0.5, 1);
  EXPECT_EQ(first(records).edge, "");
}

TEST(NearMisses, AreNeighboursOfTheSweepAndNoBound) {
  const Evaluation evaluation = evaluate(synthetic::input());
  const std::string note = speed_up_table(evaluation, evaluation.speed_ups).note;
  EXPECT_THAT(note, HasSubstr("neighbours of this sweep"));
  EXPECT_THAT(note, HasSubstr("a finer or wider sweep may find less"));
}

TEST(Rivals, AreNamedByTheirMethodWhereTheyStepInAnotherBasis) {
  std::vector<Record> records;
  add(records, reduced("eigenmodes", 8), 5e-3, 1);
  add(records, synthetic::stepped("full", 0, "symplectic-euler", 1e-3), 5e-3, 2);
  ReportInput input;
  input.records = records;
  const auto label = [](const ReportInput& of) {
    const Evaluation evaluation = evaluate(of);
    const Sheet table = speed_up_table(evaluation, evaluation.speed_ups);
    for (std::size_t j = 0; j < table.columns.size(); ++j) {
      if (table.columns[j].name == "rival") return table.rows.at(0)[j].text;
    }
    return std::string();
  };
  EXPECT_EQ(label(input), "full Q4 1x4, step 0.001 s");
  add(input.records, full(2, {1, 2}, 0.01), 5e-3, 1.5);
  EXPECT_EQ(label(input), "Q2 1x2, step 0.01 s");
}

TEST(Verdict, OfRunsWithoutTimesClaimsNoSpeedUp) {
  ReportInput input = synthetic::input();
  EXPECT_TRUE(verdict_of(evaluate(input)).is_timed);
  std::erase_if(input.records, [](const Record& record) { return record.metric == "online-time"; });
  const Verdict verdict = verdict_of(evaluate(input));
  EXPECT_FALSE(verdict.is_timed);
  EXPECT_THAT(verdict.sentences, ::testing::Contains("No run was timed: there are no speed-ups."));
  EXPECT_THAT(verdict.sentences, ::testing::Not(::testing::Contains(::testing::HasSubstr("peed-up at"))));
}

}  // namespace
}  // namespace mb
