// The program interrupted and killed, alone and with processes of its own.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <regex>
#include <utility>

#include "harness/faults_test.h"
#include "harness/interruptible.h"
#include "harness/store/file.h"

namespace mb {
namespace {

using namespace faults;
using ::testing::HasSubstr;

// Whether none is left within five seconds.
bool all_end(const std::vector<pid_t>& processes) {
  const auto any_left = [&] { return std::ranges::any_of(processes, is_running); };
  for (int i = 0; i < 500 && any_left(); ++i) ::usleep(10'000);
  return !any_left();
}

TEST(SignalCases, CtrlCEndsAProcessCleanly) {
  for (const char* jobs : {"1", "2"}) {
    const ScratchFolder scratch;
    written(scratch / "case.toml", analysed_case());
    Process process(scratch.path(), run_with({"--jobs", jobs}), [] { ::setpgid(0, 0); });
    while (!process.ends_within(0.01) && process.err().find("truth Q") == std::string::npos) continue;
    process.send_to_group(SIGINT);  // as a terminal does
    EXPECT_EQ(process.code(), 130) << process.err();
    EXPECT_THAT(process.err(),
                HasSubstr("interrupted; what is finished is kept. To go on:\n  modalbench run case.toml"));
    expect_sound(scratch / "results");
    expect_nothing_half_written(scratch / "results");
    Process again(scratch.path(), run);
    EXPECT_EQ(again.code(), 0) << again.err();
  }
}

// Sixty runs of tenths of a second, by a signal to the first process alone, as `kill` and a service's end have it:
// passed on, so that those forked end after what they have under way, not after their part of the sixty.
TEST(SignalCases, WhatEndsTheFirstProcessEndsAllCleanly) {
  std::string steps;
  for (int i = 0; i < 60; ++i) steps += fmt::format("{}{:g}", i > 0 ? ", " : "", 1e-5 * (1 + 0.01 * i));
  for (const int signal : {SIGTERM, SIGHUP})
    for (const char* jobs : {"1", "2"}) {
      const ScratchFolder scratch;
      written(scratch / "case.toml", with_rivals(1, "[1, 2]", steps));
      Process process(scratch.path(), run_with({"--jobs", jobs}));
      while (!process.ends_within(0.005) && process.err().find("[2/") == std::string::npos) continue;
      const std::vector<pid_t> children = process.children();
      process.send(signal);
      EXPECT_EQ(process.code(), 130) << process.err();
      EXPECT_THAT(process.err(),
                  HasSubstr("interrupted; what is finished is kept. To go on:\n  modalbench run case.toml"));
      EXPECT_LT(std::distance(fs::directory_iterator(scratch / "results/records"), fs::directory_iterator()), 55);
      EXPECT_EQ(children.size(), std::string(jobs) == "2" ? 2u : 0u);
      for (const pid_t child : children) EXPECT_FALSE(is_running(child));
      expect_sound(scratch / "results");
      expect_nothing_half_written(scratch / "results");
    }
}

// What keeps nothing ends at once, by its exit code all the same.
TEST(SignalCases, WhatStoresNothingEndsAtOnce) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const ScratchFolder scratch;
    std::string words = small_case();
    const std::string finer = "degree = 3, cells = [1, 2]";
    written(scratch / "case.toml", words.replace(words.find(finer), finer.size(), "degree = 4, cells = [2, 8]"));
    Process process(scratch.path(), {"modes", "case.toml", "--count", "300"});
    while (!process.ends_within(0.01) && !process.handles(signal)) continue;
    ASSERT_FALSE(process.ends_within(0.3)) << process.err();
    process.send(signal);
    EXPECT_TRUE(process.ends_within(10));
    EXPECT_EQ(process.code(), 130) << process.err();
    EXPECT_EQ(process.err(), "interrupted\n");
  }
}

// As long as another holds the store, or the folder of the report: a holder that hangs must not hang who waits for it.
TEST(SignalCases, WhatWaitsForAFolderThatAnotherHoldsEnds) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(Process(scratch.path(), run).code(), 0);
  const std::vector<std::pair<const char*, std::vector<std::string>>> waiting{
      {"results", run}, {"report", {"report", "-o", "report", "case.toml"}}};
  for (const auto& [folder, words] : waiting) {
    auto lock = std::make_unique<FolderLock>(scratch / folder);
    Process process(scratch.path(), words);
    EXPECT_FALSE(process.ends_within(8)) << "did not wait for " << folder;
    process.send(SIGINT);
    EXPECT_TRUE(process.ends_within(Interruptible::patience + 10)) << folder;
    EXPECT_EQ(process.code(), 130) << process.err();
    EXPECT_THAT(process.err(), HasSubstr("interrupted")) << folder;
    lock.reset();
    Process again(scratch.path(), words);
    EXPECT_EQ(again.code(), 0) << again.err();
    expect_sound(scratch / "results");
  }
}

