#include "harness/study/stored.h"

#include <gtest/gtest.h>

#include <future>

#include "harness/store/file.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

const std::string run(32, 'a');

std::vector<Record> marks(const std::string& status) {
  Record record;
  record.run = run;
  record.case_name = "a";
  record.profile = "quick";
  record.contender = {"eigenmodes", "exact", {2, {1, 4}}, {}};
  record.metric = "displacement-error";
  record.truth = "finer";
  record.value = status == "ok" ? 0.5 : std::nan("");
  record.unit = "-";
  record.status = status;
  return {record};
}

Finding table_of(const std::string& analysis) {
  Finding finding;
  finding.run = run;
  finding.case_name = "a";
  finding.profile = "quick";
  finding.analysis = finding.name = finding.title = analysis;
  finding.columns = {{"n", ""}};
  finding.rows = {{1.0}};
  return finding;
}

// What stands when `keep` began while another process was at the store, and had stored its own by the time it let go.
void keep_beside(const Store& store, const std::function<void()>& keep, const std::function<void()>& other) {
  auto lock = std::make_unique<FolderLock>(store.directory());
  auto keeping = std::async(std::launch::async, keep);
  EXPECT_EQ(keeping.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout) << "looked without the lock";
  other();
  lock.reset();
  keeping.get();
}

TEST(Stored, AFailureGivesWayToAnAnswerStoredMeanwhile) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  const auto status = [&] { return store.read_records_of(run).records.at(0).status; };
  keep_unless_answered(store, run, marks("failed: once"));
  EXPECT_EQ(status(), "failed: once");
  keep_beside(
      store, [&] { keep_unless_answered(store, run, marks("failed: twice")); },
      [&] { store.write_records(run, marks("ok")); });
  EXPECT_EQ(status(), "ok");
}

// What is unstable leaves no motion, and its marks are sound without one.
TEST(Stored, MarksGiveWayToSoundOnesAndTheirTimesUnlessTheyReplaceThem) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  const Job job{Job::Kind::marks, run, "a", marks("unstable")[0].contender, ""};
  keep_marks(store, job, marks("unstable"), false);
  store.write_times(run, marks("ok"));
  keep_marks(store, job, marks("unstable"), false);
  EXPECT_TRUE(store.has_times(run));
  keep_marks(store, job, marks("unstable"), true);
  EXPECT_FALSE(store.has_times(run));
  keep_unless_answered(store, run, marks("failed: late"));
  EXPECT_EQ(store.read_records_of(run).records.at(0).status, "unstable");
}

TEST(Stored, AFailingAnalysisGivesWayToATable) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  const Job job{Job::Kind::analysis, run, "budget", {}, "budget"};
  std::vector<Finding> failed{failed_table("budget", "once")};
  failed[0].run = run, failed[0].case_name = "a", failed[0].profile = "quick";
  const auto stands = [&] { return is_failure(store.read_findings_of(run).findings.at(0)); };
  keep_tables(store, job, failed);
  EXPECT_TRUE(stands());
  keep_beside(
      store, [&] { keep_tables(store, job, failed); }, [&] { store.write_findings(run, {table_of("budget")}); });
  EXPECT_FALSE(stands());
  keep_tables(store, job, {table_of("budget"), table_of("budget-cross-terms")});
  EXPECT_EQ(store.read_findings_of(run).findings.size(), 2u);
}

}  // namespace
}  // namespace mb
