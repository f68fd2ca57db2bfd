// What fails is told every time, and takes nothing else with it.
#include <gmock/gmock.h>

#include "cases/json/record_json.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "harness/study/catalogue_test.h"
#include "harness/study/identity.h"
#include "harness/study/stored.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}
std::string with_a_broken_method() {
  return replaced(small_case(), R"(methods = ["static-correction"])", R"(methods = ["static-correction", "breaks"])");
}
std::vector<Record> records_in(const ScratchFolder& scratch) {
  return read_records(scratch / "results/results.jsonl").records;
}

TEST(FailureCases, AContenderThatThrowsIsExitCodeThreeEveryTime) {
  const ScratchFolder scratch;
  const Catalogue catalogue = with_a_method_that_breaks();
  written(scratch / "case.toml", with_a_broken_method());
  for (const char* count : {"5 runs done, 0 found", "0 runs done, 5 found"}) {
    const Said said = modalbench(scratch.path(), {"run", "case.toml"}, catalogue);
    EXPECT_EQ(said.code, 3);
    EXPECT_THAT(said.err, HasSubstr(count));
    EXPECT_THAT(said.err, HasSubstr("1 failed"));
    EXPECT_THAT(said.out, HasSubstr("holds small"));
  }
  EXPECT_TRUE(std::ranges::any_of(records_in(scratch),
                                  [](const Record& r) { return r.status == "failed: broken on purpose"; }));
}

TEST(FailureCases, SeveralProcessesForgetNoFailure) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", with_a_broken_method());
  const Said said =
      modalbench(scratch.path(), {"run", "case.toml", "--untimed", "--jobs", "2"}, with_a_method_that_breaks());
  EXPECT_EQ(said.code, 3);
  EXPECT_THAT(said.err, HasSubstr("0 runs done, 5 found"));
}

TEST(FailureCases, AnAnalysisThatThrowsTakesNoOtherWithIt) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", replaced(small_case(), "modes = [4, 12]",
                                          "modes = [4, 12]\nanalyses = [\"frequencies\", \"probe-extremes\"]"));
  const std::string why = "the case states no [reference_frequencies]";
  const Said first = modalbench(scratch.path(), {"run", "case.toml"});
  EXPECT_EQ(first.code, 3);
  EXPECT_THAT(first.err, HasSubstr("frequencies · failed: " + why));
  EXPECT_THAT(first.err, HasSubstr("6 runs done, 0 found"));
  const auto all = Store(scratch / "results").read_all_findings();
  EXPECT_EQ(std::ranges::count_if(all.findings, [](const Finding& f) { return f.analysis == "probe-extremes"; }), 1);
  const auto failed = std::ranges::find_if(all.findings, [](const Finding& f) { return is_failure(f); });
  ASSERT_NE(failed, all.findings.end());
  EXPECT_EQ(failed->analysis, "frequencies");
  EXPECT_THAT(failed->note, HasSubstr(why));
  const Said second = modalbench(scratch.path(), {"run", "case.toml"});
  EXPECT_EQ(second.code, 3);
  EXPECT_THAT(second.err,
              HasSubstr("0 runs done, 6 found in results, 1 failed; a failure that is stored stays until --again"));
  EXPECT_THAT(second.err, HasSubstr("small · frequencies · failed in an earlier run"));
}

// Two microseconds without a value lie between all samples of a formula: bounds of it show them.
TEST(FailureCases, AGapBetweenSamplesIsRefusedBeforeAnyRun) {
  const ScratchFolder scratch;
  written(scratch / "case.toml",
          small_case("0.5", R"({ kind = "expression", formula = 'sqrt(abs(t - 0.0123456) - 1e-6)' })"));
  for (const char* command : {"check", "run"}) {
    const Said said = modalbench(scratch.path(), {command, "case.toml"});
    EXPECT_EQ(said.code, 2) << command;
    EXPECT_THAT(said.err, HasSubstr("is not finite at t = 0.01234"));
  }
  EXPECT_FALSE(fs::exists(scratch / "results"));
}

