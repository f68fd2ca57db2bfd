#include "harness/store/store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <limits>
#include <memory>

#include "harness/store/file.h"
#include "harness/store/hash.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/seal.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::string low(32, '0'), high(32, 'f');

Record record(const std::string& run, double value) {
  Record record;
  record.run = run;
  record.case_name = "a";
  record.profile = "quick";
  record.contender = {"eigenmodes", "exact", {4, {1, 4}}, {}};
  record.metric = "displacement-error";
  record.truth = "finer";
  record.value = value;
  record.unit = "-";
  record.status = "ok";
  return record;
}

Trajectory trajectory(double amplitude) {
  Trajectory trajectory;
  trajectory.t = VectorXd::LinSpaced(5, 0, 1);
  trajectory.bodies = {{MatrixXd::Constant(6, 5, amplitude), MatrixXd(0, 0)}};
  return trajectory;
}

TEST(Store, TrajectoriesAndTruthsAreKeptApart) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  EXPECT_FALSE(store.has_trajectory(low));
  store.write_trajectory(low, trajectory(1));
  store.write_truth(low, trajectory(2));
  EXPECT_TRUE(store.has_trajectory(low));
  EXPECT_TRUE(store.has_truth(low));
  EXPECT_FALSE(store.has_truth(high));
  // 1e-12: what the store may drop.
  EXPECT_NEAR(store.read_trajectory(low).bodies[0].displacement(0, 0), 1, 1e-12);
  EXPECT_NEAR(store.read_truth(low).bodies[0].displacement(0, 0), 2, 2e-12);
  EXPECT_THROW(store.read_trajectory(high), StoreError);
}

TEST(Store, AMotionUnderAnotherNameIsRefused) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  for (const char* shelf : {"truth", "trajectories"}) {
    store.write_truth(low, trajectory(1));
    store.write_trajectory(low, trajectory(1));
    std::filesystem::copy(folder / ("results/" + std::string(shelf) + "/" + low + ".h5"),
                          folder / ("results/" + std::string(shelf) + "/" + high + ".h5"));
  }
  EXPECT_THAT([&] { store.read_truth(high); }, ThrowsMessage<StoreError>(HasSubstr("another run")));
  EXPECT_THAT([&] { store.read_trajectory(high); }, ThrowsMessage<StoreError>(HasSubstr("another run")));
}

TEST(Store, ResultsAreTheRecordsOfAllRunsSortedByRun) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  EXPECT_TRUE(store.read_all_records().records.empty());
  store.write_records(high, {record(high, 3), record(high, 4)});
  store.write_records(low, {record(low, 1)});
  store.write_records(low, {record(low, 2)});  // replaces
  EXPECT_TRUE(store.has_records(low));
  EXPECT_TRUE(store.rebuild_results().empty());
  const RecordLines lines = read_records(store.directory() / "results.jsonl");
  ASSERT_EQ(lines.records.size(), 3u);
  EXPECT_EQ(lines.records[0].run, low);
  EXPECT_EQ(lines.records[0].value, 2);
  EXPECT_EQ(lines.records[1].value, 3);
  EXPECT_EQ(lines.records[2].value, 4);
}

TEST(Store, ResultsOfTwoProcessesAtOnceAreThoseOfTheLast) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  store.write_records(low, {record(low, 1)});
  auto lock = std::make_unique<FolderLock>(store.directory());
  auto rebuilding = std::async(std::launch::async, [&] { store.rebuild_results(); });
  EXPECT_EQ(rebuilding.wait_for(std::chrono::milliseconds(50)), std::future_status::timeout)
      << "looked without the lock";
  store.write_records(high, {record(high, 2)});
  lock.reset();
  rebuilding.get();
  EXPECT_EQ(read_records(store.directory() / "results.jsonl").records.size(), 2u);
}

