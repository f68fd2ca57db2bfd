#include "harness/analysis/peak.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

// |1 / (1 - x^2 + 2 i zeta x)| peaks at sqrt(1 - 2 zeta^2) with 1 / (2 zeta sqrt(1 - zeta^2)).
TEST(PeakTest, OfAnOscillator) {
  const double zeta = 0.02;
  int n = 0;
  const Peak peak = highest([&](double x) { return ++n, 1 / std::hypot(1 - x * x, 2 * zeta * x); }, 0.9, 1.1);
  EXPECT_NEAR(peak.at, std::sqrt(1 - 2 * zeta * zeta), 1e-4);
  EXPECT_NEAR(peak.height, 1 / (2 * zeta * std::sqrt(1 - zeta * zeta)), 1e-4 * peak.height);
  EXPECT_LT(n, 22);
}

TEST(PeakTest, AtAnEndWhereTheCurveOnlyRises) {
  EXPECT_NEAR(highest([](double x) { return x; }, 1, 2).at, 2, 4e-4);
  EXPECT_NEAR(highest([](double x) { return -x; }, 1, 2).at, 1, 4e-4);
}

TEST(PeakTest, RefusesBadInput) {
  const auto y = [](double x) { return x; };
  EXPECT_THROW(highest(y, 0, 1), std::invalid_argument);
  EXPECT_THROW(highest(y, 2, 1), std::invalid_argument);
  EXPECT_THROW(highest(y, 1, NAN), std::invalid_argument);
  EXPECT_THROW(highest(y, 1, 2, 0), std::invalid_argument);
}

}  // namespace
}  // namespace mb
