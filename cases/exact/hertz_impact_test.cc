// Independent figures of Hertz's impact against mechanics/contact/hertz_motion.h.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/exact_test_table.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"

namespace mb {
namespace {

// Columns: tau, x, x', force; twelve digits, of which the last is off by up to five: the largest force there is 4.3e-12
// below (5/4)^(3/5).
TEST(HertzImpactVerification, WholeMotion) {
  const auto table = numbers("hertz_nondim.csv");
  ASSERT_EQ(table.size(), 201u);
  for (const auto& row : table) {
    const HertzMotion motion = hertz_motion({1, 1, 1}, VectorXd::Constant(1, row[0]));
    EXPECT_NEAR(motion.approach[0], row[1], 6e-12) << row[0];
    EXPECT_NEAR(motion.rate[0], row[2], 6e-12) << row[0];
    EXPECT_NEAR(motion.force[0], row[3], 6e-12) << row[0];
  }
  EXPECT_NEAR(table.back()[0], hertz_peaks({1, 1, 1}).duration, 1e-12);
}

// Columns: a name in two cells, m, R, E*, v, greatest approach, peak force, duration; ten digits.
TEST(HertzImpactVerification, Examples) {
  const auto table = numbers("hertz_examples.csv");
  ASSERT_EQ(table.size(), 3u);
  for (const auto& row : table) {
    ASSERT_EQ(row.size(), 9u);
    const HertzSphere contact{row[3], row[4]};
    const HertzPeaks peaks = hertz_peaks({row[2], hertz_stiffness(contact), row[5]});
    EXPECT_NEAR(peaks.approach, row[6], 1e-9 * row[6]);
    EXPECT_NEAR(peaks.force, row[7], 1e-9 * row[7]);
    EXPECT_NEAR(peaks.duration, row[8], 1e-9 * row[8]);
  }
}

}  // namespace
}  // namespace mb
