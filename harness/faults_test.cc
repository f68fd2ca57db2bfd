// The program killed, starved of memory and started twice: what is finished stays, what is half-written is never read,
// what went wrong is said.
#include <sys/resource.h>

#include <algorithm>
#include <random>
#include <regex>

#include "harness/faults_test.h"

namespace mb {
namespace {

using namespace faults;
using ::testing::HasSubstr;
using ::testing::Not;

// Killed soon after it has finished something, until nothing is left to do. A run is finished with its records: killed
// before them, it writes the same trajectory again.
struct Killed {
  const char* jobs;
  bool timed;
};
void PrintTo(const Killed& k, std::ostream* out) { *out << k.jobs << (k.timed ? " timed" : ""); }
class KilledFaultCases : public ::testing::TestWithParam<Killed> {};

TEST_P(KilledFaultCases, ARunGoesOnWhereItWas) {
  const auto [jobs, timed] = GetParam();
  std::vector<std::string> words = run_with({"--jobs", jobs});
  if (timed) std::erase(words, "--untimed");
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  std::mt19937 random(5);
  std::map<std::string, std::string> before;
  std::map<std::string, fs::file_time_type> written_at;
  int n_killed = 0;
  for (bool ended = false; !ended; ++n_killed) {
    Process process(scratch.path(), words);
    while (!(ended = process.ends_within(0.002)) && finished(scratch / "results").size() == before.size()) continue;
    ended = ended || process.ends_within(static_cast<double>(random() % 100) / 1000);
    process.send(SIGKILL);
    const int code = process.code();
    ended = ended || code == 0;  // before the signal came
    EXPECT_EQ(code, ended ? 0 : -SIGKILL) << process.err();
    expect_sound(scratch / "results");
    const auto now = finished(scratch / "results");
    for (const auto& [name, content] : before) {
      ASSERT_TRUE(now.contains(name)) << name;
      EXPECT_TRUE(now.at(name) == content) << name << " is another";
      const bool is_answer = name.starts_with("trajectories/");
      if (is_answer && !before.contains("records/" + fs::path(name).stem().string() + ".jsonl")) continue;
      EXPECT_EQ(fs::last_write_time(scratch / ("results/" + name)), written_at.at(name))
          << name << " was written again";
    }
    before = now;
    for (const auto& [name, content] : now) written_at[name] = fs::last_write_time(scratch / ("results/" + name));
  }
  EXPECT_GE(n_killed, 4);  // the last one ended by itself
  Process last(scratch.path(), words), alone(scratch.path(), run_with({"--store", "alone"}));
  EXPECT_EQ(last.code(), 0) << last.err();
  EXPECT_THAT(last.err(), HasSubstr("0 runs done, 5 found"));
  EXPECT_EQ(alone.code(), 0) << alone.err();
  EXPECT_EQ(fs::remove_all(scratch / "results/timings") > 1, timed);
  expect_same_results(scratch / "alone", scratch / "results");
}

INSTANTIATE_TEST_SUITE_P(Processes, KilledFaultCases,
                         ::testing::Values(Killed{"1", false}, Killed{"2", false}, Killed{"1", true}));

TEST(FaultCases, TwoRunsAtOnceDoNotHarmTheirStore) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  Process one(scratch.path(), run), other(scratch.path(), run_with({"--jobs", "2"}));
  EXPECT_EQ(one.code(), 0) << one.err();
  EXPECT_EQ(other.code(), 0) << other.err();
  expect_sound(scratch / "results");
  expect_nothing_half_written(scratch / "results");
  const std::string of_both = text(scratch / "results/results.jsonl");
  Process third(scratch.path(), run), alone(scratch.path(), run_with({"--store", "alone"}));
  EXPECT_EQ(third.code(), 0);
  EXPECT_THAT(third.err(), HasSubstr("0 runs done, 5 found"));
  EXPECT_EQ(text(scratch / "results/results.jsonl"), of_both);  // whole before it
  EXPECT_EQ(alone.code(), 0);
  expect_same_results(scratch / "alone", scratch / "results");
}

TEST(FaultCases, ReportsAtOnceLeaveAWholeOne) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", analysed_case());
  ASSERT_EQ(Process(scratch.path(), run).code(), 0);
  const std::vector<std::string> report{"report", "-o", "report", "case.toml"};
  Process alone(scratch.path(), {"report", "-o", "alone", "case.toml"});
  ASSERT_EQ(alone.code(), 0) << alone.err();
  {
    Process one(scratch.path(), report), other(scratch.path(), report), third(scratch.path(), report);
    for (Process* each : {&one, &other, &third}) EXPECT_EQ(each->code(), 0) << each->err();
  }
  const auto files = [&](const char* folder) {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(scratch / folder)) all.push_back(entry.path().filename());
    std::ranges::sort(all);
    return all;
  };
  EXPECT_EQ(files("report"), files("alone"));
  EXPECT_EQ(text(scratch / "report/verification.md"), text(scratch / "alone/verification.md"));
  for (const auto& entry : fs::directory_iterator(scratch.path()))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".unfinished")) << entry.path();
}

