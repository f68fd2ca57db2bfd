// The program killed, starved of disk and memory, shut out, interrupted and started twice: what is finished stays, what
// is half-written is never read, what went wrong is said.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <random>

#include "cases/json/record_json.h"
#include "harness/process_test.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"

namespace mb {
namespace {

using testing::HasSubstr;

const std::vector<std::string> run{"run", "case.toml", "--untimed", "--resume"};

std::vector<std::string> run_with(std::initializer_list<std::string> more) {
  std::vector<std::string> words = run;
  words.insert(words.end(), more);
  return words;
}

// Files of the store under their final names, below it.
std::map<std::string, std::string> finished(const fs::path& store) {
  std::map<std::string, std::string> files;
  if (!fs::exists(store)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(store)) {
    const std::string ending = entry.path().extension();
    if (entry.is_regular_file() && (ending == ".h5" || ending == ".json" || ending == ".jsonl"))
      files[fs::relative(entry.path(), store)] = text(entry.path());
  }
  files.erase("results.jsonl");  // made of the others
  return files;
}

// Everything but the date of computation.
std::string timeless(std::string content) {
  for (size_t at = 0; (at = content.find("\"date\":\"", at)) != std::string::npos;)
    content.erase(at, content.find('"', at + 8) - at);
  return content.substr(0, content.rfind("{\"checksum\""));
}

void expect_same_results(const fs::path& a, const fs::path& b) {
  const auto first = finished(a), second = finished(b);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_GE(first.size(), 12u);  // 4 truths, 4 answers, 4 runs and the marks of truths
  for (const auto& [name, content] : first) {
    ASSERT_TRUE(second.contains(name)) << name;
    EXPECT_TRUE(timeless(content) == timeless(second.at(name))) << name;
  }
}

// Whether every finished file is sound.
void expect_sound(const fs::path& directory) {
  const Store store(directory);
  for (const RefusedLine& line : store.read_all_records().refused) ADD_FAILURE() << line.file << ": " << line.reason;
  for (const RefusedLine& line : store.read_all_findings().refused) ADD_FAILURE() << line.file << ": " << line.reason;
  for (const auto& [name, content] : finished(directory)) {
    const fs::path file = name;
    if (file.parent_path() == "truth") {
      EXPECT_NO_THROW(store.read_truth(file.stem())) << name;
    } else if (file.parent_path() == "trajectories") {
      EXPECT_NO_THROW(store.read_trajectory(file.stem())) << name;
    }
  }
}

std::string analysed_case() {
  std::string all = small_case();
  const std::string modes = "modes = [4, 12]";
  return all.replace(all.find(modes), modes.size(), modes + "\nanalyses = [\"probe-extremes\"]");
}

// Killed soon after it has finished something, until nothing is left to do.
TEST(FaultCases, ARunThatIsKilledGoesOnWhereItWas) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  std::mt19937 random(5);
  std::map<std::string, std::string> before;
  std::map<std::string, fs::file_time_type> written_at;
  int n_killed = 0;
  for (bool ended = false; !ended; ++n_killed) {
    Process process(scratch.path(), run);
    while (!(ended = process.ends_within(0.002)) && finished(scratch / "results").size() == before.size()) continue;
    ended = ended || process.ends_within(static_cast<double>(random() % 100) / 1000);
    process.send(SIGKILL);
    EXPECT_EQ(process.code(), ended ? 0 : -SIGKILL) << process.err();
    expect_sound(scratch / "results");
    const auto now = finished(scratch / "results");
    for (const auto& [name, content] : before) {
      ASSERT_TRUE(now.contains(name)) << name;
      EXPECT_TRUE(now.at(name) == content) << name << " is another";
      EXPECT_EQ(fs::last_write_time(scratch / ("results/" + name)), written_at.at(name))
          << name << " was written again";
    }
    before = now;
    for (const auto& [name, content] : now) written_at[name] = fs::last_write_time(scratch / ("results/" + name));
  }
  EXPECT_GE(n_killed, 4);  // the last one ended by itself
  Process last(scratch.path(), run), alone(scratch.path(), run_with({"--store", "alone"}));
  EXPECT_EQ(last.code(), 0) << last.err();
  EXPECT_THAT(last.err(), HasSubstr("0 runs done, 5 found"));
  EXPECT_EQ(alone.code(), 0) << alone.err();
  expect_same_results(scratch / "alone", scratch / "results");
}

TEST(FaultCases, TwoRunsAtOnceDoNotHarmTheirStore) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  Process one(scratch.path(), run), other(scratch.path(), run_with({"--jobs", "2"}));
  EXPECT_EQ(one.code(), 0) << one.err();
  EXPECT_EQ(other.code(), 0) << other.err();
  expect_sound(scratch / "results");
  Process third(scratch.path(), run), alone(scratch.path(), run_with({"--store", "alone"}));
  EXPECT_EQ(third.code(), 0);
  EXPECT_THAT(third.err(), HasSubstr("0 runs done, 5 found"));
  EXPECT_EQ(alone.code(), 0);
  expect_same_results(scratch / "alone", scratch / "results");
}

