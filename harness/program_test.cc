// The program as its user meets it: commands, messages, exit codes. Suites *Cases carry the ctest label `cases`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/json/json.h"
#include "cases/json/record_json.h"
#include "harness/commands/commands.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
// Every wrong file of cases/bad: its messages on stderr, nothing on stdout, exit code 2.
TEST(BadInputCases, MessagesAndExitCode) {
  const fs::path folder = fs::path(MB_SOURCE_DIR) / "cases/bad";
  int n_files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const Said said = modalbench(folder, {"check", entry.path().filename()});
    EXPECT_EQ(said.code, 2) << entry.path();
    EXPECT_EQ(said.out, "") << entry.path();
    const std::string expected = text(fs::path(entry.path()).replace_extension(".expected"));
    EXPECT_FALSE(expected.empty()) << entry.path();
    EXPECT_THAT(said.err, ::testing::StartsWith(expected));
    ++n_files;
  }
  EXPECT_GE(n_files, 20);
}

TEST(ProgramCases, RunsResumesReportsAndChecks) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  const Said first = modalbench(scratch.path(), {"run", "small.toml"});
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("holds small"));
  EXPECT_THAT(first.err, HasSubstr("4 runs done, 0 found"));
  const Said second = modalbench(scratch.path(), {"run", "small.toml"});
  EXPECT_EQ(second.code, 0);
  EXPECT_EQ(second.out, first.out);
  EXPECT_THAT(second.err, HasSubstr("0 runs done, 4 found"));
  EXPECT_THAT(modalbench(scratch.path(), {"run", "small.toml", "--plan"}).out, HasSubstr("stored"));

  const RecordLines records = read_records(scratch / "results/results.jsonl");
  EXPECT_TRUE(records.refused.empty());
  int n_online = 0, n_marks = 0;
  for (const Record& r : records.records) {
    EXPECT_EQ(r.status, "ok") << r.metric;
    n_online += r.metric == "online-time";
    if (r.metric == "displacement-error") n_marks += r.error_bar.has_value();
  }
  EXPECT_EQ(n_online, 4);
  EXPECT_EQ(n_marks, 2 * 2 + 2 + 2);  // reduced and the truth's own mesh against both truths, rivals against `finer`

  written(scratch / "cases", "");  // a file where a folder is looked for
  const Said report = modalbench(scratch.path(), {"report"});
  EXPECT_EQ(report.code, 2);  // a report would say that there are no records
  EXPECT_THAT(report.err, HasSubstr("left out; name its case file"));
  EXPECT_THAT(report.err, HasSubstr("name the file: modalbench report small.toml"));
  EXPECT_FALSE(fs::exists(scratch / "report"));
  EXPECT_EQ(modalbench(scratch.path(), {"report", "small.toml", "-o", "by-file"}).code, 0);
  EXPECT_THAT(text(scratch / "by-file/report.md"), HasSubstr("1 of 1 check"));
  fs::remove(scratch / "cases");
  fs::create_directory(scratch / "cases");
  fs::copy(scratch / "small.toml", scratch / "cases/small.toml");
  EXPECT_EQ(modalbench(scratch.path(), {"report"}).code, 0);
  EXPECT_THAT(text(scratch / "report/report.md"), HasSubstr("1 of 1 check"));
}

// What a new user does first: every step that `new` names must succeed.
TEST(ProgramCases, TheTemplateRunsAndHolds) {
  const ScratchFolder scratch;
  EXPECT_THAT(modalbench(scratch.path(), {"new", "my.toml"}).err,
              HasSubstr("modalbench run my.toml, modalbench report my.toml"));
  EXPECT_EQ(modalbench(scratch.path(), {"check", "my.toml"}).code, 0);
  const Said run = modalbench(scratch.path(), {"run", "my.toml", "--quiet", "--untimed"});
  EXPECT_EQ(run.code, 0) << run.err << run.out;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, ::testing::StartsWith("holds my"));
  const Said report = modalbench(scratch.path(), {"report", "my.toml", "-q"});
  EXPECT_EQ(report.code, 0) << report.err;
  EXPECT_THAT(text(scratch / "report/report.md"), HasSubstr("1 of 1 check"));
}

