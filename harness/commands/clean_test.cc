// `modalbench clean` on a store made by hand: what is current stays, what is not goes, and only when told to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <sstream>

#include "harness/commands/inventory.h"
#include "harness/commands/told_test.h"
#include "harness/commands/usage_error.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "harness/study/identity.h"
#include "harness/study/plan.h"

namespace mb {
namespace {

using test::told;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string old_hash(32, 'a'), strange_hash(32, 'b'), damaged_hash(32, 'c');

std::string with_name(const std::string& name) {
  std::string text = small_case();
  return text.replace(text.find("small"), 5, name);
}

Trajectory trajectory() {
  Trajectory one;
  one.t = VectorXd::LinSpaced(3, 0, 1);
  one.bodies = {{MatrixXd::Random(6, 3), MatrixXd(6, 0)}};
  return one;
}

void write_run(const Store& store, const std::string& hash, const std::string& case_name, const Contender& contender) {
  Record record;
  record.run = hash;
  record.case_name = case_name;
  record.profile = "quick";
  record.contender = contender;
  record.metric = "displacement-error";
  record.unit = "-";
  record.status = "ok";
  store.write_records(hash, {record});
  store.write_times(hash, {});
  store.write_trajectory(hash, trajectory());
}

// A folder with the case `small`, and a store with a current run, one that --set asked for, one of other sources, and a
// current and an old truth.
class CleanTest : public ::testing::Test {
 protected:
  CleanTest() {
    fs::create_directory(folder / "cases");
    written(folder / "cases/small.toml", small_case());
    scene = read_toml(folder / "cases/small.toml", catalogue.vocabulary());
    Contender contender = contenders(scene, catalogue).front();
    current = run_hash(scene, contender);
    write_run(store, current, "small", contender);
    contender.settings.time_step *= 1.25;
    asked_for = run_hash(scene, contender);
    write_run(store, asked_for, "small", contender);
    write_run(store, old_hash, "small", contender);
    truth = truth_hash(scene, scene.truth.finer, scene.truth.relative_tolerance);
    store.write_truth(truth, trajectory());
    store.write_truth(old_hash, trajectory());
  }

  test::Told clean(CleanOptions options) const {
    options.store = "results";
    return told(folder.path(), [&](const Console& c) { return clean_command(options, catalogue, c); });
  }
  // Makes a file of the store ten days old.
  void age(const fs::path& file) const {
    const fs::path path = folder / "results" / file;
    fs::last_write_time(path, fs::last_write_time(path) - std::chrono::hours(240));
  }
  bool holds(const std::string& file) const { return fs::exists(folder / "results" / file); }

  const ScratchFolder folder;
  const Catalogue catalogue = default_catalogue();
  const Store store{folder / "results"};
  Scene scene;
  std::string current, asked_for, truth;
};

TEST_F(CleanTest, WhatAKilledProcessLeftBesideTheShelvesGoesWhenItIsOld) {
  for (const char* name : {"results.jsonl.aB3xY9", "probe.17812", "probe.17812.aB3xY9"}) {
    written(folder / "results" / name, "half");
    EXPECT_THAT(clean({}).out, Not(HasSubstr("was killed"))) << name;  // maybe it is being written
    age(name);
    EXPECT_THAT(clean({}).out, HasSubstr("was killed")) << name;
    EXPECT_EQ(clean({.yes = true}).code, 0);
    EXPECT_FALSE(holds(name));
  }
  written(folder / "results/probe.of-mine", "");
  age("probe.of-mine");
  EXPECT_EQ(clean({.yes = true}).code, 0);
  EXPECT_TRUE(holds("probe.of-mine"));
}

TEST_F(CleanTest, SaysWhatWouldGoAndDeletesNothing) {
  const test::Told said = clean({});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("results holds"));
  EXPECT_THAT(said.out, HasSubstr("11 files"));
  EXPECT_THAT(said.out, HasSubstr("would go"));
  EXPECT_THAT(said.out, HasSubstr("4 files"));
  EXPECT_THAT(said.out, HasSubstr("no longer so"));
  EXPECT_THAT(said.err, HasSubstr("nothing was deleted"));
  EXPECT_TRUE(holds("records/" + old_hash + ".jsonl"));
}

// Does something when clean says what goes, before it goes.
class OnGoes : public std::stringbuf {
 public:
  explicit OnGoes(std::function<void()> act) : act_(std::move(act)) {}

 protected:
  std::streamsize xsputn(const char* text, std::streamsize n) override {
    if (std::string(text, static_cast<std::size_t>(n)).find("goes") == 0) act_();
    return std::stringbuf::xsputn(text, n);
  }

