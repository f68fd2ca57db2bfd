#include "harness/study/processes.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace mb {
namespace {

TEST(ProcessesTest, TheLargestExitCode) {
  EXPECT_EQ(in_processes(3, [](int) { return 0; }), 0);
  EXPECT_EQ(in_processes(3, [](int i) { return i == 2 ? 1 : 0; }), 1);
}

TEST(ProcessesTest, AnErrorOrASignalCountsAsThree) {
  EXPECT_EQ(in_processes(1, [](int) -> int { throw std::runtime_error("told on stderr"); }), 3);
  EXPECT_EQ(in_processes(2, [](int i) { return i == 1 ? std::raise(SIGKILL) : 0; }), 3);
}

TEST(ProcessesTest, WhatAProcessChangesIsItsOwn) {
  int value = 1;
  in_processes(2, [&](int i) { return value = i, 0; });
  EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace mb
