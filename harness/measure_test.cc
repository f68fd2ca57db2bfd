#include "harness/measure.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>

namespace mb {
namespace {

void spin(long n) {
  volatile double sum = 0;
  for (long i = 0; i < n; ++i) sum = sum + 1;
}
void sleep() { usleep(1000); }  // 1 ms

TEST(Measure, TakesTheMedianOfAsManyRunsAsAskedFor) {
  constexpr long n = 200'000;
  int runs = 0;
  const double one = seconds([] { spin(n); });
  const Timing time = measure([&] { spin(++runs == 1 ? 100 * n : n); }, 5, 0);  // the first is an outlier
  EXPECT_GT(time.median, 0);
  EXPECT_LT(time.median, 30 * one);
  EXPECT_EQ(time.repeats, 5);
  EXPECT_EQ(runs % 5, 0);  // once, or anew where a busy machine disturbed it
}

TEST(Measure, GoesOnUntilTheTotalIsReached) {
  const Timing time = measure(sleep, 3, 0.02);
  EXPECT_GT(time.repeats, 3);
  EXPECT_LE(time.repeats, 20);
}

TEST(Measure, WhatDidNotHaveTheProcessorIsTakenAnewAndSaysSo) {
  int runs = 0;
  const Timing time = measure([&] { ++runs, sleep(); }, 5, 0);
  EXPECT_EQ(runs, 15);
  EXPECT_LT(time.busy, 0.5);
}

TEST(Once, HasNoSpread) {
  const Timing time = once(sleep);
  EXPECT_TRUE(std::isnan(time.spread));
  EXPECT_EQ(time.repeats, 1);
}

}  // namespace
}  // namespace mb