 private:
  std::function<void()> act_;
};

// As a run does that finds it damaged.
TEST_F(CleanTest, WhatIsWrittenMeanwhileStays) {
  const std::string file = "trajectories/" + current + ".h5";
  written(folder / "results" / file, "damaged");
  OnGoes meanwhile([&] { store.write_trajectory(current, trajectory()); });
  std::ostream out(&meanwhile);
  const test::Told said = test::told(folder.path(), [&](const Console& c) {
    return clean_command({.store = "results", .yes = true}, catalogue, {out, c.err});
  });
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.err, HasSubstr("damaged: results/" + file));
  EXPECT_THAT(said.err, HasSubstr(file + ": written meanwhile: stays"));
  EXPECT_NO_THROW(store.read_trajectory(current));
  EXPECT_FALSE(holds("trajectories/" + old_hash + ".h5"));
}

TEST_F(CleanTest, TablesOfOtherSettingsGoUnderTheirName) {
  Finding table;
  table.run = old_hash;
  table.analysis = table.name = table.title = table.note = "budget";
  table.case_name = "small", table.profile = "quick";
  table.columns = {{"a", ""}};
  store.write_findings(old_hash, {table});
  EXPECT_THAT(clean({}).out, ::testing::ContainsRegex("1 file .* or of other settings, as `run --set` has them"));
}

TEST_F(CleanTest, WithYesWhatIsNotCurrentGoes) {
  store.rebuild_results();
  EXPECT_EQ(clean({.yes = true}).code, 0);
  for (const char* file : {"records/%.jsonl", "timings/%.jsonl", "trajectories/%.h5", "truth/%.h5"}) {
    std::string gone = file;
    EXPECT_FALSE(holds(gone.replace(gone.find('%'), 1, old_hash))) << file;
  }
  for (const std::string& hash : {current, asked_for}) {
    EXPECT_TRUE(holds("records/" + hash + ".jsonl"));
    EXPECT_TRUE(holds("timings/" + hash + ".jsonl"));
    EXPECT_TRUE(holds("trajectories/" + hash + ".h5"));
  }
  EXPECT_TRUE(holds("truth/" + truth + ".h5"));
  EXPECT_THAT(text(folder / "results/results.jsonl"), Not(HasSubstr(old_hash)));
  EXPECT_THAT(text(folder / "results/results.jsonl"), HasSubstr(current));
  EXPECT_THAT(clean({}).out, HasSubstr("nothing goes"));
}

// Results of somebody's own case file are not ours to judge, nor are truths that may be of it.
TEST_F(CleanTest, ResultsOfCasesThatAreNotFoundStay) {
  fs::create_directory(folder / "mine");
  written(folder / "mine/own.toml", with_name("own"));
  write_run(store, strange_hash, "own", contenders(scene, catalogue).front());
  const test::Told said = clean({.yes = true});
  EXPECT_THAT(said.err, HasSubstr("case 'own' is not found here"));
  EXPECT_TRUE(holds("records/" + strange_hash + ".jsonl"));
  EXPECT_TRUE(holds("truth/" + old_hash + ".h5"));
  EXPECT_FALSE(holds("records/" + old_hash + ".jsonl"));
  EXPECT_EQ(clean({.cases = {"mine/own.toml"}, .yes = true}).code, 0);
  EXPECT_FALSE(holds("records/" + strange_hash + ".jsonl"));
  EXPECT_FALSE(holds("truth/" + old_hash + ".h5"));
}

// A run of somebody's own case that was cut off, or is under way: its truth is there and no record yet.
TEST_F(CleanTest, TheTruthOfACaseThatIsNotFoundStaysBeforeItHasRecords) {
  Trajectory own = trajectory();
  own.case_name = "own";
  store.write_truth(strange_hash, own);
  store.write_trajectory(strange_hash, own);
  const test::Told said = clean({.yes = true});
  EXPECT_THAT(said.err, HasSubstr("case 'own' is not found here"));
  EXPECT_TRUE(holds("truth/" + strange_hash + ".h5"));
  EXPECT_TRUE(holds("trajectories/" + strange_hash + ".h5"));
  EXPECT_TRUE(holds("truth/" + old_hash + ".h5")) << "which may be of it, too, as it has the same physics";
  own.case_name = "small";
  store.write_truth(strange_hash, own);
  store.write_trajectory(strange_hash, own);
  clean({.yes = true});
  EXPECT_FALSE(holds("truth/" + strange_hash + ".h5")) << "of a case that asks for another now";
  EXPECT_FALSE(holds("trajectories/" + strange_hash + ".h5"));
  EXPECT_FALSE(holds("truth/" + old_hash + ".h5"));
}