TEST(Store, DamagedRecordsAreNamedAndLeftOut) {
  const ScratchFolder folder;
  const Store store(folder.path());
  store.write_records(low, {record(low, 1)});
  const std::string good = unsealed(read_file(folder / "records" / (low + ".jsonl"), 1 << 20));
  write_file(folder / "records" / (high + ".jsonl"),
             sealed(good + good.substr(0, 50) + "\n"));  // another run's; no JSON
  write_file(folder / "records" / (high + ".jsonl.Xy12Z3"), "left behind by an interrupted run");
  write_file(folder / "records" / "notes.jsonl", "not ours");
  const RecordLines lines = store.read_all_records();
  EXPECT_EQ(lines.records.size(), 1u);
  ASSERT_EQ(lines.refused.size(), 2u);
  EXPECT_THAT(lines.refused[0].reason, HasSubstr("another run"));
  EXPECT_EQ(lines.refused[1].line, 2);
  EXPECT_EQ(lines.refused[1].file.filename(), high + ".jsonl");
  EXPECT_THAT(to_string(lines.refused[0]), EndsWith(high + ".jsonl: holds a record of another run"));
  EXPECT_THAT(to_string(lines.refused[1]), HasSubstr(high + ".jsonl:2: "));
  EXPECT_EQ(store.rebuild_results().size(), 2u);
}

// Nobody wants a million lines on one file, nor their memory.
TEST(Store, AFileOfNothingButDamagedLinesIsNotReadToItsEnd) {
  const ScratchFolder folder;
  const Store store(folder.path());
  std::string lines;
  for (int i = 0; i < 100000; ++i) lines += "no record\n";
  write_file(folder / "records" / (low + ".jsonl"), sealed(lines));
  const RecordLines read = store.read_all_records();
  ASSERT_EQ(read.refused.size(), 1001u);
  EXPECT_EQ(read.refused.back().line, 1001);
  EXPECT_THAT(read.refused.back().reason, HasSubstr("what follows is not read"));
}

TEST(Store, WhatIsTooLargeToBeReadAgainIsNotWritten) {
  const ScratchFolder folder;
  const Store store(folder.path());
  std::vector<Record> many(20000, record(low, 1));
  for (Record& one : many) one.subject = std::string(900, 'x');
  EXPECT_THAT([&] { store.write_records(low, many); },
              ::testing::ThrowsMessage<StoreError>(HasSubstr("would be larger than 16777216 bytes")));
  EXPECT_FALSE(store.has_records(low));
}

TEST(Store, OneLineTellsOfAFileThatIsNotItsOwn) {
  const ScratchFolder folder;
  const Store store(folder.path());
  store.write_records(low, {record(low, 1), record(low, 2)});
  std::filesystem::rename(folder / "records" / (low + ".jsonl"), folder / "records" / (high + ".jsonl"));
  std::filesystem::create_directory(folder / "records" / (low + ".jsonl"));
  const RecordLines lines = store.read_all_records();
  ASSERT_EQ(lines.refused.size(), 2u);
  EXPECT_EQ(lines.refused[0].reason, "is not a regular file");
  EXPECT_EQ(lines.refused[1].reason, "holds 2 records of another run");
}

TEST(Store, TimesStandBesideMarksAndGoWithThem) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  Record time = record(low, 1e-3);
  time.metric = "online-time", time.truth = "", time.unit = "s";
  store.write_records(low, {record(low, 0.5)});
  EXPECT_FALSE(store.has_times(low));
  store.write_times(low, {time});
  EXPECT_TRUE(store.has_times(low));
  EXPECT_EQ(store.read_records_of(low).records.size(), 1u);
  EXPECT_EQ(store.read_all_records().records.size(), 2u);
  store.write_records(low, {record(low, 0.25)});  // other marks: the old times are not theirs
  EXPECT_FALSE(store.has_times(low));
  EXPECT_EQ(store.read_all_records().records.size(), 1u);
}

TEST(Store, MarksThatCannotBeWrittenLeaveTheTimesAlone) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  store.write_times(low, {record(low, 1e-3)});
  write_file(folder / "results/records", "a file in the place of the folder");
  EXPECT_THROW(store.write_records(low, {record(low, 1)}), StoreError);
  EXPECT_TRUE(store.has_times(low));
}

// A process that ends between the two steps, as one whose last step fails: never old times beside new marks.
TEST(Store, TimesGoBeforeTheMarksThatReplaceTheirs) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  store.write_times(low, {record(low, 1e-3)});
  std::filesystem::create_directories(folder / ("results/records/" + low + ".jsonl/in the way"));
  EXPECT_THROW(store.write_records(low, {record(low, 1)}), StoreError);
  EXPECT_FALSE(store.has_times(low));
}

