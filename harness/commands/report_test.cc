// `modalbench report` on what it cannot report: it says so, and reports the rest.
#include <gmock/gmock.h>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "harness/study/identity.h"
#include "harness/study/plan.h"

namespace mb {
namespace {

using testing::HasSubstr;

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