// Loads that last 1e-5 s and 1e-10 s of 0.1 s: a truth that skips them, or whose tolerance is met by anything, would
// grade what meets them as wrong, with a bar of almost nothing.
TEST(FailureCases, TruthsDoNotSkipWhatIsShort) {
  for (const char* history :
       {R"({ kind = "expression", formula = '0.01*sin(10*pi*t)^2 + (t > 0.05031 ? (t < 0.05032 ? 100 : 0) : 0)' })",
        R"({ kind = "pulse", duration = 1e-10, start = 0.05 })"}) {
    const ScratchFolder scratch;
    std::string words = small_case("0.5", history);
    const std::string methods = "methods = [\"static-correction\"]";
    words.replace(words.find(methods), methods.size(), "methods = [\"static-correction\", \"full\"]");
    written(scratch / "case.toml", words);
    ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0) << history;
    int n_marks = 0;
    for (const Record& record : records_in(scratch)) {
      if (record.contender.method != "full" || record.metric != "displacement-error" || record.truth != "same_mesh")
        continue;
      ++n_marks;
      EXPECT_LE(record.value, record.error_bar.value()) << history << ": the closed form of the mesh itself";
      EXPECT_LE(record.error_bar.value(), 0.01) << history;
    }
    EXPECT_EQ(n_marks, 1) << history;
  }
}

TEST(FailureCases, ATruthThatFailsLeavesARecordUntilItSucceeds) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "cases");
  written(scratch / "cases/small.toml", small_case());
  for (int i = 0; i < 2; ++i) {
    const Said said = modalbench(scratch.path(), {"run", "small"}, with_sundials(&broken_sundials));
    EXPECT_EQ(said.code, 3);
    EXPECT_THAT(said.err, HasSubstr("small · failed: no truth on purpose"));
  }
  ASSERT_EQ(records_in(scratch).size(), 1u);
  EXPECT_EQ(records_in(scratch)[0].status, "failed: no truth on purpose");
  ASSERT_EQ(modalbench(scratch.path(), {"report"}).code, 0);
  EXPECT_THAT(text(scratch / "report/report.md"), HasSubstr("no truth on purpose"));
  EXPECT_THAT(text(scratch / "report/report.md"), HasSubstr("0 of 1 check"));

  EXPECT_EQ(modalbench(scratch.path(), {"run", "small"}).code, 0);
  for (const Record& r : records_in(scratch)) EXPECT_EQ(r.status, "ok") << r.metric;
}

