#include "harness/instruction_counter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "harness/callgrind_dump.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

TEST(InstructionCounter, ReadsDumpsByTheirNames) {
  const ScratchFolder scratch;
  const auto dump = [&](const char* file, const std::string& trigger, const std::string& totals) {
    written(scratch / file, "version: 1\npart: 1\n\ndesc: I1 cache: \ndesc: Trigger: " + trigger +
                                "\n\nevents: Ir\nfn=(1)\n0 12\n" + totals + "\n");
  };
  dump("out.1", "Client Request: rigid", "totals: 1234567");
  dump("out.2", "Client Request: full order", "totals: 98765432109");  // beyond 2^31
  dump("out", "Program termination", "totals: 5");
  const auto [counts, missing] = read_dumps(scratch.path());
  EXPECT_EQ(missing, "");
  ASSERT_EQ(counts.size(), 2u);
  EXPECT_EQ(counts.at("rigid"), 1234567);
  EXPECT_EQ(counts.at("full order"), 98765432109.);
}

// A dump as callgrind 3.19 writes it, cut off anywhere: never a part of the number.
TEST(InstructionCounter, ADumpThatIsCutOffHasNoCount) {
  const std::string head =
      "# callgrind format\nversion: 1\ncreator: callgrind-3.19.0\npid: 6597\ncmd:  ./modalbench\npart: 1\n\n"
      "desc: Timerange: Basic block 0 - 1006\ndesc: Trigger: Client Request: full order\n";
  const std::string dump = head + "\nevents: Ir\nsummary: 0\n\nfn=(2)\n0 8012\n\ntotals: 8030\n";
  EXPECT_EQ(dumped_count(dump).name, "full order");
  EXPECT_EQ(dumped_count(dump).instructions, 8030);
  EXPECT_EQ(dumped_count(dump).problem, "");
  for (std::size_t n = head.size(); n < dump.size(); ++n)
    EXPECT_EQ(dumped_count(dump.substr(0, n)).problem, "a dump of valgrind ends before its total") << n;
  EXPECT_EQ(dumped_count("totals: 8030\n").name, "");
}

TEST(InstructionCounter, ATotalThatCountsNothingIsRefused) {
  const ScratchFolder scratch;
  const std::string head = "desc: Trigger: Client Request: rigid\ntotals: ";
  for (const char* total : {"-5", "inf", "nan", "1e9", "1.5", "12a", "", " 12", "18446744073709551616"}) {
    written(scratch / "out.1", head + total + "\n");
    const auto [counts, missing] = read_dumps(scratch.path());
    EXPECT_TRUE(counts.empty()) << total;
    EXPECT_EQ(missing, "the total of a dump of valgrind is no whole number below 2^64") << total;
  }
  EXPECT_EQ(dumped_count(head + "12 34\n").instructions, 12);  // events that were not asked for follow
  EXPECT_EQ(dumped_count(head + "18446744073709551615\n").instructions, 18446744073709551615.);
}

// Any tool of valgrind loads a library of its own into what it runs.
TEST(InstructionCounter, WhatIsNotUnderValgrindJustRuns) {
  const char* const preloaded = std::getenv("LD_PRELOAD");
  EXPECT_EQ(is_counting(), preloaded && std::string(preloaded).find("vgpreload") != std::string::npos);
  int n = 0;
  counted("once", [&] { ++n; });
  EXPECT_EQ(n, 1);
}

// Whether valgrind is there or not: no program, no counts, and a reason.
TEST(InstructionCounter, SaysWhyThereAreNone) {
  const InstructionCounts none = count_instructions("/nonexistent/modalbench", {"count", "x"}, 20);
  EXPECT_TRUE(none.by_name.empty());
  EXPECT_NE(none.missing, "");
}

// A program named valgrind that somebody ends, in the place of the real one.
TEST(InstructionCounter, AChildThatIsEndedFromOutsideHasNoResult) {
  const ScratchFolder scratch;
  written(scratch / "valgrind", "#!/bin/sh\nkill -INT $$\n");
  fs::permissions(scratch / "valgrind", fs::perms::owner_all);
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", (scratch.path().string() + ":" + before).c_str(), 1);
  EXPECT_THROW(count_instructions("/nonexistent/modalbench", {"count", "x"}, 20), std::runtime_error);
  ::setenv("PATH", before.c_str(), 1);
}

}  // namespace
}  // namespace mb
