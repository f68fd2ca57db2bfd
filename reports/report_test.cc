#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "cases/json/record_json.h"
#include "reports/definitions.h"
#include "reports/figures.h"
#include "reports/synthetic.h"
#include "reports/verdict.h"

namespace mb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << path;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class WriteReport : public ::testing::Test {
 protected:
  void SetUp() override {
    directory_ = fs::path(::testing::TempDir()) /
                 (std::string("report-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + "-" +
                  std::to_string(getpid()));  // of two builds' tests at once each has its own
    fs::remove_all(directory_);
  }
  void TearDown() override { fs::remove_all(directory_); }
  fs::path directory_;
};

TEST_F(WriteReport, WritesEveryFileItNames) {
  const auto files = write_report(synthetic::input(), directory_);
  for (const fs::path& file : files) EXPECT_GT(fs::file_size(file), 0u) << file;
  for (const char* name :
       {"report.md", "data/results.jsonl", "data/records.csv", "data/speed-up.csv", "tables/checks.tex",
        "figures/work-against-precision-cylinder-compression-quick-finer-displacement-error.vl.json"}) {
    EXPECT_TRUE(fs::exists(directory_ / name)) << name;
  }
  for (const char* name :
       {"data/orders.csv", "tables/claims.tex", "data/matrix.csv", "data/phases.csv", "data/speed-up-all.csv",
        "data/cylinder-compression-step-limits.csv", "tables/cylinder-compression-aliasing.tex",
        "figures/speed-up.vl.json", "figures/budget-M-cylinder-compression-quick.vl.json",
        "figures/error-against-step-cylinder-compression-quick-finer-strain-error.vl.json"}) {
    EXPECT_TRUE(fs::exists(directory_ / name)) << name;
  }
  EXPECT_EQ(fs::exists(directory_ / "report.html"), page_available());
}

TEST_F(WriteReport, SectionsStandInTheReportsOrder) {
  write_report(synthetic::input(), directory_);
  const std::string text = read(directory_ / "report.md");
  std::size_t last = 0;
  for (const char* heading :
       {"## Verdict", "## Checks", "## Cases and contenders", "## Error against r", "## Observed orders",
        "## Error budget", "## Step limits", "## Temporal aliasing", "## Speed-up at equal error",
        "## Frequency response", "## Damping", "## Mode amplitudes", "## The paper's claims"}) {
    const std::size_t at = text.find(std::string("\n") + heading + "\n");
    ASSERT_NE(at, std::string::npos) << heading;
    EXPECT_GT(at, last) << heading;
    last = at;
  }
}

TEST_F(WriteReport, RecordsReadBack) {
  const auto records = synthetic::records();
  write_report(synthetic::input(), directory_);
  const RecordLines lines = read_records(directory_ / "data/results.jsonl");
  EXPECT_TRUE(lines.refused.empty()) << lines.refused[0].reason;
  ASSERT_EQ(lines.records.size(), records.size());
  EXPECT_EQ(lines.records[7].value, records[7].value);
  EXPECT_EQ(lines.records[7].metric, records[7].metric);
}

TEST_F(WriteReport, OpensWithTheVerdictAndNamesProfileTruthAndFailures) {
  write_report(synthetic::input(), directory_);
  const std::string text = read(directory_ / "report.md");
  EXPECT_LT(text.find("## Verdict"), text.find("## Checks"));
  EXPECT_THAT(text, HasSubstr("3 of 4 checks hold, 1 not decidable"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("truth \n")));  // checks on tables name none
  EXPECT_THAT(text, HasSubstr("case cylinder-compression, profile quick, truth finer"));
  EXPECT_THAT(text, HasSubstr("failed (not_finite)"));
  EXPECT_THAT(text, HasSubstr("none reached"));
  EXPECT_THAT(text, HasSubstr("break-even"));
  EXPECT_THAT(text, HasSubstr("modalbench run cylinder-compression --profile quick"));
  EXPECT_THAT(text, Not(::testing::ContainsRegex("[^a-z](nan|inf)[^a-z]")));
}

// A failure of several runs, one of a metric that has no meaning, and a number about the truth alone.
ReportInput troubled_input() {
  ReportInput input = synthetic::input();
  for (Record& record : input.records) {
    if (record.contender.resolution == Resolution{1, {1, 2}} && record.unit == "-") {
      record.status = "failed: point lies in no cell";
      record.value = std::numeric_limits<double>::quiet_NaN();
    }
  }
  Record undefined = synthetic::record("pose-rotation", std::nan(""), 0, synthetic::reduced("eigenmodes", 8));
  undefined.status = "undefined: the body is not free";
  Record of_truth = synthetic::record("truth-above-band", 7.5e-6, 0, synthetic::full(4, {2, 4}, 0));
  of_truth.error_bar.reset();
  of_truth.subject = "cylinder";
  input.records.push_back(undefined);
  input.records.push_back(of_truth);
  return input;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST_F(WriteReport, ListsAReasonOnceWithTheRunsItStruck) {
  write_report(troubled_input(), directory_);
  const std::string text = read(directory_ / "report.md");
  EXPECT_THAT(text,
              HasSubstr("6 runs failed. "));  // five of the new reason, one not finite; undefined and unstable are none
  EXPECT_THAT(text,
              HasSubstr("5 runs: point lies in no cell: Q1 1x2, newmark, 5 runs from step 0.02 s to step 0.00125"));
  EXPECT_EQ(count(text, "point lies in no cell"), 2u);  // verdict and table
  EXPECT_EQ(count(text, "undefined: the body is not free"), 1u);
  EXPECT_EQ(count(text, "mesh Q4 1x4, 4000 degrees of freedom"), 1u);
}

TEST_F(WriteReport, TruthsAreNoContenders) {
  write_report(troubled_input(), directory_);
  EXPECT_THAT(read(directory_ / "report.md"),
              HasSubstr("Of the truth finer: share of kinetic energy above 30 Hz: 7.50e-6 (cylinder)."));
  for (const char* name : {"data/full-order.csv", "data/error-against-modes.csv"}) {
    EXPECT_THAT(read(directory_ / name), Not(HasSubstr("truth-above-band"))) << name;
    EXPECT_THAT(read(directory_ / name), Not(HasSubstr("Q4 2x4"))) << name;
  }
  EXPECT_THAT(read(directory_ / "data/records.csv"), HasSubstr("truth-above-band"));
  const Evaluation evaluation = evaluate(troubled_input());
  for (const Figure& figure : figures(evaluation)) EXPECT_THAT(figure.name, Not(HasSubstr("truth-above-band")));
  for (const Quantity& quantity : quantities(evaluation)) EXPECT_NE(quantity.metric, "truth-above-band");
}

TEST(Cases, AreDescribedInOneLine) {
  ReportInput input = synthetic::input();
  EXPECT_EQ(case_line(evaluate(input), input.scenes[0]),
            "cylinder: cylinder of radius 0.05 m and length 0.2 m; E = 50000 Pa, nu = 0.45, rho = 1000 kg/m^3; free; "
            "undamped; mesh Q4 1x4, 4000 degrees of freedom. No loads.");
  Scene& scene = input.scenes[0];
  Body& body = scene.bodies[0];
  body.supports = {{Support::Kind::sliding, {"z-min", std::nullopt}},
                   {Support::Kind::sliding, {"z-max", std::nullopt}}};
  body.damping = {.alpha = 0.5, .beta = 1e-4};
  body.damping_ratios = {0.01, 0.02};
  body.resolution = {3, {2, 2}};  // no record of it
  scene.loads = {{"push", Pulse{0.01}, {{"cylinder", {"z-max", Disc{{0, 0, 0.1}, 0.02}}, {0, 0, -30}}}},
                 {"blow", Harmonic{12}, {{"cylinder", {"side", std::nullopt}, {0, 0, 0}, 5}}}};
  EXPECT_THAT(
      case_line(evaluate(input), scene),
      HasSubstr("sliding at z-min, z-max; damping alpha = 0.5 1/s, beta = 0.0001 s, ratio 0.01 to 0.02 of the first 2 "
                "elastic modes; mesh Q3 2x2. Loads: push (pulse of 0.01 s): 30 Pa on z-max (disc of radius "
                "0.02 m); blow (harmonic of 12 rad/s): pressure 5 Pa on side."));
}

TEST(Checks, HaveABarEachAndTheDigitsThatTellThemFromTheirBound) {
  ReportInput input = synthetic::input();
  const auto row = [&](double value, double bar) {
    input.records = {synthetic::record("displacement-error", value, bar, synthetic::reduced("eigenmodes", 32))};
    input.scenes[0].checks = {input.scenes[0].checks[0]};  // at most 0.02
    input.scenes[0].checks[0].method = "eigenmodes";
    const Sheet table = checks_table(evaluate(input));
    EXPECT_EQ(table.columns.at(6).name, "error bar");
    EXPECT_THAT(split(table).at(0).note, Not(HasSubstr("largest")));
    return std::pair(table.rows.at(0).at(5).text, table.rows.at(0).at(6).text);
  };
  EXPECT_EQ(row(0.0200000123, 0), std::pair(std::string("0.02000001"), std::string()));
  EXPECT_EQ(row(0.0123456, 3e-4), std::pair(std::string("0.0123"), std::string("3.0e-4")));
}

TEST(Probes, StandInTableAndFiguresWithTheirVonMisesError) {
  ReportInput input;
  input.records = {synthetic::record("probe-von-mises", 0.03, 0, synthetic::reduced("eigenmodes", 8))};
  input.records[0].subject = "end";
  const Evaluation evaluation = evaluate(input);
  const Sheet table = probes_table(evaluation);
  const auto column = std::ranges::find(table.columns, "von Mises error", &Column::name);
  ASSERT_NE(column, table.columns.end());
  EXPECT_EQ(table.rows.at(0)[static_cast<std::size_t>(column - table.columns.begin())].text, "0.0300");
  ASSERT_EQ(figures(evaluation).size(), 1u);
  EXPECT_THAT(figures(evaluation)[0].name, HasSubstr("probe-von-mises"));
  EXPECT_EQ(title(quantities(evaluation).at(0)), "relative von Mises error of the probe, end");
}

TEST(Verdict, SaysNoMoreOfUnstableRunsThanIsKnown) {
  EXPECT_THAT(verdict_of(evaluate(synthetic::input())).sentences,
              ::testing::Contains("1 run is unstable: its step is beyond the limit."));
}

TEST(Definitions, StandOnceAndTimesComeFromTheirMetrics) {
  ReportInput input = synthetic::input();
  input.metric_docs["offline-time"] = "as measured";
  std::set<std::string> terms;
  for (const Explanation& one : definitions(evaluate(input))) {
    EXPECT_TRUE(terms.insert(one.term).second) << one.term;
    EXPECT_FALSE(one.text.empty()) << one.term;
    EXPECT_NE(one.term, "offline time");
    EXPECT_NE(one.term, "online time");
  }
  for (const char* term : {"offline-time", "error bar", "r", "speed-up at 1 % error", "speed-up at equal error",
                           "margin", "near miss", "break-even", "check", "mesh", "truth exact", "closed form"}) {
    EXPECT_TRUE(terms.contains(term)) << term;
  }
}

TEST_F(WriteReport, WithoutRecordsItSaysSo) {
  write_report({}, directory_);
  EXPECT_THAT(read(directory_ / "report.md"), HasSubstr("There are no records"));
  EXPECT_THAT(read(directory_ / "report.md"), HasSubstr("No case in this report states a check"));
  write_report({.records = {}, .findings = {}, .scenes = {synthetic::scene()}, .environment = {}, .metric_docs = {}},
               directory_);
  EXPECT_THAT(read(directory_ / "report.md"), HasSubstr("4 not measured"));
}

TEST_F(WriteReport, HostileNamesStayText) {
  ReportInput input = synthetic::input();
  const std::string script = "<script>alert(1)</script>";
  for (Record& record : input.records) {
    record.case_name = script;
    if (record.contender.method == "eigenmodes") record.contender.method = std::string("=cmd|'/c calc'!A1");
    if (!record.subject.empty()) record.subject = std::string("../../x\\input{y}");
  }
  input.scenes[0].title = script;
  input.environment["commit"] = "`rm -rf`\n# heading";
  for (Finding& finding : input.findings) {
    finding.case_name = script;
    finding.title = finding.note = script;
    if (finding.name == "damping") finding.name = std::string("../../y\\input{z}");
    finding.columns[0].name = script;
    finding.rows[0][0] = std::string("=cmd|'/c calc'!A1");
  }
  for (const fs::path& file : write_report(input, directory_)) {
    EXPECT_EQ(fs::relative(file, directory_).string().find(".."), std::string::npos) << file;
    const std::string text = read(file);
    if (file.extension() == ".csv") {
      EXPECT_THAT(text, Not(HasSubstr(",=cmd"))) << file;
    }
    if (file.extension() == ".md") {
      EXPECT_THAT(text, Not(::testing::ContainsRegex("[^\\]<script>"))) << file;
    }
    if (file.extension() == ".md") {
      EXPECT_THAT(text, Not(HasSubstr("\n# heading"))) << file;
      EXPECT_THAT(text, Not(HasSubstr("git checkout"))) << file;
    }
    if (file.extension() == ".tex") {
      EXPECT_THAT(text, Not(HasSubstr("\\input"))) << file;
    }
    if (file.extension() == ".html") {
      EXPECT_THAT(text, Not(HasSubstr("<script>alert"))) << file;
    }
  }
}

TEST_F(WriteReport, AnUnwritableDirectoryIsAnError) {
  fs::create_directories(directory_);
  std::ofstream(directory_ / "data") << "a file where a folder must be";  // holds for root too, unlike permissions
  EXPECT_THROW(write_report(synthetic::input(), directory_), std::runtime_error);
  EXPECT_THROW(write_report(synthetic::input(), "/proc/no-such-place"), std::runtime_error);
  EXPECT_THROW(write_report(synthetic::input(), "/dev/null"), std::runtime_error);
}

TEST(Figures, HoldOneDatumARunAndNoFailedOnes) {
  const auto all = figures(evaluate(synthetic::input()));
  ASSERT_FALSE(all.empty());
  for (const Figure& figure : all) {
    for (const Json& datum : figure.specification["data"]["values"]) {
      EXPECT_TRUE(datum["value"].is_number()) << figure.name;
      EXPECT_TRUE(datum.contains("series"));
    }
  }
}

TEST(Figures, TimesAreASimulatedSecondsWhereTheSceneIsKnown) {
  ReportInput input = synthetic::input();
  const Evaluation known = evaluate(input);
  input.scenes.clear();
  const Evaluation unknown = evaluate(input);
  EXPECT_TRUE(time_axis(known).per_simulated_second);
  EXPECT_FALSE(time_axis(unknown).per_simulated_second);
  const double a = run_data(known)[0]["time"], b = run_data(unknown)[0]["time"];
  EXPECT_NEAR(a * synthetic::scene().duration, b, 1e-15 * b * 8);  // one division and one product
}

}  // namespace
}  // namespace mb
