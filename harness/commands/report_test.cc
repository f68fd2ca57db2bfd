// `modalbench report` on what it cannot report: it says so, and reports the rest.
#include <gmock/gmock.h>

#include <cstdlib>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "harness/study/identity.h"
#include "harness/study/plan.h"
#include "reports/content.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

// A store that holds one mark of the case.
void write_mark(const fs::path& file, const fs::path& store) {
  const Catalogue catalogue = default_catalogue();
  const Scene scene = read_toml(file, catalogue.vocabulary());
  Record record;
  record.contender = contenders(scene, catalogue).front();
  record.run = run_hash(scene, record.contender);
  record.case_name = scene.name;
  record.profile = "quick";
  record.metric = "displacement-error";
  record.truth = "finer";
  record.unit = "-";
  record.status = "ok";
  Store(store).write_records(record.run, {record});
}

std::string named(const std::string& name) {
  std::string content = small_case();
  return content.replace(content.find("small"), 5, name);
}

TEST(ReportCommandTest, AStoreThatIsNotThereIsNamed) {
  const ScratchFolder scratch;
  const Said said = modalbench(scratch.path(), {"report", "--store", "nosuch"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("no store at 'nosuch'"));
  EXPECT_FALSE(fs::exists(scratch / "report"));
}

TEST(ReportCommandTest, AWrongCaseFileIsNamedAndTheOthersAreReported) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "cases");
  for (const char* name : {"one", "two"}) {
    const fs::path file = written(scratch / ("cases/" + std::string(name) + ".toml"), named(name));
    write_mark(file, scratch / "results");
  }
  written(scratch / "cases/one.toml", "schema = 1\n");
  const Said said = modalbench(scratch.path(), {"report"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("cases/one.toml"));
  EXPECT_THAT(said.err, HasSubstr("results of 'one' in profile quick are left out"));
  EXPECT_THAT(text(scratch / "report/report.md"), HasSubstr("two"));
}

// A report of nothing would say that nothing was run.
TEST(ReportCommandTest, WhereNothingStoredCanBeReportedTheRemedyIsNamed) {
  const ScratchFolder scratch;
  const fs::path file = written(scratch / "small.toml", small_case());
  write_mark(file, scratch / "results");
  const Said by_name = modalbench(scratch.path(), {"report"});
  EXPECT_EQ(by_name.code, 2);
  EXPECT_THAT(by_name.err, HasSubstr("name the file: modalbench report small.toml\n"));
  written(scratch / "other.toml", named("other"));
  const Said other = modalbench(scratch.path(), {"report", "other.toml"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("the store holds results of 'small' alone"));
  std::string changed = small_case();
  changed.replace(changed.find("2e4"), 3, "3e4");
  written(file, changed);
  const Said stale = modalbench(scratch.path(), {"report", "small.toml"});
  EXPECT_EQ(stale.code, 2);
  EXPECT_THAT(stale.err, HasSubstr("changed since"));
  EXPECT_FALSE(fs::exists(scratch / "report"));
}

// Nor is a store without its records one of a case that states no check.
TEST(ReportCommandTest, AStoreWithoutRecordsIsNoReport) {
  const ScratchFolder scratch;
  const fs::path file = written(scratch / "small.toml", small_case());
  write_mark(file, scratch / "results");
  fs::remove_all(scratch / "results/records");
  const Said said = modalbench(scratch.path(), {"report", "small.toml"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("nothing to report: 'results' holds no records"));
  EXPECT_FALSE(fs::exists(scratch / "report"));
}

// All of what it reads: records, times and tables. Trajectories and truths it never opens; `clean` does.
TEST(ReportCommandTest, DamageOfWhatIsReadIsNamedEvenQuietly) {
  const ScratchFolder scratch;
  const fs::path file = written(scratch / "small.toml", small_case());
  write_mark(file, scratch / "results");
  const std::string hash(32, 'c');
  for (const char* shelf : {"records", "timings", "findings", "trajectories", "truth"})
    fs::create_directories(scratch / "results" / shelf);
  const std::vector<std::string> read{"records/" + hash + ".jsonl", "timings/" + hash + ".jsonl",
                                      "findings/" + hash + ".json"};
  for (const std::string& name : read) written(scratch / ("results/" + name), "[");
  for (const char* shelf : {"trajectories/", "truth/"}) written(scratch / ("results/" + (shelf + hash) + ".h5"), "[");
  const Said said = modalbench(scratch.path(), {"report", "-q", "small.toml"});
  EXPECT_EQ(said.code, 0) << said.err;
  for (const std::string& name : read) EXPECT_THAT(said.err, HasSubstr("left out: results/" + name));
  EXPECT_THAT(said.err, ::testing::Not(HasSubstr(".h5")));
  EXPECT_THAT(text(scratch / "report/report.md"), HasSubstr("3 damaged files of the store are left out"));
}

// Each would be told what was measured of the other.
TEST(ReportCommandTest, TwoFilesOfOneNameAreRefusedByAllCommands) {
  const ScratchFolder scratch;
  written(scratch / "one.toml", small_case());
  written(scratch / "two.toml", small_case("0.4"));
  fs::create_symlink("one.toml", scratch / "link.toml");
  fs::create_directory(scratch / "results");
  for (const char* command : {"check", "run", "report", "clean"}) {
    const Said said = modalbench(scratch.path(), {command, "one.toml", "two.toml"});
    EXPECT_EQ(said.code, 2) << command;
    EXPECT_THAT(said.err, HasSubstr("one.toml and two.toml are both named 'small'")) << command;
  }
  EXPECT_TRUE(fs::is_empty(scratch / "results"));
  EXPECT_EQ(modalbench(scratch.path(), {"check", "one.toml", "./one.toml", "link.toml"}).code, 0);
}

TEST(ReportCommandTest, OpenShowsThePageOrSaysWhyNot) {
  const ScratchFolder scratch;
  write_mark(written(scratch / "small.toml", small_case()), scratch / "results");
  const std::string before = std::getenv("PATH") ? std::getenv("PATH") : "";
  ::setenv("PATH", (scratch / "none").c_str(), 1);
  const Said without = modalbench(scratch.path(), {"report", "small.toml", "--open", "-q"});
  const fs::path program = written(scratch / "xdg-open", "#!/bin/sh\necho \"$1\" > shown\n");
  fs::permissions(program, fs::perms::owner_all);
  ::setenv("PATH", scratch.path().c_str(), 1);
  const Said with = modalbench(scratch.path(), {"report", "small.toml", "--open", "-q"});
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_EQ(with.code, 0) << with.err;
  if (!page_available()) {  // built without Node: no report.html
    EXPECT_THAT(with.err, HasSubstr("no report.html"));
    return;
  }
  EXPECT_THAT(without.err, HasSubstr("there is no xdg-open here"));
  EXPECT_EQ(with.err, "");
  EXPECT_EQ(text(scratch / "shown"), fs::absolute(scratch / "report/report.html").string() + "\n");
}

TEST(ReportCommandTest, TablesOfOtherSettingsAreCounted) {
  const ScratchFolder scratch;
  const fs::path file = written(scratch / "small.toml", small_case());
  write_mark(file, scratch / "results");
  Finding finding;
  finding.run = std::string(32, 'a');
  finding.analysis = finding.name = finding.title = finding.note = "budget";
  finding.case_name = "small", finding.profile = "quick";
  finding.columns = {{"a", ""}};
  Store(scratch / "results").write_findings(finding.run, {finding});
  const Said said = modalbench(scratch.path(), {"report", "small.toml"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("1 tables of analyses left out: of other settings, as `run --set`"));
}

}  // namespace
}  // namespace mb