TEST(Store, ARunWithoutRecordsIsNamed) {
  const ScratchFolder folder;
  const Store store(folder.path());
  write_file(folder / "records" / (low + ".jsonl"), sealed(""));
  store.write_times(high, {});  // of a run that gave no answer
  for (const RecordLines& lines : {store.read_all_records(), store.read_records_of(low)}) {
    ASSERT_EQ(lines.refused.size(), 1u);
    EXPECT_EQ(lines.refused[0].reason, "holds no record");
  }
  EXPECT_TRUE(store.read_times_of(high).refused.empty());
}

TEST(Store, FindingsComeBackAndDamagedOnesAreNamed) {
  const ScratchFolder folder;
  const Store store(folder / "results");
  Finding finding;
  finding.run = low, finding.analysis = finding.name = "step-limits", finding.case_name = "a",
  finding.profile = "quick";
  finding.title = "t", finding.note = "n";
  finding.columns = {{"scheme", ""}, {"dt", "s"}};
  finding.rows = {{std::string("newmark"), std::numeric_limits<double>::infinity()}};
  store.write_findings(low, {finding});
  ASSERT_TRUE(store.has_findings(low));
  const auto all = store.read_all_findings();
  ASSERT_EQ(all.findings.size(), 1u) << all.refused[0].reason;
  EXPECT_EQ(all.findings[0].rows, finding.rows);
  EXPECT_EQ(store.read_findings_of(low).findings.size(), 1u);
  std::filesystem::resize_file(folder / "results/findings" / (low + ".json"), 20);
  EXPECT_EQ(store.read_all_findings().findings.size(), 0u);
  EXPECT_EQ(store.read_all_findings().refused.size(), 1u);
}

TEST(Store, DamagedTrajectoriesAreNamedAndCanBeWrittenOver) {
  const ScratchFolder folder;
  const Store store(folder.path());
  write_file(folder / "truth" / (low + ".h5"), "damaged");
  EXPECT_TRUE(store.has_truth(low));
  try {
    store.read_truth(low);
    FAIL();
  } catch (const StoreError& error) {
    EXPECT_EQ(error.file().filename(), low + ".h5");
  }
  store.write_truth(low, trajectory(1));
  EXPECT_EQ(store.read_truth(low).t.size(), 5);
}

TEST(Store, OnlyHashesNameRuns) {
  const ScratchFolder folder;
  const Store store(folder.path());
  for (const char* name : {"", "../x", "/etc/passwd", "ABC"}) {
    EXPECT_THROW(store.has_trajectory(name), std::invalid_argument);
    EXPECT_THROW(store.write_truth(name, trajectory(1)), std::invalid_argument);
    EXPECT_THROW(store.write_records(name, {}), std::invalid_argument);
  }
  EXPECT_THROW(store.write_records(high, {record(low, 1)}), std::invalid_argument);
}

TEST(Store, APlaceThatCannotBeWrittenIsTold) {
  const ScratchFolder folder;
  write_file(folder / "file", "x");
  const Store store(folder / "file");
  EXPECT_THROW(store.write_trajectory(low, trajectory(1)), StoreError);
  EXPECT_THROW(store.write_records(low, {record(low, 1)}), StoreError);
  EXPECT_THROW(store.rebuild_results(), StoreError);
}

// Before hours are spent: a file where a shelf belongs, or what leads nowhere.
TEST(Store, AShelfThatIsNoFolderIsToldBeforeTheWork) {
  const ScratchFolder folder;
  const Store store(folder.path());
  store.write_truth(low, trajectory(1));
  EXPECT_NO_THROW(store.require_writable());
  for (const char* shelf : {"findings", "records"}) {
    write_file(folder / shelf, "x");
    EXPECT_THAT([&] { store.require_writable(); },
                ThrowsMessage<StoreError>(AllOf(HasSubstr(shelf), HasSubstr("no folder, where one belongs"))));
    remove_file(folder / shelf);
  }
  std::filesystem::create_symlink("nowhere", folder / "timings");
  EXPECT_THROW(store.require_writable(), StoreError);
}

}  // namespace
}  // namespace mb
