#include "harness/measure.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace mb {
namespace {

using namespace std::chrono_literals;

TEST(Measure, TakesTheMedianOfAsManyRunsAsAskedFor) {
  int runs = 0;
  const auto work = [&] {
    const auto end = std::chrono::steady_clock::now() + (++runs == 1 ? 20ms : 2ms);  // one run is an outlier
    while (std::chrono::steady_clock::now() < end) {
    }
  };
  const Timing time = measure(work, 5, 0);
  EXPECT_GE(time.median, 2e-3);
  EXPECT_LT(time.median, 15e-3);
  EXPECT_EQ(time.repeats, 5);
  EXPECT_EQ(runs % 5, 0);  // once, or anew where a busy machine disturbed it
}

TEST(Measure, GoesOnUntilTheTotalIsReached) {
  const Timing time = measure([] { std::this_thread::sleep_for(1ms); }, 3, 0.02);
  EXPECT_GT(time.repeats, 3);
  EXPECT_LE(time.repeats, 20);
}

TEST(Measure, WhatDidNotHaveTheProcessorIsTakenAnewAndSaysSo) {
  int runs = 0;
  const Timing time = measure([&] { ++runs, std::this_thread::sleep_for(2ms); }, 5, 0);
  EXPECT_EQ(runs, 15);
  EXPECT_LT(time.busy, 0.5);
}

TEST(Once, HasNoSpread) {
  const Timing time = once([] { std::this_thread::sleep_for(1ms); });
  EXPECT_TRUE(std::isnan(time.spread));
  EXPECT_EQ(time.repeats, 1);
}

}  // namespace
}  // namespace mb
