#include "reports/findings.h"

#include <gmock/gmock.h>

#include <limits>

#include "reports/figures.h"
#include "reports/render.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Finding small() {
  Finding finding = synthetic::finding("shear", "step-limits", "limits", {{"scheme", ""}, {"dt", "s"}, {"n", ""}});
  finding.rows = {{"a|b", 1.25e-5, 3.0}, {"=cmd()", synthetic::nan, 4.0}, {"</script>", synthetic::unbounded, 5.0}};
  return finding;
}

TEST(Findings, NumbersCountsAndWhatIsNone) {
  const Sheet table = sheet_of(small());
  EXPECT_EQ(table.name, "shear-limits");
  EXPECT_EQ(table.columns[0].kind, Column::Kind::text);
  EXPECT_EQ(table.columns[1].kind, Column::Kind::number);
  EXPECT_EQ(table.rows[0][1].text, "1.250e-5");
  EXPECT_EQ(table.rows[1][1].text, "n/a");
  EXPECT_EQ(table.rows[2][1].text, "unbounded");
  EXPECT_FALSE(table.rows[2][1].value.has_value());
  EXPECT_EQ(table.rows[0][2].text, "3");
}

TEST(Findings, TextStaysTextInEveryFormat) {
  const Sheet table = sheet_of(small());
  EXPECT_THAT(markdown(table), HasSubstr("a\\|b"));
  EXPECT_THAT(csv(table), HasSubstr("'=cmd()"));
  EXPECT_THAT(csv(table), HasSubstr("1.25e-05"));
  EXPECT_THAT(latex(table), HasSubstr("\\textbar{}"));
}

TEST(Findings, BarsStandBesideTheirNumbersAndSayWhatTheyAreHeldTo) {
  Finding finding = small();
  finding.bars = {{synthetic::nan, 2e-7, synthetic::nan},
                  {synthetic::nan, synthetic::nan, synthetic::nan},
                  {synthetic::nan, synthetic::nan, synthetic::nan}};
  finding.footing = {"the formula", "closed form", "as the bars say"};
  const Sheet table = sheet_of(finding);
  EXPECT_EQ(table.columns[1].kind, Column::Kind::error);
  EXPECT_EQ(table.columns[2].kind, Column::Kind::number);
  EXPECT_EQ(table.rows[0][1].text, "1.25e-5 \u00b1 2e-7");
  EXPECT_EQ(table.rows[0][1].bar, 2e-7);
  EXPECT_EQ(table.rows[2][1].status, "unbounded");
  EXPECT_EQ(table.note, "Made up. Held to: the formula. Uncertainty: as the bars say.");
  EXPECT_THAT(csv(table), HasSubstr("1.25e-05,2e-07,"));
  EXPECT_THAT(csv(table), HasSubstr(",,unbounded,5"));
  finding.bars[0][1] = 1e-4;
  EXPECT_EQ(sheet_of(finding).rows[0][1].text, "<= 1.1e-4");
  finding.bars[0][1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sheet_of(finding).rows[0][1].text, "1.25e-5 \u00b1 unknown");
  EXPECT_THAT(csv(sheet_of(finding)), HasSubstr("1.25e-05,,bar unknown,"));
}

// 1 +- 6 is no count, nor is a force of 0 that may be 840 N.
TEST(Findings, WholeNumbersKeepTheirBars) {
  Finding finding;
  finding.name = "whole";
  finding.columns = {{"ratio", "-"}, {"force", "N"}, {"energy", "-"}, {"samples", ""}};
  finding.rows = {{1.0, 0.0, 1.0, 5.0}};
  finding.bars = {{6.0, 840.0, std::numeric_limits<double>::infinity(), synthetic::nan}};
  const auto row = sheet_of(finding).rows[0];
  EXPECT_EQ(row[0].text, "<= 7.0");
  EXPECT_EQ(row[0].bar, 6);
  EXPECT_EQ(row[1].text, "<= 840");
  EXPECT_EQ(row[2].status, "bar unknown");
  EXPECT_EQ(row[3].text, "5");
  finding.bars[0][0] = 0.08;
  EXPECT_EQ(sheet_of(finding).rows[0][0].text, "1.00 \u00b1 0.08");
}

TEST(Findings, RowsOfAnyLengthAreBroughtToTheColumns) {
  Finding finding = small();
  finding.rows.push_back({"short"});
  finding.rows.push_back({"long", 1.0, 2.0, 3.0});
  const Sheet table = sheet_of(finding);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), 3u);
  EXPECT_TRUE(std::isnan(number_at(finding, 3, "dt")));
  EXPECT_EQ(text_at(finding, 3, "no such column"), "");
}