// No file may grow beyond what the disk has left.
TEST(FaultCases, AFullDiskIsToldAndLeavesTheStoreWhole) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  for (const rlim_t size : {0, 3000, 20000}) {
    Process process(scratch.path(), run, [size] {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{size, RLIM_INFINITY};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    });
    EXPECT_EQ(process.code(), 3) << size;
    if (size > 0) {  // else not even its own message arrives
      EXPECT_THAT(process.err(), testing::ContainsRegex("results/.*: cannot be written: File too large"));
    }
    expect_sound(scratch / "results");
    for (const auto& entry : fs::recursive_directory_iterator(scratch / "results"))
      EXPECT_TRUE(entry.is_directory() || entry.path().extension() == ".h5" || entry.path().extension() == ".jsonl" ||
                  entry.path().extension() == ".json")
          << entry.path() << " is left behind";
  }
  Process process(scratch.path(), run);
  EXPECT_EQ(process.code(), 0) << process.err();
}

TEST(FaultCases, AStoreThatMayNotBeWrittenIsToldWithTheReason) {
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms::all);
  written(scratch / "case.toml", analysed_case());
  fs::create_directory(scratch / "results");
  fs::permissions(scratch / "results",
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  Process process(scratch.path(), run, [] {  // root may write anywhere
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(125);
  });
  const int code = process.code();
  if (code == 125 || code == 127) GTEST_SKIP() << "no other user to be, or the program is not theirs to read";
  EXPECT_EQ(code, 3);
  EXPECT_THAT(process.err(), HasSubstr("results/truth"));
  EXPECT_THAT(process.err(), HasSubstr("Permission denied"));
}

TEST(FaultCases, CtrlCEndsAProcessCleanly) {
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
    Process again(scratch.path(), run);
    EXPECT_EQ(again.code(), 0) << again.err();
  }
}

// 85^3 cubes of degree 1: two million degrees of freedom, whose factor takes a terabyte.
TEST(FaultCases, WhatIsBeyondMemoryIsRefusedBeforeItIsAllocated) {
  const ScratchFolder scratch;
  std::string large = small_case();
  const auto replace = [&](const std::string& what, const std::string& by) {
    large.replace(large.find(what), what.size(), by);
  };
  replace("kind = \"cylinder\"\nradius = 0.05\nlength = 0.2", "kind = \"box\"\nsize = [0.1, 0.1, 0.2]");
  replace("degree = 2\ncells = [1, 2]", "degree = 1\ncells = [85, 85, 85]");
  replace("finer = { degree = 3, cells = [1, 2] }", "finer = { degree = 2, cells = [42, 42, 42] }");
  replace("coarser = { degree = 2, cells = [1, 2] }", "coarser = { degree = 1, cells = [60, 60, 60] }");
  replace("cells = [[1, 2]]", "cells = [[1, 1, 2]]");
  written(scratch / "case.toml", large);
  Process process(scratch.path(), run, [] {
#ifndef __SANITIZE_ADDRESS__                // which takes terabytes of addresses itself
    const rlim_t space = rlim_t{16} << 30;  // [byte]: what is allocated all the same fails at once
    const rlimit limit{space, space};
    ::setrlimit(RLIMIT_AS, &limit);
#endif
  });
  EXPECT_EQ(process.code(), 3);
  EXPECT_THAT(process.err(), testing::ContainsRegex("takes about [0-9.e+]+ GB of memory and [0-9.]+ GB are there"));
  EXPECT_FALSE(fs::exists(scratch / "results/truth"));
}

TEST(FaultCases, ResultsAreTheSameToTheBitAgainAndInSeveralProcesses) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  for (const char* jobs : {"1", "2"}) {
    Process process(scratch.path(), run_with({"--jobs", jobs, "--store", jobs}));
    EXPECT_EQ(process.code(), 0) << process.err();
  }
  Process again(scratch.path(), run_with({"--store", "again"}));
  EXPECT_EQ(again.code(), 0) << again.err();
  expect_same_results(scratch / "1", scratch / "2");
  expect_same_results(scratch / "1", scratch / "again");
}

// Sums in another order: the rounding of some hundred steps, far below every error bar.
TEST(FaultCases, ResultsOnTwoThreadsAreTheSameToRounding) {
  const ScratchFolder scratch;
  std::string fine = small_case();
  const std::string coarse_mesh = "finer = { degree = 3, cells = [1, 2] }";
  written(scratch / "case.toml",
          fine.replace(fine.find(coarse_mesh), coarse_mesh.size(), "finer = { degree = 3, cells = [2, 4] }"));
  for (const char* threads : {"1", "2"}) {
    Process process(scratch.path(), run_with({"--threads", threads, "--store", threads}));
    EXPECT_EQ(process.code(), 0) << process.err();
  }
  const auto one = read_records(scratch / "1/results.jsonl").records;
  const auto two = read_records(scratch / "2/results.jsonl").records;
  ASSERT_EQ(one.size(), two.size());
  ASSERT_FALSE(one.empty());
  if (two[0].provenance.at("threads") == "1") GTEST_SKIP() << "a BLAS of one thread";
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].provenance.at("threads"), "1");
    EXPECT_EQ(one[i].run, two[i].run);
    EXPECT_EQ(one[i].metric, two[i].metric);
    if (std::isfinite(one[i].value)) {  // [-] of the truth, [m] or [rad] of a body of 0.2 m
      EXPECT_NEAR(one[i].value, two[i].value, 1e-10) << one[i].metric;
    }
  }
}

}  // namespace
}  // namespace mb
