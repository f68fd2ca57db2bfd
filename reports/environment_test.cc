#include "reports/environment.h"

#include <gmock/gmock.h>

#include "reports/synthetic.h"
#include "reports/verdict.h"

namespace mb {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

std::vector<std::vector<std::string>> rows_of(const ReportInput& input) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : environment_table(evaluate(input)).rows) {
    rows.push_back({row[0].text, row[1].text, row[2].text});
  }
  return rows;
}

ReportInput of_two_machines() {
  ReportInput input;
  for (const int r : {1, 2, 4}) {
    input.records.push_back(synthetic::seconds("online-time", r, synthetic::reduced("eigenmodes", r)));
    input.records.back().provenance = {{"processor", r < 4 ? "one" : "two"},
                                       {"commit", r < 4 ? "abc" : "def"},
                                       {"date", "2026-11-0" + std::to_string(r) + "T00:00:00Z"},
                                       {"busy", "0.9" + std::to_string(r)},
                                       {"repeats", std::to_string(r)}};
  }
  input.environment = input.records.front().provenance;  // as the command gives it
  return input;
}

TEST(Environment, HasARowADistinctValue) {
  EXPECT_THAT(rows_of(of_two_machines()),
              ElementsAre(ElementsAre("commit", "abc", "2"), ElementsAre("commit", "def", "1"),
                          ElementsAre("date", "2026-11-01T00:00:00Z to 2026-11-04T00:00:00Z", "3"),
                          ElementsAre("processor", "one", "2"), ElementsAre("processor", "two", "1")));
}

TEST(Environment, SaysHowManyTimesAreNotCompared) {
  EXPECT_THAT(environment_table(evaluate(of_two_machines())).note, ::testing::StartsWith("1 time taken"));
  EXPECT_EQ(environment_table(evaluate(ReportInput{})).note, "");
}

TEST(Environment, WithoutRecordsIsWhatTheCallerGave) {
  ReportInput input;
  EXPECT_TRUE(rows_of(input).empty());
  input.environment = {{"processor", "one"}};
  EXPECT_THAT(rows_of(input), ElementsAre(ElementsAre("processor", "one", "")));
}

TEST(Environment, CommitsAreThoseOfRecordsAndTables) {
  ReportInput input = of_two_machines();
  Finding table;
  table.provenance["commit"] = "def";
  input.findings = {table};
  EXPECT_EQ(commits_of(evaluate(input)), "commits abc (2 records) and def (1 record, 1 table)");
  input.records.resize(2);
  input.findings.clear();
  EXPECT_EQ(commits_of(evaluate(input)), "commit abc");
  input.records.clear();
  EXPECT_EQ(commits_of(evaluate(input)), "commit abc");  // of the environment
  EXPECT_EQ(commits_of(evaluate(ReportInput{})), "");
}

TEST(Environment, CommandsNameTheCommitOfMostRecordsAndThatThereAreOthers) {
  EXPECT_THAT(reproducing_commands(evaluate(of_two_machines())), Contains("git checkout abc  # of 1 records another"));
  ReportInput input = of_two_machines();
  input.records.resize(2);
  EXPECT_THAT(reproducing_commands(evaluate(input)), Contains("git checkout abc"));
  for (Record& record : input.records) record.provenance["commit"] = "$(rm -rf)";
  for (const std::string& command : reproducing_commands(evaluate(input))) {
    EXPECT_THAT(command, ::testing::Not(::testing::HasSubstr("git checkout")));
  }
}

// What --set added to the runs of a case is not in its file: running it again does not repeat that.
TEST(Environment, CommandsSayWhichRunsTheyDoNotRepeat) {
  ReportInput input;
  Scene scene = synthetic::scene();
  scene.bodies.front().resolution = {4, {1, 4}};
  scene.study = {};
  scene.study.methods = {"eigenmodes"};
  scene.study.modes = {4, 8};
  scene.study.rivals = {{"newmark", {1, 2}, {{1, 2}}, {0.01}, {}}};
  scene.study.steppings = {{"newmark", {"eigenmodes"}, {8}, {0.01}, {}}};
  input.scenes = {scene};
  const auto stepped = [](double time_step) {
    Contender contender = synthetic::reduced("eigenmodes", 8);
    contender.integrator = std::string("newmark");
    contender.settings.time_step = time_step;
    return contender;
  };
  const auto add = [&](const Contender& contender) {
    input.records.push_back(synthetic::record("displacement-error", 0.1, 0, contender));
  };
  const std::string command = "modalbench run cylinder-compression --profile quick";
  for (const Contender& own : {synthetic::reduced("eigenmodes", 4), synthetic::full(2, {1, 2}, 0.01), stepped(0.01)})
    add(own);
  EXPECT_THAT(reproducing_commands(evaluate(input)), Contains(command));
  for (const Contender& other : {synthetic::reduced("eigenmodes", 5), synthetic::reduced("linear", 0),
                                 synthetic::full(2, {1, 4}, 0.01), synthetic::full(2, {1, 2}, 0.02), stepped(0.02)})
    add(other);
  EXPECT_THAT(reproducing_commands(evaluate(input)),
              Contains(::testing::StartsWith(command + "  # does not repeat 5 runs of settings")));
}

}  // namespace
}  // namespace mb