// A check that asks for modes which --set left out is no failure, but not forgotten either.
TEST(ProgramCases, ChecksThatSettingsLeaveUnansweredAreCounted) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  const Said said = modalbench(scratch.path(), {"run", "small.toml", "--untimed", "--set", "modal.modes=4"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(said.out, "");
  EXPECT_THAT(said.err, HasSubstr("1 of 1 check not asked"));
}

TEST(ProgramCases, AFailingCheckIsExitCodeOne) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case("1e-9"));
  const Said said = modalbench(scratch.path(), {"run", "small.toml"});
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, HasSubstr("FAILS small"));
}

// As a file cut between two tables does.
TEST(ProgramCases, ACaseWithoutChecksSaysSo) {
  const ScratchFolder scratch;
  const std::string whole = small_case();
  written(scratch / "small.toml", whole.substr(0, whole.find("[[check]]")));
  const Said said = modalbench(scratch.path(), {"run", "small.toml"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("0 failed; it states no check"));
  EXPECT_THAT(modalbench(scratch.path(), {"check", "small.toml"}).out, HasSubstr("checks: 0"));
}

TEST(ProgramCases, ADamagedTruthIsNamedAndComputedAgain) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "small.toml"}).code, 0);
  for (const auto& truth : fs::directory_iterator(scratch / "results/truth")) fs::resize_file(truth, 1000);
  const Said idle = modalbench(scratch.path(), {"run", "small.toml"});
  EXPECT_EQ(idle.code, 0);
  EXPECT_THAT(idle.err, ::testing::ContainsRegex("truth/[0-9a-f]{32}.h5: .*computed again once it is needed"));
  const Said said = modalbench(scratch.path(), {"run", "small.toml", "--again"});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.err, ::testing::ContainsRegex("truth/[0-9a-f]{32}.h5: .*; computed again\n"));
  EXPECT_THAT(modalbench(scratch.path(), {"run", "small.toml"}).err, ::testing::Not(HasSubstr("computed again")));
}

// Sound files, of another case: nothing is said of them but by their shape.
TEST(ProgramCases, ATruthOfAnotherShapeIsNamedAndComputedAgain) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  const Said first = modalbench(scratch.path(), {"run", "small.toml"});
  const Store store(scratch / "results");
  for (const auto& truth : fs::directory_iterator(scratch / "results/truth")) {
    const std::string hash = truth.path().stem();
    Trajectory cut = store.read_truth(hash);
    cut.t.conservativeResize(5);
    for (BodyTrajectory& body : cut.bodies) {
      body.displacement.conservativeResize(Eigen::NoChange, 5);
      body.strain.conservativeResize(Eigen::NoChange, 5);
    }
    store.write_truth(hash, cut);
  }
  const Said said = modalbench(scratch.path(), {"run", "small.toml", "--again"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("of other times or points than the case asks for; computed again"));
  EXPECT_EQ(said.out, first.out);
}

TEST(ProgramCases, AStoreThatCannotBeWrittenIsFoundBeforeAnythingIsComputed) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  const Said said = modalbench(scratch.path(), {"run", "small.toml", "--store", "/proc/nope"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("/proc/nope"));
  EXPECT_THAT(said.err, ::testing::Not(HasSubstr("truth Q")));
}

TEST(ProgramCases, AFolderInTheWayOfAResultIsNamedBeforeAnythingIsComputed) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "small.toml"}).code, 0);
  for (const char* shelf : {"records", "truth"}) {
    const fs::path one = fs::directory_iterator(scratch / "results" / shelf)->path();
    fs::remove(one);
    fs::create_directory(one);
    const Said said = modalbench(scratch.path(), {"run", "small.toml", "--again"});
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr(one.filename().string() + ": a folder is in the way; remove it"));
    EXPECT_THAT(said.err, ::testing::Not(HasSubstr("[1/")));
    fs::remove(one);
  }
}

TEST(ProgramCases, ResampledLoadsRecordTheirError) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case("0.9", R"({ kind = "expression", formula = "sin(60*t)^2" })"));
  ASSERT_EQ(modalbench(scratch.path(), {"run", "small.toml"}).code, 0);
  int n_found = 0;
  for (const Record& r : read_records(scratch / "results/results.jsonl").records) {
    if (r.metric != "load-error") continue;
    EXPECT_GT(r.value, 0);
    EXPECT_LE(r.value, 1e-5);  // the default load tolerance
    ++n_found;
  }
  EXPECT_EQ(n_found, 2);
}