TEST_F(CleanTest, DamagedFilesAreNamedAndGo) {
  fs::resize_file(folder / "results/trajectories" / (current + ".h5"), 700);
  written(folder / "results/records" / (damaged_hash + ".jsonl"), "{}\n");
  fs::create_directory(folder / "results/findings");
  written(folder / "results/findings" / (damaged_hash + ".json"), "[");
  fs::resize_file(folder / "results/truth" / (truth + ".h5"), 700);
  const test::Told said = clean({.yes = true});
  EXPECT_THAT(said.out, HasSubstr("damaged"));
  for (const std::string& file : {"trajectories/" + current + ".h5", "truth/" + truth + ".h5",
                                  "records/" + damaged_hash + ".jsonl", "findings/" + damaged_hash + ".json"}) {
    EXPECT_THAT(said.err, HasSubstr("damaged: results/" + file));
    EXPECT_FALSE(holds(file)) << file;
  }
  EXPECT_TRUE(holds("records/" + current + ".jsonl"));
}

TEST_F(CleanTest, AgeDecidesOnlyWhenAsked) {
  age("records/" + current + ".jsonl");
  EXPECT_THAT(clean({}).out, Not(HasSubstr("older than")));
  EXPECT_THAT(clean({.older = "2w"}).out, Not(HasSubstr("older than")));
  EXPECT_THAT(clean({.older = "9d"}).out, HasSubstr("older than 9d"));
  EXPECT_EQ(clean({.older = "9d", .yes = true}).code, 0);
  EXPECT_FALSE(holds("records/" + current + ".jsonl"));
  EXPECT_TRUE(holds("records/" + asked_for + ".jsonl"));
}

TEST_F(CleanTest, OnlyWhatTheSuiteNamedIsTouched) {
  written(folder / "results/notes.txt", "mine");
  written(folder / "results/records/notes.jsonl", "mine");
  written(folder / "results/records" / (old_hash + ".jsonl.AbCdEf"), "half");
  written(folder / "results/records" / (current + ".jsonl.AbCdEf"), "being written");
  age("records/" + old_hash + ".jsonl.AbCdEf");
  fs::create_symlink(folder / "cases/small.toml", folder / "results/truth" / (damaged_hash + ".h5"));
  const test::Told said = clean({.older = "1h", .yes = true});
  EXPECT_THAT(said.out, HasSubstr("killed"));
  EXPECT_THAT(said.err, HasSubstr("3 files that are not ours"));
  EXPECT_TRUE(holds("notes.txt"));
  EXPECT_TRUE(holds("records/notes.jsonl"));
  EXPECT_TRUE(holds("records/" + current + ".jsonl.AbCdEf"));
  EXPECT_FALSE(holds("records/" + old_hash + ".jsonl.AbCdEf"));
  EXPECT_TRUE(fs::exists(folder / "cases/small.toml"));
}

TEST_F(CleanTest, AWrongCaseFileKeepsItsResults) {
  written(folder / "cases/small.toml", "schema = 1\n");
  const test::Told said = clean({.yes = true});
  EXPECT_THAT(said.err, HasSubstr("no valid case"));
  EXPECT_TRUE(holds("records/" + old_hash + ".jsonl"));
  EXPECT_TRUE(holds("truth/" + old_hash + ".h5"));
}

TEST_F(CleanTest, BadInputIsRefused) {
  EXPECT_THROW(clean({.older = "30"}), UsageError);
  EXPECT_THROW(clean({.cases = {"no-such-case"}}), UsageError);
  EXPECT_THROW(clean({.cases = {"missing.toml"}}), CaseErrors);
  fs::rename(folder / "results", folder / "moved");
  EXPECT_THROW(clean({}), UsageError);
  EXPECT_FALSE(holds(""));
}

TEST(AgeTest, IsReadStrictly) {
  EXPECT_EQ(parse_age("12h"), 12 * 3600.0);
  EXPECT_EQ(parse_age("30d"), 30 * 86400.0);
  EXPECT_EQ(parse_age("2w"), 14 * 86400.0);
  EXPECT_EQ(parse_age("999999d"), 999999 * 86400.0);
  for (const char* wrong : {"", "d", "30", "30D", "30 d", " 30d", "30d ", "-1d", "+1d", "1.5d", "0d", "00h", "1dd",
                            "1m", "1000000d", "0x1d", "1e3d"})
    EXPECT_FALSE(parse_age(wrong)) << wrong;
}

}  // namespace
}  // namespace mb
