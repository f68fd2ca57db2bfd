#include "harness/analysis/power_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

TEST(PowerLaw, IsFoundExactly) {
  const VectorXd x = VectorXd::LinSpaced(20, 3, 500);
  for (const double p : {-2.0, -1.0, 0.0, 1.5}) {
    const PowerLaw law = power_law(x, 7 * x.array().pow(p));
    EXPECT_NEAR(law.exponent, p, 1e-13);
    EXPECT_LT(law.standard_error, 1e-13);
    EXPECT_EQ(law.n_points, 20);
    EXPECT_TRUE(agrees(law, p));
    EXPECT_FALSE(agrees(law, p + 0.1));
  }
}

TEST(PowerLaw, StandardErrorIsThatOfLeastSquares) {
  // Logarithms 0, 1, 2, 3 with residuals 0.1 (1, -1, -1, 1), which leave slope and mean as they are.
  const VectorXd x = VectorXd{{0, 1, 2, 3}}.array().exp();
  const VectorXd y = VectorXd{{0.1, 0.9, 1.9, 3.1}}.array().exp();
  const PowerLaw law = power_law(x, y);
  EXPECT_NEAR(law.exponent, 1, 1e-13);
  EXPECT_NEAR(law.standard_error, std::sqrt(0.04 / 2 / 5), 1e-13);
  EXPECT_TRUE(agrees(law, 1.1));  // within two standard errors, 0.126
  EXPECT_FALSE(agrees(law, 1.2));
}

TEST(PowerLaw, LeavesOutWhatHasNoLogarithm) {
  const VectorXd x{{1, 2, 4, 8, 16, 32, 64}}, y{{3, 6, 0, -1, NAN, INFINITY, 192}};
  const PowerLaw law = power_law(x, y);
  EXPECT_EQ(law.n_points, 3);
  EXPECT_NEAR(law.exponent, 1, 1e-13);
  EXPECT_NEAR(law.standard_error, 0, 1e-13);
  EXPECT_TRUE(agrees(law, 1));
}

TEST(PowerLaw, OfTheLeastLeavesOutWhatBendsAway) {
  const VectorXd x{{8, 1, 2, 16, 4, 32}}, straight = 3 * x.array().square();
  VectorXd bent = straight;
  bent(3) = bent(5) = 100;  // of 16 and 32
  EXPECT_NEAR(power_law_of_least(x, bent).exponent, 2, 1e-13);
  EXPECT_EQ(power_law_of_least(x, bent).n_points, 4);
  EXPECT_LT(power_law(x, bent).exponent, 1.5);
  EXPECT_NEAR(power_law_of_least(x, straight).exponent, 2, 1e-13);
  const VectorXd scattered{{40, 3, 1, 90, 30, 150}};  // of 1, 2, 4: 3, 1, 30
  EXPECT_EQ(power_law_of_least(x, scattered).n_points, 6);
  VectorXd gap = bent;
  gap(2) = NAN;  // of 2: the fourth is 16, a bent one
  EXPECT_LT(power_law_of_least(x, gap).exponent, 1.9);
  EXPECT_EQ(power_law_of_least(x.head(3), straight.head(3)).n_points, 3);
  EXPECT_TRUE(std::isnan(power_law_of_least(x.head(2), straight.head(2)).exponent));
}

TEST(PowerLaw, OfNothingIsNone) {
  EXPECT_TRUE(std::isnan(power_law(VectorXd(), VectorXd()).exponent));
  EXPECT_TRUE(std::isnan(power_law(VectorXd{{2}}, VectorXd{{3}}).exponent));
  EXPECT_TRUE(std::isnan(power_law(VectorXd{{2, 4}}, VectorXd{{3, 6}}).exponent));  // nothing tells how well it fits
  EXPECT_TRUE(std::isnan(power_law(VectorXd{{2, 2, 2}}, VectorXd{{3, 4, 5}}).exponent));  // one abscissa
  EXPECT_FALSE(agrees(power_law(VectorXd(), VectorXd()), 1));
  EXPECT_FALSE(agrees({1, 0.3, 9}, 1));  // known too badly to agree with anything
  EXPECT_THROW(power_law(VectorXd(2), VectorXd(3)), std::invalid_argument);
}

}  // namespace
}  // namespace mb
