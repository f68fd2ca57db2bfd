// Independent figures of Hertz's impact against mechanics/contact/hertz_motion.h.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/exact_test_table.h"
#include "mechanics/algebra/worse_test.h"
#include "mechanics/contact/hertz.h"
#include "mechanics/contact/hertz_motion.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

// Columns: tau, x, x', force; twelve digits, of which the last is off by up to five: the largest force there is 4.3e-12
// below (5/4)^(3/5).
TEST(HertzImpactVerification, WholeMotion) {
  const auto table = numbers("hertz_nondim.csv");
  ASSERT_EQ(table.size(), 201u);
  double worst = 0;
  for (const auto& row : table) {
    const HertzMotion motion = hertz_motion({1, 1, 1}, VectorXd::Constant(1, row[0]));
    EXPECT_NEAR(motion.approach[0], row[1], 6e-12) << row[0];
    EXPECT_NEAR(motion.rate[0], row[2], 6e-12) << row[0];
    EXPECT_NEAR(motion.force[0], row[3], 6e-12) << row[0];
    worst = worse({worst, std::abs(motion.approach[0] - row[1]), std::abs(motion.rate[0] - row[2]),
                   std::abs(motion.force[0] - row[3])});
  }
  testing::expect_verified(
      {.quantity = "approach, its rate and force of Hertz's impact at 201 times, without units as x'' = -x^(3/2)",
       .reference = "table",
       .source = "another program: hertz_nondim.csv",
       .uncertainty = "5e-12, up to five in the last of its twelve digits",
       .tolerance = 6e-12,
       .why = "The table's last digit is off by up to five: its largest force is 4.3e-12 below (5/4)^(3/5)."},
      worst);
  EXPECT_NEAR(table.back()[0], hertz_peaks({1, 1, 1}).duration, 1e-12);
}

// Columns: a name in two cells, m, R, E*, v, greatest approach, peak force, duration; ten digits.
TEST(HertzImpactVerification, Examples) {
  const auto table = numbers("hertz_examples.csv");
  ASSERT_EQ(table.size(), 3u);
  double worst = 0;
  for (const auto& row : table) {
    ASSERT_EQ(row.size(), 9u);
    const HertzSphere contact{row[3], row[4]};
    const HertzPeaks peaks = hertz_peaks({row[2], hertz_stiffness(contact), row[5]});
    EXPECT_NEAR(peaks.approach, row[6], 1e-9 * row[6]);
    EXPECT_NEAR(peaks.force, row[7], 1e-9 * row[7]);
    EXPECT_NEAR(peaks.duration, row[8], 1e-9 * row[8]);
    worst = worse({worst, std::abs(peaks.approach / row[6] - 1), std::abs(peaks.force / row[7] - 1),
                   std::abs(peaks.duration / row[8] - 1)});
  }
  testing::expect_verified(
      {.quantity = "greatest approach, peak force and duration of three impacts of steel balls, relative",
       .reference = "table",
       .source = "Hertz's impact (Johnson 1985, sect. 11.4) in another program: hertz_examples.csv",
       .uncertainty = "5e-10, the table's ten digits",
       .tolerance = 1e-9,
       .why = "Ten digits of the results, and of masses and moduli, of which they are powers below one."},
      worst);
}

}  // namespace
}  // namespace mb