TEST(Findings, GroupsComeInTheReportsOrder) {
  ReportInput input;
  for (const char* analysis :
       {"zebra", "probe-extremes", "damping", "budget", "frequencies", "mode-amplitudes", "aliasing", "step-limits"}) {
    input.findings.push_back(synthetic::finding("shear", analysis, analysis, {{"a", ""}}));
  }
  std::vector<std::string> order, headings;
  const Evaluation evaluation = evaluate(input);
  for (const FindingGroup& group : finding_groups(evaluation)) {
    order.push_back(group.analysis);
    headings.push_back(group.heading);
  }
  EXPECT_THAT(order, ::testing::ElementsAre("budget", "step-limits", "aliasing", "damping", "mode-amplitudes",
                                            "frequencies", "probe-extremes", "zebra"));
  EXPECT_THAT(headings, ::testing::IsSupersetOf({"Natural frequencies", "Findings: zebra"}));
  EXPECT_TRUE(stands_before_speed_up("aliasing"));
  EXPECT_FALSE(stands_before_speed_up("damping"));
}

TEST(Findings, OneCaseInTwoProfilesHasTwoFiles) {
  ReportInput input;
  input.findings = {small(), small()};
  input.findings[1].profile = "full";
  const Evaluation evaluation = evaluate(input);
  EXPECT_EQ(file_stem(evaluation, evaluation.input.findings[0]), "shear-limits-quick");
  EXPECT_EQ(file_stem(evaluation, evaluation.input.findings[1]), "shear-limits-full");
}

TEST(Findings, LongTablesAreShortenedAndSaySo) {
  const Sheet table = sheet_of(small());
  EXPECT_EQ(shortened(table, 3, "x").note, table.note);
  const Sheet part = shortened(table, 2, "data/x.csv");
  EXPECT_EQ(part.rows.size(), 2u);
  EXPECT_THAT(part.note, HasSubstr("first 2 of 3 rows; all in data/x.csv"));
}

TEST(Findings, HostileNamesMakeNoPaths) {
  Finding finding = small();
  finding.case_name = "../../etc";
  finding.name = "a/b\nc";
  EXPECT_THAT(sheet_of(finding).name, Not(HasSubstr("/")));
  EXPECT_THAT(sheet_of(finding).name, Not(HasSubstr(".")));
}

TEST(FindingFigures, AreDrawnOfTheColumnsTheyNeedAndElseNotAtAll) {
  std::set<std::string> names;
  for (const Finding& finding : synthetic::findings("shear")) {
    for (const Figure& figure : finding_figures(finding)) names.insert(figure.name);
  }
  for (const char* name :
       {"step-limits", "aliasing-24", "aliasing-120", "frequency-response-squeeze", "budget-M", "budget-K", "damping",
        "mode-amplitudes", "collision-cost-sphere-n-m", "contact-forces-superquadric-depth-0-01", "force-history",
        "contact-time", "stability-map-central-difference", "stability-map-newmark"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  for (Finding finding : synthetic::findings("shear")) {
    for (FindingColumn& column : finding.columns) column.name += "?";
    EXPECT_TRUE(finding_figures(finding).empty()) << finding.name;
  }
}

// Of what a limit does not exist no line is drawn.
TEST(FindingFigures, MapsOfContactDrawBothLimits) {
  constexpr double none = std::numeric_limits<double>::infinity();
  Finding map = synthetic::finding("drop", "contact-stability", "contact-stability",
                                   {{"integrator", ""},
                                    {"stiffness factor", "-"},
                                    {"dt", "s"},
                                    {"found", ""},
                                    {"limit", "s"},
                                    {"opening limit", "s"}});
  map.rows = {{"exact", 1.0, 1e-3, "stable", 2e-3, 1e-3}, {"newmark", 1.0, 1e-3, "unstable", none, 1e-3}};
  const std::vector<Figure> figures = finding_figures(map);
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].name, "contact-stability-exact");
  for (const Figure& figure : figures) {
    const Json& layers = figure.specification["layer"];
    ASSERT_EQ(layers.size(), 3u);
    EXPECT_EQ(layers[1]["encoding"]["x"]["field"], "limit");
    EXPECT_EQ(layers[2]["encoding"]["x"]["field"], "opening limit");
  }
  EXPECT_TRUE(figures[0].specification["data"]["values"][0].contains("limit"));
  EXPECT_FALSE(figures[1].specification["data"]["values"][0].contains("limit"));
  EXPECT_TRUE(figures[1].specification["data"]["values"][0].contains("opening limit"));
}