TEST(FailureCases, DamagedResultsAreNamedAndComputedAgain) {
  const ScratchFolder scratch;
  written(scratch / "case.toml",
          replaced(small_case(), "modes = [4, 12]", "modes = [4, 12]\nanalyses = [\"probe-extremes\"]"));
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml"}).code, 0);
  const Scene scene = read_toml(scratch / "case.toml", default_catalogue().vocabulary());
  const std::vector<Job> all = jobs(scene, default_catalogue());
  const auto file = [&](const std::string& shelf, size_t i, const char* ending) {
    return scratch / ("results/" + shelf + "/" + all[i].hash + ending);
  };
  const size_t n_records = records_in(scratch).size();
  fs::resize_file(file("records", 0, ".jsonl"), 700);
  fs::resize_file(file("records", 1, ".jsonl"), 0);
  fs::resize_file(file("timings", 2, ".jsonl"), 0);
  fs::resize_file(file("findings", 4, ".json"), 20);
  const Said plan = modalbench(scratch.path(), {"run", "case.toml", "--plan"});
  for (const size_t i : {0, 1, 2, 4}) EXPECT_THAT(plan.out, HasSubstr(all[i].hash + "  to run"));
  EXPECT_THAT(plan.out, HasSubstr(all[3].hash + "  stored"));
  const Said said = modalbench(scratch.path(), {"run", "case.toml"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("4 runs done, 1 found"));
  EXPECT_THAT(said.err, HasSubstr(all[0].hash + ".jsonl: is cut short or altered"));
  EXPECT_THAT(
      said.err,
      HasSubstr(all[1].hash + ".jsonl: is cut short or altered: its checksum is missing or another; computed again"));
  EXPECT_THAT(said.err, HasSubstr("timings/" + all[2].hash + ".jsonl: "));
  EXPECT_THAT(said.err, HasSubstr(all[4].hash + ".json: "));
  EXPECT_EQ(records_in(scratch).size(), n_records);
  EXPECT_THAT(modalbench(scratch.path(), {"run", "case.toml"}).err, HasSubstr("0 runs done, 5 found"));
}

// Of whichever run they are: the folder of tables is read as a whole.
TEST(FailureCases, DamagedTablesOfOtherRunsAreNamed) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  const std::string table = "results/findings/" + std::string(32, 'c') + ".json";
  fs::create_directories(scratch / "results/findings");
  written(scratch / table, "[");
  const Said said = modalbench(scratch.path(), {"run", "case.toml", "--untimed", "-q"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("left out: " + table));
}

// No results of their own: what a truth contains, and the motion that an answer left.
TEST(FailureCases, WhatIsGoneBesideTheResultsIsMadeAgain) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0);
  const Scene scene = read_toml(scratch / "case.toml", default_catalogue().vocabulary());
  const std::string finer = run_hash(scene, truth_contenders(scene).front()),
                    motion = jobs(scene, default_catalogue()).front().hash;
  const fs::path marks = scratch / ("results/records/" + finer + ".jsonl"),
                 moved = scratch / ("results/trajectories/" + motion + ".h5");
  const std::string before = text(marks);
  fs::resize_file(marks, 100);
  const Said said = modalbench(scratch.path(), {"run", "case.toml", "--untimed"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("0 runs done, 4 found"));
  EXPECT_THAT(said.err, HasSubstr(finer + ".jsonl: is cut short or altered"));
  EXPECT_EQ(text(marks).size(), before.size());
  ASSERT_TRUE(fs::remove(moved));
  EXPECT_THAT(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).err, HasSubstr("1 runs done, 3 found"));
  EXPECT_TRUE(fs::exists(moved));
  for (const bool is_cut : {true, false}) {  // or another run's
    const fs::path other = scratch / ("results/trajectories/" + jobs(scene, default_catalogue()).at(1).hash + ".h5");
    is_cut ? fs::resize_file(moved, 500) : void(fs::copy_file(other, moved, fs::copy_options::overwrite_existing));
    const Said again = modalbench(scratch.path(), {"run", "case.toml", "--untimed"});
    EXPECT_THAT(again.err, HasSubstr("1 runs done, 3 found")) << is_cut;
    EXPECT_THAT(again.err, HasSubstr(motion + ".h5: ")) << is_cut;
    EXPECT_THAT(again.err, HasSubstr("computed again")) << is_cut;
    EXPECT_THAT(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).err, HasSubstr("0 runs done, 4 found"));
  }
}

// Rivals that are the truths themselves: under one name stand their marks, their times and what the truth contains.
TEST(FailureCases, TruthsLeaveTheTimesOfTheirTwinsAlone) {
  const ScratchFolder scratch;
  const std::string twins = R"(
[[study.rival]]
integrator = "sundials"
degrees = [2, 3]
cells = [[1, 2]]
relative_tolerances = [1e-4]
[[check]])";
  written(scratch / "case.toml", replaced(small_case(), "\n[[check]]", twins));
  const auto count = [&](const std::string& method, const std::string& metric) {
    return std::ranges::count_if(
        records_in(scratch), [&](const Record& r) { return r.contender.integrator == method && r.metric == metric; });
  };
  for (const auto& words : {std::vector<std::string>{}, {"--set", "modal.modes=6"}, {}}) {
    std::vector<std::string> line{"run", "case.toml"};
    line.insert(line.end(), words.begin(), words.end());
    ASSERT_EQ(modalbench(scratch.path(), line).code, 0);
    EXPECT_EQ(count("sundials", "online-time"), 2);
    EXPECT_EQ(count("sundials", "truth-above-band"), 1);
    for (const Record& record : records_in(scratch))
      EXPECT_TRUE(!record.metric.starts_with("truth-") || record.error_bar) << record.metric;
    EXPECT_EQ(count("sundials", "displacement-error"), 3);  // on the body's mesh against both truths
  }
  EXPECT_THAT(modalbench(scratch.path(), {"run", "case.toml"}).err, HasSubstr("0 runs done, 6 found"));
}

}  // namespace
}  // namespace mb
