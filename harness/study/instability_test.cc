#include "harness/study/instability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases/contract/status.h"
#include "harness/catalogue.h"

namespace mb {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // growth by theory

Record mark(const char* metric, double value, const char* status = "ok") {
  Record record;
  record.metric = metric;
  record.value = value;
  record.status = status;
  return record;
}

Limit limit_of(const std::vector<Record>& marks, const char* integrator, double growth, double fed = unknown) {
  return kept_limit(marks, default_catalogue().integrator(integrator), {growth, false}, fed);
}

bool is_past(const std::vector<Record>& marks, const char* integrator, double growth = unknown, double fed = unknown) {
  return limit_of(marks, integrator, growth, fed) == Limit::passed;
}

TEST(Instability, OfExplicitStepsIsWhatIsNotFiniteFarOffOrGrowsByTheory) {
  for (const char* scheme : {"central-difference", "symplectic-euler", "explicit-euler"}) {
    EXPECT_TRUE(is_past({mark("strain-error", 0.1), mark("displacement-error", unknown, "not_finite")}, scheme));
    EXPECT_TRUE(is_past({mark("displacement-error", 1001)}, scheme));
    EXPECT_TRUE(is_past({mark("displacement-error", 1.1)}, scheme, 10.1));
    EXPECT_TRUE(is_past({mark("strain-error", 1.1)}, scheme, 10.1));
    EXPECT_FALSE(is_past({mark("displacement-error", 999)}, scheme));
    EXPECT_FALSE(is_past({mark("displacement-error", 1.1)}, scheme, 9.9));
    EXPECT_FALSE(is_past({mark("probe-error", 1001)}, scheme));
  }
}

TEST(Instability, WhatIsUnknownIsSaidOfEveryMark) {
  std::vector<Record> marks{mark("displacement-error", 0.1), mark("strain-error", 0.2)};
  for (const Record& record : marks) EXPECT_FALSE(is_growth_unknown(record));
  name_unknown(marks);
  for (const Record& record : marks) EXPECT_TRUE(is_growth_unknown(record) && record.status == "ok");
}

// Steps without a load show nothing: they are no sound answer, but no proof that growth is seen, either.
TEST(Instability, OfWhatIsNotMovedIsByTheoryAlone) {
  for (const char* scheme : {"central-difference", "symplectic-euler", "explicit-euler"}) {
    EXPECT_EQ(limit_of({mark("displacement-error", 1), mark("strain-error", 1)}, scheme, 1e30),
              Limit::passed_by_theory);
    EXPECT_EQ(limit_of({mark("displacement-error", 0.1)}, scheme, 10.1), Limit::passed_by_theory);
    EXPECT_EQ(limit_of({mark("displacement-error", 0.1)}, scheme, 9.9), Limit::kept);
  }
}

// A body that softens may be right where its steps would grow about rest, one that stays bounded may be lost.
TEST(Instability, OfFiniteDeformationIsSeenAsWellAsForetold) {
  const auto is = [](const char* metric, double value, double growth) {
    const Limit limit = kept_limit({mark("impulse", 2), mark(metric, value)},
                                   default_catalogue().integrator("central-difference"), {growth, true}, unknown);
    EXPECT_NE(limit, Limit::passed_by_theory);
    return limit == Limit::passed;
  };
  EXPECT_TRUE(is("strain-error", 1.1, 10.1));
  EXPECT_TRUE(is("displacement-error", 1.1, 10.1));
  EXPECT_FALSE(is("strain-error", 0.9, 1e30));
  EXPECT_FALSE(is("strain-error", 22, 9.9));
  EXPECT_FALSE(is("strain-error", 22, unknown));
  EXPECT_TRUE(is("displacement-error", 1001, unknown));
}

// What is off by so much without a limit is wrong, and a failure where it is not finite.
TEST(Instability, OfUnconditionallyStableStepsIsNoneWithoutContact) {
  for (const char* scheme : {"newmark", "exact", "sundials"})
    EXPECT_FALSE(is_past({mark("displacement-error", 1001)}, scheme, 99)) << scheme;
}

TEST(Instability, InContactIsEnergyThatNothingBrought) {
  for (const char* scheme : {"newmark", "exact", "sundials", "central-difference"}) {
    EXPECT_TRUE(is_past({mark("impulse", 0.1)}, scheme, unknown, 1.01)) << scheme;
    EXPECT_FALSE(is_past({mark("impulse", 7)}, scheme, unknown, 0.99)) << scheme;
  }
}

TEST(Instability, LeavesNoValue) {
  for (const Limit limit : {Limit::passed, Limit::passed_by_theory}) {
    std::vector<Record> marks{mark("impulse", 0.1), mark("energy-gain", 7)};
    for (Record& record : marks) record.error_bar = 1e9;  // of a value as large
    name_unstable(marks, limit);
    for (const Record& record : marks) {
      EXPECT_TRUE(is_unstable(record.status));
      EXPECT_EQ(record.status == "unstable", limit == Limit::passed);
      EXPECT_TRUE(std::isnan(record.value));
      EXPECT_FALSE(record.error_bar);
    }
  }
}

}  // namespace
}  // namespace mb