TEST(FindingFigures, TitlesTellThemApart) {
  for (const Finding& finding : synthetic::findings("shear")) {
    std::set<std::string> titles;
    const std::vector<Figure> figures = finding_figures(finding);
    if (finding.name != "stability-map") continue;
    for (const Figure& figure : figures) titles.insert(figure.specification["title"].get<std::string>());
    EXPECT_EQ(titles.size(), figures.size());
    EXPECT_TRUE(titles.contains("newmark: shear, profile " + finding.profile));
  }
}

TEST(FindingFigures, AxesHaveTheUnitsOfTheirColumns) {
  for (const Finding& finding : synthetic::findings("shear")) {
    if (finding.name != "mode-amplitudes" && finding.name != "damping") continue;
    const Json encoding = finding_figures(finding).at(0).specification["layer"][0]["encoding"];
    EXPECT_EQ(encoding["y"]["title"],
              finding.name == "damping" ? "damping ratio [-]" : "largest modal displacement [m kg^1/2]");
    EXPECT_EQ(encoding["x"]["title"], "frequency [Hz]");
  }
}

TEST(FindingFigures, ContactForcesAreALineAnAnswerOverTime) {
  const Finding force = synthetic::of_contact("shear").at(0);
  const Json specification = finding_figures(force).at(0).specification;
  const Json& encoding = specification["layer"][0]["encoding"];
  EXPECT_EQ(encoding["x"]["title"], "time [s]");
  EXPECT_EQ(encoding["y"]["title"], "normal force [N]");
  EXPECT_EQ(encoding["color"]["scale"]["domain"],
            Json({"truth, finer", "static-correction, r = 4", "static-correction, r = 64"}));
  const Json& data = specification["data"]["values"];
  ASSERT_EQ(data.size(), 3u * 61);  // the row without a number is left out
  EXPECT_EQ(data[0], Json({{"contender", "truth, finer"}, {"t", 0.3}, {"force", 0.0}}));
}

TEST(FindingFigures, SharesOfTheTimeInContactFillTheBarOfTheirRun) {
  const Finding time = synthetic::of_contact("shear").at(1);
  const Json specification = finding_figures(time).at(0).specification;
  EXPECT_EQ(specification["layer"][0]["encoding"]["x"]["title"], "share of the computing time [-]");
  EXPECT_EQ(specification["layer"][0]["encoding"]["color"]["scale"]["domain"].size(), 4u);
  std::map<std::string, double> sums;
  for (const Json& datum : specification["data"]["values"]) sums[datum["contender"]] += datum["share"].get<double>();
  ASSERT_EQ(sums.size(), 2u);
  for (const char* label : {"static-correction, r = 4\nstep 0.0001 s", "static-correction, r = 64\nstep 0.0001 s"}) {
    EXPECT_NEAR(sums.at(label), 1, 1e-15 * 8) << label;  // rounding of four quotients
  }
  Finding no_steps = time;
  no_steps.columns[2].name = "other";
  EXPECT_EQ(finding_figures(no_steps)[0].specification["data"]["values"][0]["contender"], "static-correction, r = 4");
}

TEST(FindingFigures, LabelsOfTheBudgetStandOnTwoLines) {
  const Json specification = finding_figures(synthetic::budget("shear"))[0].specification;
  EXPECT_EQ(specification["data"]["values"][0]["contender"],
            "static-correction, r = 4\ncentral-difference, step 0.001 s");
  EXPECT_THAT(to_line(specification), HasSubstr("split(datum.label, '\\\\n')"));
}

TEST(FindingFigures, LabelsOfTheBudgetNameBodiesWhereThereAreSeveral) {
  Finding both = synthetic::budget("shear", "ball");
  for (const auto& row : synthetic::budget("shear", "board").rows) both.rows.push_back(row);
  const Json data = finding_figures(both)[0].specification["data"]["values"];
  EXPECT_EQ(data[0]["contender"], "ball, static-correction, r = 4\ncentral-difference, step 0.001 s");
  EXPECT_EQ(data[23]["contender"], "board, static-correction, r = 256\ncentral-difference, step 0.001 s");
}

TEST(FindingFigures, TheBudgetLeavesOutTheTotalAndWhatIsNotMeasured) {
  const Json data = finding_figures(synthetic::budget("shear"))[0].specification["data"]["values"];
  EXPECT_EQ(data.size(), 12u);  // four contenders, three parts
  for (const Json& datum : data) EXPECT_NE(datum["part"], "total");
}

}  // namespace
}  // namespace mb