// Of one case a report has fewer tables than of two: what is listed is what stands, whoever came last.
TEST(FaultCases, ReportsOfTwoStoresAtOnceLeaveOneOfThem) {
  const ScratchFolder scratch;
  written(scratch / "small.toml", small_case());
  written(scratch / "large.toml",
          std::regex_replace(analysed_case(), std::regex("name = \"small\""), "name = \"large\""));
  const auto of = [&](const std::string& which, const std::string& directory) {
    return std::vector<std::string>{"report", "--store", which, "-o", directory, which + ".toml"};
  };
  for (const char* which : {"small", "large"}) {
    ASSERT_EQ(Process(scratch.path(), {"run", which + std::string(".toml"), "--untimed", "--store", which}).code(), 0);
    ASSERT_EQ(Process(scratch.path(), of(which, which + std::string("-alone"))).code(), 0);
  }
  const auto files = [&](const std::string& folder) {
    std::vector<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(scratch / folder))
      if (entry.is_regular_file()) all.push_back(fs::relative(entry.path(), scratch / folder).string());
    std::ranges::sort(all);
    return all;
  };
  const auto small = files("small-alone"), large = files("large-alone");
  ASSERT_NE(small, large);
  for (int i = 0; i < 8; ++i) {
    {
      Process one(scratch.path(), of("small", "both")), other(scratch.path(), of("large", "both"));
      EXPECT_EQ(one.code(), 0) << one.err();
      EXPECT_EQ(other.code(), 0) << other.err();
    }
    const bool is_small = text(scratch / "both/report.md").find("| large") == std::string::npos;
    EXPECT_EQ(files("both"), is_small ? small : large) << i;
    for (const char* file : {"verification.md", "data/records.csv", "data/results.jsonl"})
      EXPECT_EQ(text(scratch / ("both/" + std::string(file))),
                text(scratch / ((is_small ? "small-alone/" : "large-alone/") + std::string(file))))
          << file << i;
  }
}

// 82^3 cubes of degree 1: nearly two million degrees of freedom, whose factor takes a terabyte.
std::string large_case(const std::string& cells = "[82, 82, 82]") {
  std::string large = small_case();
  const auto replace = [&](const std::string& what, const std::string& by) {
    large.replace(large.find(what), what.size(), by);
  };
  replace("kind = \"cylinder\"\nradius = 0.05\nlength = 0.2", "kind = \"box\"\nsize = [0.1, 0.1, 0.2]");
  replace("degree = 2\ncells = [1, 2]", "degree = 1\ncells = " + cells);
  replace("finer = { degree = 3, cells = [1, 2] }", "finer = { degree = 2, cells = [42, 42, 42] }");
  replace("coarser = { degree = 2, cells = [1, 2] }", "coarser = { degree = 1, cells = [60, 60, 60] }");
  replace("cells = [[1, 2]]", "cells = [[1, 1, 2]]");
  return large;
}

std::function<void()> with_addresses_for([[maybe_unused]] rlim_t gigabytes) {
#ifdef MB_SANITIZED  // which takes terabytes of addresses itself
  return [] {};
#else
  return [space = gigabytes << 30] {
    const rlimit limit{space, space};
    ::setrlimit(RLIMIT_AS, &limit);  // what is allocated all the same fails at once
  };
#endif
}