TEST(ProgramCases, AnInterruptedRunKeepsWhatIsFinished) {
  const ScratchFolder scratch;
  RunCommandOptions options;
  options.cases = {written(scratch / "small.toml", small_case())};
  options.store = scratch / "results";
  std::ostringstream out, err;
  options.interrupted = [&] { return err.str().find("[2/4]") != std::string::npos; };
  EXPECT_EQ(run_command(options, default_catalogue(), {out, err}), 130);
  EXPECT_THAT(err.str(), HasSubstr("2 runs done"));
  options.interrupted = nullptr;
  EXPECT_EQ(run_command(options, default_catalogue(), {out, err}), 0);
  EXPECT_THAT(err.str(), HasSubstr("2 runs done, 2 found"));
}

TEST(ProgramCases, ModesAsJson) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  const Said said = modalbench(scratch.path(), {"modes", "small.toml", "--count", "9", "--json"});
  ASSERT_EQ(said.code, 0) << said.err;
  const Json json = parse_json(said.out);
  EXPECT_EQ(json["case"], "small");
  EXPECT_EQ(json["body"], "body");
  EXPECT_EQ(json["n_dofs"], 375);
  ASSERT_EQ(json["modes"].size(), 9u);
  for (size_t i = 0; i < 9; ++i) {
    const Json& mode = json["modes"][i];
    EXPECT_EQ(mode["kind"], i < 6 ? "rigid" : "elastic");
    if (i < 6) {
      EXPECT_EQ(mode["omega"], 0.0);
    }
    EXPECT_LT(mode["residual"], 1e-8);
    const double bar = mode["bar_hertz"].get<double>(), hertz = mode["hertz"].get<double>();
    EXPECT_TRUE(i < 6 ? bar == 0 : bar > 1e-4 * hertz && bar < 0.5 * hertz) << bar << " of " << hertz;
    EXPECT_EQ(mode["participation"].size(), 3u);
    if (i < 6) {
      EXPECT_LE(mode["polynomial_degree"], 1);
    } else {
      EXPECT_EQ(mode["participation"], Json::array({0.0, 0.0, 0.0}));  // of a free body
    }
    EXPECT_NEAR(mode["hertz"].get<double>() * 2 * pi, mode["omega"].get<double>(), 1e-12 * mode["omega"].get<double>());
  }
}

TEST(ProgramCases, UsageErrorsAreExitCodeTwo) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  EXPECT_EQ(modalbench(scratch.path(), {}).code, 2);
  for (const std::vector<std::string>& words : {{"rnu"}, std::vector<std::string>{"rnu", "--help"}}) {
    const Said unknown = modalbench(scratch.path(), words);
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("no command 'rnu': did you mean 'run'?"));
  }
  EXPECT_EQ(modalbench(scratch.path(), {"run", "--profile", "quik"}).code, 2);
  EXPECT_EQ(modalbench(scratch.path(), {"run", "no-such-case"}).code, 2);
  EXPECT_EQ(modalbench(scratch.path(), {"run", "missing.toml"}).code, 2);
  EXPECT_EQ(modalbench(scratch.path(), {"modes", "small.toml", "--count", "0"}).code, 2);
  EXPECT_EQ(modalbench(scratch.path(), {"count", "small.toml"}).code, 2);  // has no contact
  const Said nowhere = modalbench(scratch.path(), {"run", "small.toml", "--store", ""});
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("names no folder"));
  for (const char* option : {"--store", "-o"}) {
    const Said moved = modalbench(scratch.path(), {"report", option, "a\x1b]0;b"});
    EXPECT_EQ(moved.code, 2) << option;
    EXPECT_THAT(moved.err, HasSubstr("cannot be shown: a?]0;b")) << option;
    EXPECT_EQ(moved.err.find('\x1b'), std::string::npos) << option;
  }
  const Said said = modalbench(scratch.path(), {"modes", "small.toml", "--body", "bdy"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("did you mean 'body'"));
  EXPECT_EQ(modalbench(scratch.path(), {"list", "xyz"}).code, 2);
  EXPECT_EQ(modalbench(scratch.path(), {"--help"}).code, 0);
  EXPECT_THAT(modalbench(scratch.path(), {"--help"}).out, ::testing::HasSubstr("--version"));
  EXPECT_THAT(modalbench(scratch.path(), {"--version"}).out,
              ::testing::MatchesRegex("modalbench [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(ProgramCases, AStoreThatCannotBeWrittenIsExitCodeTwo) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  written(scratch / "occupied", "a file");
  for (const char* jobs : {"1", "2"}) {
    const Said said = modalbench(scratch.path(), {"run", "small.toml", "--store", "occupied", "--jobs", jobs});
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr("occupied"));
  }
}

}  // namespace
}  // namespace mb