// METIS, which orders large matrices, would take SIGTERM for itself, and crash by it. While it works SIGABRT is its
// own.
TEST(SignalCases, WhileMetisOrdersAMatrixASignalEndsTheRunAllTheSame) {
  if (!metis_takes_signals()) GTEST_SKIP() << "a METIS that leaves signals alone";
  for (const int signal : {SIGTERM, SIGINT}) {
    const ScratchFolder scratch;
    ASSERT_EQ(Process(scratch.path(), {"new", "case.toml"}).code(), 0);
    const std::string words = text(scratch / "case.toml");
    written(scratch / "case.toml",
            std::regex_replace(words, std::regex("\nfiner = [^\n]*"), "\nfiner = { degree = 2, cells = [8, 8, 16] }"));
    Process process(scratch.path(), run);
    const auto large_is_begun = [&] { return process.err().find("rtol 1e-08") != std::string::npos; };
    while (!process.ends_within(0.001) && !(large_is_begun() && process.handles(SIGABRT))) continue;
    ASSERT_FALSE(process.ends_within(0)) << "no METIS of its own signals was at work: " << process.err();
    process.send(signal);
    EXPECT_TRUE(process.ends_within(Interruptible::patience + 10));
    EXPECT_EQ(process.code(), 130) << signal << process.err();
    EXPECT_THAT(process.err(), HasSubstr("interrupted; what is finished is kept")) << signal;
  }
}

// Ends runs of a minute each some time after they began: whether something long was under way, that is not waited for.
bool ends_what_is_long(const char* jobs, double wait) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", with_rivals(2, "[2, 4]", "1e-6, 1.1e-6"));
  Process process(scratch.path(), run_with({"--jobs", jobs}));
  const auto runs_are_begun = [&] {
    return *jobs == '2' ? process.children().size() == 2 : process.err().find("[1/") != std::string::npos;
  };
  while (!process.ends_within(0.01) && !runs_are_begun()) continue;
  EXPECT_FALSE(process.ends_within(wait)) << process.err();
  const std::vector<pid_t> children = process.children();
  process.send(SIGTERM);
  const bool was_long = !process.ends_within(1);
  EXPECT_TRUE(process.ends_within(Interruptible::patience + 10)) << jobs;  // of a busy machine
  EXPECT_EQ(process.code(), 130) << process.err();
  EXPECT_THAT(process.err(), HasSubstr("interrupted; what is finished is kept. To go on:\n  modalbench run"));
  EXPECT_TRUE(all_end(children));
  expect_sound(scratch / "results");
  return was_long;
}

// One signal is enough, and the last words are those of a good end. On a busy machine what is short takes longer, too.
TEST(SignalCases, WhatTakesLongIsNotWaitedFor) {
  for (const char* jobs : {"1", "2"})
    EXPECT_TRUE(ends_what_is_long(jobs, 2) || ends_what_is_long(jobs, 8) || ends_what_is_long(jobs, 20))
        << "nothing long was under way";
}

// A program named valgrind that says that it runs and never ends: `count` and an analysis of `run` pass on what ends
// them.
TEST(SignalCases, WhatEndsACountEndsValgrindAndLeavesNothing) {
  for (const std::string command : {"count", "run"}) {
    const ScratchFolder scratch;
    for (const char* folder : {"tmp", "bin", "cases"}) fs::create_directory(scratch / folder);
    written(scratch / "bin/valgrind", fmt::format("#!/bin/sh\n: >{0}\nexec sleep 1000\n", (scratch / "runs").string()));
    fs::permissions(scratch / "bin/valgrind", fs::perms::owner_all);
    written(scratch / "cases/small.toml", bouncing_case("contact_steps = [1e-3]\nanalyses = [\"instructions\"]"));
    Process process(scratch.path(), {command, "small"}, [&] {
      ::setenv("TMPDIR", (scratch / "tmp").c_str(), 1);
      ::setenv("PATH", fmt::format("{}:/usr/bin:/bin", (scratch / "bin").string()).c_str(), 1);
    });
    while (!process.ends_within(0.01) && !fs::exists(scratch / "runs")) continue;
    const std::vector<pid_t> children = process.children();
    ASSERT_EQ(children.size(), 1u) << process.err();
    process.send(SIGTERM);
    EXPECT_TRUE(process.ends_within(20)) << command;
    EXPECT_EQ(process.code(), 130) << process.err();
    EXPECT_FALSE(is_running(children.front()));
    EXPECT_TRUE(fs::is_empty(scratch / "tmp"));
    if (command == "run") expect_sound(scratch / "results");
  }
}

// As nohup and a shell's `&` begin it.
TEST(SignalCases, WhatIsIgnoredFromTheStartStaysIgnored) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  Process process(scratch.path(), run, [] {
    for (const int signal : {SIGINT, SIGHUP}) std::signal(signal, SIG_IGN);
  });
  while (!process.ends_within(0.005) && process.err().find("truth Q") == std::string::npos) continue;
  ASSERT_FALSE(process.ends_within(0)) << "ended before the signals";
  for (const int signal : {SIGINT, SIGHUP}) process.send(signal);
  EXPECT_EQ(process.code(), 0) << process.err();
}

// Runs of a minute each: none goes on by itself once the process that began them was killed.
TEST(SignalCases, NoProcessOutlivesTheFirst) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", with_rivals(2, "[2, 4]", "1e-6, 1.1e-6"));
  Process process(scratch.path(), run_with({"--jobs", "2"}));
  while (!process.ends_within(0.005) && process.children().size() < 2) continue;
  const std::vector<pid_t> children = process.children();
  ASSERT_EQ(children.size(), 2u) << process.err();
  process.send(SIGKILL);
  EXPECT_EQ(process.code(), -SIGKILL);
  EXPECT_TRUE(all_end(children));
  for (const pid_t child : children) ::kill(child, SIGKILL);
  expect_sound(scratch / "results");
}

}  // namespace
}  // namespace mb