constexpr const char* refusal = "out of memory: takes about [0-9.e+]+ GB of memory and [0-9.]+ GB are there";

TEST(FaultCases, WhatIsBeyondMemoryIsRefusedBeforeItIsAllocated) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", large_case());
  for (const std::vector<std::string>& words : {run, {"modes", "case.toml"}, run_with({"--jobs", "2"})}) {
    Process process(scratch.path(), words, with_addresses_for(16));
    EXPECT_EQ(process.code(), 3) << words.front();
    EXPECT_THAT(process.err(), ::testing::ContainsRegex(std::string("small · [^\n]*") + refusal)) << words.front();
    EXPECT_THAT(process.err(), Not(::testing::ContainsRegex("(^|\n)out of memory"))) << "of which case?";
  }
  EXPECT_FALSE(fs::exists(scratch / "results/truth"));
}

// What has been stored must be read, and marked, all the same: 5000 samples of four truths and their marks.
TEST(FaultCases, StoredTruthsBeyondMemoryAreRefusedBeforeTheyAreRead) {
#ifdef MB_SANITIZED
  GTEST_SKIP() << "the address sanitizer takes terabytes of addresses";
#endif
  const ScratchFolder scratch;
  std::string all = small_case();
  const std::string rate = "samples_per_second = 200";
  written(scratch / "case.toml", all.replace(all.find(rate), rate.size(), "samples_per_second = 50000"));
  Process whole(scratch.path(), run);
  ASSERT_EQ(whole.code(), 0) << whole.err();
  fs::remove_all(scratch / "results/records");
  Process process(scratch.path(), run, with_addresses_for(1));
  EXPECT_EQ(process.code(), 3);
  EXPECT_THAT(process.err(), ::testing::ContainsRegex(std::string("small · failed: ") + refusal));
  EXPECT_THAT(process.err(), Not(HasSubstr("[1/4]")));
  EXPECT_LT(process.most_memory(), whole.most_memory() / 2);
}

// 24,000 degrees of freedom fit 3 GB, but not with the Lanczos vectors of thousands of modes.
TEST(FaultCases, ModesBeyondMemoryAreRefusedBeforeTheyAreAllocated) {
#ifdef MB_SANITIZED
  GTEST_SKIP() << "the address sanitizer takes terabytes of addresses";
#endif
  const ScratchFolder scratch;
  written(scratch / "case.toml", large_case("[19, 19, 19]"));
  Process process(scratch.path(), {"modes", "case.toml", "--count", "4096"}, with_addresses_for(3));
  EXPECT_EQ(process.code(), 3);
  EXPECT_THAT(process.err(), ::testing::ContainsRegex(refusal));
}

// Threads of the BLAS that find no memory to begin with wait for it for good: nobody may wait for them. What there is
// no room for is refused, or an allocation fails before that is asked: either is said. Between these sizes there is
// one, about 618 MB, where a library finds none before the program begins, and the loader ends it.
TEST(FaultCases, HardlyAnyMemoryEndsTheProgramAllTheSame) {
#ifdef MB_SANITIZED
  GTEST_SKIP() << "the address sanitizer takes terabytes of addresses";
#endif
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  for (const rlim_t megabytes : {560, 600, 640, 700}) {
    Process process(scratch.path(), run, [megabytes] {
      ::unsetenv("OPENBLAS_NUM_THREADS");
      const rlimit limit{megabytes << 20, megabytes << 20};
      ::setrlimit(RLIMIT_AS, &limit);
    });
    ASSERT_TRUE(process.ends_within(120)) << megabytes;  // a run takes three seconds
    EXPECT_EQ(process.code(), 3) << megabytes << process.err();
    EXPECT_THAT(process.err(), ::testing::ContainsRegex("(small · failed|modalbench: run): out of memory[:,] "
                                                        "(takes about )?[^\n]*[0-9] [kMG]B"))
        << megabytes;
    expect_sound(scratch / "results");
    expect_nothing_half_written(scratch / "results");
    EXPECT_FALSE(fs::exists(scratch / "results/truth")) << megabytes;
  }
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

}  // namespace
}  // namespace mb
