#include "harness/analysis/frequencies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

TEST(Frequencies, AreInEqualRatios) {
  const VectorXd f = frequencies_between(2, 32, 5, VectorXd());
  EXPECT_LT((f - VectorXd{{2, 4, 8, 16, 32}}).norm(), 1e-13);
}

TEST(Frequencies, KeepClearOfResonances) {
  const VectorXd resonances{{4, 4.05, 8.01, 31.9, 100}};  // the first two leave no room between them
  const VectorXd f = frequencies_between(2, 32, 5, resonances);
  for (const double x : f)
    for (const double r : resonances) EXPECT_GE(std::abs(x / r - 1), 0.01 * (1 - 1e-8)) << x << " " << r;
  EXPECT_LT((f - VectorXd{{2, 3.96, 7.9299, 16, 32.219}}).cwiseAbs().maxCoeff(), 1e-12);  // no further than needed
}

TEST(Frequencies, RefuseBadInput) {
  EXPECT_THROW(frequencies_between(0, 1, 5, VectorXd()), std::invalid_argument);
  EXPECT_THROW(frequencies_between(2, 1, 5, VectorXd()), std::invalid_argument);
  EXPECT_THROW(frequencies_between(1, NAN, 5, VectorXd()), std::invalid_argument);
  EXPECT_THROW(frequencies_between(1, 2, 1, VectorXd()), std::invalid_argument);
}

}  // namespace
}  // namespace mb
