#include "reports/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cases/scene/one_body.h"
#include "reports/verdict.h"
#include "reports/verification.h"

namespace mb {
namespace {

Check at_most(double bound) {
  Check check;
  check.method = "eigenmodes";
  check.metric = "displacement-error";
  check.truth = "same_mesh";
  check.modes = 8;
  check.at_most = bound;
  check.why = "Eight modes hold all that moves, but for a | pipe.";
  return check;
}

Scene scene(const std::string& name, const std::string& hard) {
  Scene one = one_body(Box{{1, 1, 1}}, {1e6, 0.3, 1000}, {2, {1, 1, 1}});
  one.name = name;
  one.profile = "quick";
  one.hard = hard;
  one.source = "Ours.";
  one.truth = {1e-5, {3, {1, 1, 1}}, {2, {1, 1, 1}}, ""};
  return one;
}

Record record(const std::string& name, double value, double bar, const std::string& status = "ok") {
  Record one;
  one.run = name + status;
  one.case_name = name;
  one.profile = "quick";
  one.contender = {
      "eigenmodes", "exact", {2, {1, 1, 1}}, {.modes = status == "ok" ? 8 : 16}};  // others answer no check
  one.modes_used = one.contender.settings.modes;
  one.metric = "displacement-error";
  one.truth = "same_mesh";
  one.value = value;
  one.unit = "-";
  one.error_bar = bar;
  one.status = status;
  return one;
}

ReportInput input(double measured, double bar) {
  ReportInput all;
  all.scenes = {scene("soft", ""), scene("hard", "It is hard. What must hold: everything.")};
  for (Scene& one : all.scenes) one.checks = {at_most(0.01)};
  all.records = {record("soft", 0.5, 0), record("hard", measured, bar), record("hard", 0, 0, "unstable"),
                 record("hard", 0, 0, "no_convergence")};
  return all;
}

std::string verdict(double measured, double bar) {
  const Sheet table = hard_cases_table(evaluate(input(measured, bar)));
  EXPECT_EQ(table.rows.size(), 1u);
  return table.rows.at(0).back().text;
}

TEST(HardCases, AreThoseThatSayWhatIsHardWithTheVerdictOfTheirChecks) {
  EXPECT_EQ(verdict(0.001, 1e-4), "holds");
  EXPECT_EQ(verdict(0.1, 1e-4), "fails");
  EXPECT_EQ(verdict(0.0099, 1e-3), "open");
  const Sheet table = hard_cases_table(evaluate(input(0.001, 1e-4)));
  EXPECT_EQ(table.rows[0][0].text, "hard");
  EXPECT_EQ(table.rows[0][3].text, "1 of 1");
  EXPECT_EQ(table.rows[0][4].text, "1") << "unstable";
  EXPECT_EQ(table.rows[0][5].text, "1") << "failed";
  EXPECT_EQ(table.rows[0][6].text, "0") << "warnings";
}

// They change no verdict, and are told beside it.
TEST(HardCases, WarningsStandBesideTheVerdict) {
  ReportInput warned = input(0.001, 1e-4);
  Record gain = record("hard", 1.45, 0);
  gain.metric = "energy-gain";
  warned.records.push_back(gain);
  const Evaluation evaluation = evaluate(warned);
  const Sheet table = hard_cases_table(evaluation);
  EXPECT_EQ(table.rows[0][6].text, "1");
  EXPECT_EQ(table.rows[0][7].text, "holds");
  const std::vector<std::string> sentences = verdict_of(evaluation).sentences;
  EXPECT_TRUE(std::ranges::any_of(
      sentences, [](const std::string& one) { return one.starts_with("1 warning in 1 case (hard), told there:"); }));
}

TEST(HardCases, SayWhichIntegratorsTheyWentThrough) {
  ReportInput all = input(0.001, 1e-4);
  Record rival = record("hard", 0.1, 0);
  rival.contender.method = "full-order";
  rival.contender.integrator = "newmark";
  all.records.push_back(rival);
  Finding map;
  map.name = "stability-map";
  map.case_name = "hard";
  map.profile = "quick";
  map.columns = {{"integrator", ""}, {"system", ""}, {"found", ""}};
  for (const char* found : {"stable", "unstable", "unstable"}) map.rows.push_back({"explicit-euler", "modes", found});
  all.findings = {map};
  const Sheet table = hard_integrators_table(evaluate(all));
  ASSERT_EQ(table.rows.size(), 2u);  // of the one hard case
  const auto text = [&](std::size_t row, const std::string& column) {
    const auto at = std::ranges::find(table.columns, column, &Column::name) - table.columns.begin();
    return table.rows[row].at(static_cast<std::size_t>(at)).text;
  };
  EXPECT_EQ(text(0, "system"), "full order");
  EXPECT_EQ(text(0, "newmark"), "1 run");
  EXPECT_EQ(text(0, "explicit-euler"), "none");
  EXPECT_EQ(text(1, "exact"), "3 runs, 1 unstable");
  EXPECT_EQ(text(1, "explicit-euler"), "map of 3 cells, 2 unstable");
  EXPECT_EQ(text(1, "sundials"), "none");
}

TEST(VerificationTable, NamesReferenceUncertaintyToleranceReasonAndResult) {
  const Sheet table = verification_table(evaluate(input(0.001, 1e-4)));
  ASSERT_EQ(table.rows.size(), 2u);
  const auto& row = table.rows[1];
  EXPECT_EQ(row[2].text, "eigenmodes r=8: displacement-error");
  EXPECT_NE(row[4].text.find("rtol 1e-05/100"), std::string::npos) << row[4].text;
  EXPECT_EQ(row[5].text, "second route");
  EXPECT_EQ(row[6].text, "1.0e-4");
  EXPECT_EQ(row[7].text, "<= 0.01");
  EXPECT_EQ(row[10].text, "holds");
  EXPECT_EQ(table.rows[0][10].text, "does not hold");
}

TEST(VerificationTable, DocumentIsMarkdownWhateverTheTexts) {
  ReportInput twice = input(0.001, 1e-4);
  twice.scenes.push_back(twice.scenes[0]);
  twice.scenes.back().profile = "full";
  const std::string text = verification_document(evaluate(twice));
  EXPECT_EQ(text.find("# Verification\n"), 0u);
  EXPECT_NE(text.find("\n1 of 3 checks hold.\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n| hard | 1 | 1 | eigenmodes r=8: displacement-error |"), std::string::npos) << text;
  EXPECT_NE(text.find("| Ours. |"), std::string::npos);
  EXPECT_NE(text.find("but for a \\| pipe"), std::string::npos);
}

}  // namespace
}  // namespace mb
