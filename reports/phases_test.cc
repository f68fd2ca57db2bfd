#include <gtest/gtest.h>

#include "reports/synthetic.h"
#include "reports/views.h"

namespace mb {
namespace {

void add(std::vector<Record>& records, const Contender& contender, std::map<std::string, double> times) {
  records.push_back(synthetic::record("displacement-error", 5e-3, 0, contender));
  for (const auto& [metric, value] : times) records.push_back(synthetic::seconds(metric, value, contender));
}

Cell cell(const ReportInput& input, const std::string& column) {
  const Evaluation evaluation = evaluate(input);
  const Sheet table = phases_table(evaluation, evaluation.speed_ups);
  EXPECT_EQ(table.rows.size(), 1u);
  for (std::size_t j = 0; j < table.columns.size(); ++j) {
    EXPECT_EQ(table.rows.at(0).size(), table.columns.size());
    if (table.columns[j].name == column) return table.rows.at(0)[j];
  }
  throw std::out_of_range(column);
}

ReportInput measured_input() {
  ReportInput input;
  add(input.records, synthetic::reduced("eigenmodes", 8),
      {{"assembly-time", 3}, {"offline-time", 5}, {"stepping-time", 0.25}, {"online-time", 1}});
  add(input.records, synthetic::full(2, {1, 2}, 0.01), {{"offline-time", 4}, {"online-time", 20}});
  return input;
}

TEST(Phases, AreThePartsOfOfflineAndOnlineTime) {
  const ReportInput input = measured_input();
  EXPECT_DOUBLE_EQ(cell(input, "assembly").value.value(), 3);
  EXPECT_DOUBLE_EQ(cell(input, "preparation").value.value(), 2);
  EXPECT_DOUBLE_EQ(cell(input, "offline").value.value(), 5);
  EXPECT_DOUBLE_EQ(cell(input, "stepping").value.value(), 0.25);
  EXPECT_DOUBLE_EQ(cell(input, "reconstruction").value.value(), 0.75);
  EXPECT_DOUBLE_EQ(cell(input, "reconstruction").bar.value(), 0.03 * (0.25 + 1));  // the spreads of both
}

TEST(Phases, StandEmptyWhereTheyWereNotMeasured) {
  const ReportInput input = measured_input();
  for (const char* column : {"rival assembly", "rival preparation", "rival stepping", "rival reconstruction"}) {
    EXPECT_EQ(cell(input, column).text, "") << column;
  }
  EXPECT_DOUBLE_EQ(cell(input, "rival online").value.value(), 20);
}

TEST(Phases, AClosedFormTakesNoSteps) {
  ReportInput input = measured_input();
  for (Record& record : input.records) record.work.steps = 320;
  EXPECT_EQ(cell(input, "steps").text, "n/a");
  EXPECT_EQ(cell(input, "rival steps").text, "320");
  EXPECT_EQ(describe_integrator(synthetic::reduced("eigenmodes", 8)), "closed form");
  EXPECT_EQ(speed_up_table(evaluate(input), evaluate(input).speed_ups).rows.at(0).at(6).text, "closed form");
}

TEST(Phases, InContactTheStepsOfWhatFliesInClosedFormCount) {
  ReportInput input = measured_input();
  for (Record& record : input.records) {
    record.work.steps = 320;
    if (record.contender.method == "eigenmodes") record.contender.settings.time_step = 1e-4;
  }
  EXPECT_EQ(cell(input, "steps").text, "320");
  EXPECT_EQ(cell(input, "integrator").text, "closed form, steps in contact");
  EXPECT_EQ(cell(input, "steps of").text, "step 0.0001 s in contact");
  const Contender contender = input.records[0].contender;
  EXPECT_EQ(describe(contender), "eigenmodes, r = 8, step 0.0001 s in contact");
  EXPECT_EQ(describe_integrator(contender), "closed form, steps in contact");
  EXPECT_EQ(describe(synthetic::full(2, {1, 2}, 0.01)), "Q2 1x2, newmark, step 0.01 s");
}

// Of one case without a rival: its most exact run by the headline's norm, whatever the others say.
TEST(Phases, WithoutAnyRivalAreThoseOfTheMostExactRun) {
  ReportInput input;
  for (const int r : {4, 8, 16}) {
    add(input.records, synthetic::reduced("eigenmodes", r), {{"online-time", r}, {"stepping-time", 0.5 * r}});
    input.records[input.records.size() - 3].value = 0.1 / r;
    Record strain = synthetic::record("strain-error", 1e-6 * r, 0, synthetic::reduced("eigenmodes", r));
    input.records.push_back(strain);
  }
  add(input.records, synthetic::full(2, {1, 2}, 0.01), {{"online-time", 20}});
  input.records[input.records.size() - 2].value = 0.5;
  EXPECT_EQ(cell(input, "norm").text, "displacement-error");
  EXPECT_EQ(cell(input, "r").text, "16");
  EXPECT_DOUBLE_EQ(cell(input, "stepping").value.value(), 8);
  EXPECT_EQ(cell(input, "rival").text, "none reached");
  for (const char* column : {"rival online", "rival steps", "rival solves", "rival factorisations"}) {
    EXPECT_EQ(cell(input, column).text, "") << column;
  }
  input.records[input.records.size() - 2].value = 0.02;  // reaches r = 4 alone: its pair, and no run on its own
  EXPECT_EQ(cell(input, "r").text, "4");
  EXPECT_EQ(cell(input, "rival").text, "Q2 1x2, newmark, step 0.01 s");
}

TEST(Phases, WithoutARivalAreOfOneRunACase) {
  ReportInput input;
  for (const char* name : {"a", "b"}) {
    for (const int r : {4, 8}) {
      add(input.records, synthetic::reduced("eigenmodes", r), {{"online-time", 1}});
      for (std::size_t i = input.records.size() - 2; i < input.records.size(); ++i) input.records[i].case_name = name;
    }
  }
  const Evaluation evaluation = evaluate(input);
  EXPECT_EQ(phases_table(evaluation, evaluation.speed_ups).rows.size(), 2u);
  EXPECT_TRUE(phases_table(evaluation, {}).rows.empty());
}

TEST(Phases, BelowTheSpreadsOfBothMeasurementsPrintTheSpreads) {
  ReportInput input = measured_input();
  for (Record& record : input.records) {
    if (record.metric == "stepping-time") record.value = 1.01;  // more than the whole, by noise
  }
  EXPECT_EQ(cell(input, "reconstruction").text, "<= 0.048");
  for (Record& record : input.records) {
    if (record.metric == "stepping-time") record.status = "failed: timer";
  }
  EXPECT_EQ(cell(input, "reconstruction").text, "");
}

}  // namespace
}  // namespace mb
