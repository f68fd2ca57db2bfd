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

TEST(Phases, BelowTheSpreadsOfBothMeasurementsPrintTheSpreads) {
  ReportInput input = measured_input();
  for (Record& record : input.records) {
    if (record.metric == "stepping-time") record.value = 1.01;  // more than the whole, by noise
  }
  EXPECT_EQ(cell(input, "reconstruction").text, "<= 0.037");
  for (Record& record : input.records) {
    if (record.metric == "stepping-time") record.status = "failed: timer";
  }
  EXPECT_EQ(cell(input, "reconstruction").text, "");
}

}  // namespace
}  // namespace mb
