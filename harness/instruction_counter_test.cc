#include "harness/instruction_counter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

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
  const auto counts = read_dumps(scratch.path());
  ASSERT_EQ(counts.size(), 2u);
  EXPECT_EQ(counts.at("rigid"), 1234567);
  EXPECT_EQ(counts.at("full order"), 98765432109.);
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
