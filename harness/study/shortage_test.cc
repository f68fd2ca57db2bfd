// A shortage of memory passes: what stands stays, and what failed of it is tried again.
#include <gmock/gmock.h>

#include "harness/faults_test.h"
#include "harness/study/estimate.h"
#include "harness/study/run_case.h"
#include "harness/study/stored.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

std::shared_ptr<const Scene> scene_of(const ScratchFolder& scratch) {
  written(scratch / "case.toml", faults::analysed_case());
  return std::make_shared<const Scene>(read_toml(scratch / "case.toml", default_catalogue().vocabulary()));
}

// A run that finds room for its truths, and none for a job.
CaseOutcome starved(const std::shared_ptr<const Scene>& scene, const Store& store, bool again = false) {
  RunOptions options;
  options.memory = 1e4;
  options.timed = false;
  options.again = again;
  return run_case(scene, default_catalogue(), store, options, [](const std::string&) {});
}

TEST(ShortageCases, WhatFailedForWantOfMemoryIsTriedAgain) {
  const ScratchFolder scratch;
  const auto scene = scene_of(scratch);
  const Store store(scratch / "results");
  for (int i = 0; i < 2; ++i) {
    const CaseOutcome outcome = starved(scene, store);
    EXPECT_EQ(outcome.n_failed, 5);
    EXPECT_EQ(outcome.n_stored, 0);
  }
  for (const Record& r : store.read_all_records().records)
    EXPECT_TRUE(!is_failure(r) || r.status.starts_with("failed: out of memory: takes about")) << r.status;
  const Said said = modalbench(scratch.path(), {"run", "case.toml", "--untimed", "--resume"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("5 runs done, 0 found in results, 0 failed"));
  for (const Record& r : store.read_all_records().records) EXPECT_EQ(r.status, "ok") << r.metric;
}

// Allocations that fail all the same, and factors that say so in words of their own.
TEST(ShortageCases, AllocationsThatFailedAreTriedAgain) {
  for (const auto& fails :
       {+[](const System&, const Settings&, double) -> std::unique_ptr<Stepper> { throw std::bad_alloc(); },
        +[](const System&, const Settings&, double) -> std::unique_ptr<Stepper> {
          throw std::runtime_error("CHOLMOD: out of memory");
        }}) {
    const ScratchFolder scratch;
    written(scratch / "case.toml", small_case());
    Catalogue catalogue = default_catalogue();
    for (Integrator& integrator : catalogue.integrators)
      if (integrator.name == "newmark") integrator.prepare = fails;
    const std::vector<std::string> words{"run", "case.toml", "--untimed"};
    const Said first = modalbench(scratch.path(), words, catalogue), second = modalbench(scratch.path(), words);
    EXPECT_EQ(first.code, 3);
    EXPECT_THAT(first.err, HasSubstr("2 failed"));
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_THAT(second.err, HasSubstr("2 runs done, 2 found"));
  }
}

// The marks are there, their times are asked for, and there is no room to take them.
TEST(ShortageCases, AShortageOfMemoryTakesNoMarksAway) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0);
  const auto scene = std::make_shared<const Scene>(read_toml(scratch / "case.toml", default_catalogue().vocabulary()));
  const Store store(scratch / "results");
  RunOptions options;
  options.memory = 1e4;
  const auto starved = run_case(scene, default_catalogue(), store, options, [](const std::string&) {});
  EXPECT_EQ(starved.n_failed, 4);
  for (const Record& r : store.read_all_records().records) EXPECT_EQ(r.status, "ok") << r.metric;
  EXPECT_EQ(modalbench(scratch.path(), {"run", "case.toml"}).code, 0);
}

// What an analysis needs of its own mesh is there, what it needs of the finer one beside is not.
TEST(ShortageCases, AMeshThatAnAnalysisAsksForIsRefusedBeforeItIsMade) {
  const ScratchFolder scratch;
  std::string words = faults::analysed_case();
  const auto replace = [&](const std::string& what, const std::string& by) {
    words.replace(words.find(what), what.size(), by);
  };
  replace("probe-extremes", "mode-amplitudes");
  replace("finer = { degree = 3, cells = [1, 2] }", "finer = { degree = 3, cells = [2, 6] }");
  written(scratch / "case.toml", words);
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0);
  const auto scene = std::make_shared<const Scene>(read_toml(scratch / "case.toml", default_catalogue().vocabulary()));
  const Store store(scratch / "results");
  fs::remove_all(scratch / "results/findings");
  const double own = memory(*scene, jobs(*scene, default_catalogue()).back(), false);
  const double finer = memory_of_analysis(*scene, scene->truth.finer);
  ASSERT_LT(own, 0.8 * finer);
  RunOptions options;
  options.timed = false;
  options.memory = 0.9 * finer;
  EXPECT_EQ(run_case(scene, default_catalogue(), store, options, [](const std::string&) {}).n_failed, 1);
  const auto found = store.read_all_findings().findings;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found.front().note, HasSubstr("out of memory: takes about"));
  EXPECT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0);  // there is more
}

// What another process stores of its shortage while answers are computed gives way to them, and takes none away.
TEST(ShortageCases, AShortageOfAnotherProcessTakesNoAnswerAway) {
  const ScratchFolder scratch;
  const auto scene = scene_of(scratch);
  const Store store(scratch / "results");
  const auto starve = [&](bool again) { return starved(scene, store, again).n_failed; };
  RunOptions options;
  options.timed = false;
  int n_starved = 0;
  const auto after_the_first = [&](const std::string& said) {
    if (said.starts_with("[1/")) n_starved = starve(false);
  };
  EXPECT_EQ(run_case(scene, default_catalogue(), store, options, after_the_first).n_failed, 0);
  EXPECT_GE(n_starved, 4) << "three runs and the table";
  const auto expect_sound = [&] {
    for (const Record& r : store.read_all_records().records) EXPECT_EQ(r.status, "ok") << r.metric;
    for (const Finding& f : store.read_all_findings().findings) EXPECT_FALSE(is_failure(f)) << f.note;
    EXPECT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0);
  };
  expect_sound();
  EXPECT_EQ(starve(true), n_starved + 1);
  expect_sound();
}

}  // namespace
}  // namespace mb
