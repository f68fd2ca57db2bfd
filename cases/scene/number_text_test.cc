#include "cases/scene/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mb {
namespace {

TEST(NumberText, IsAsPeopleWriteAndReadsBack) {
  EXPECT_EQ(number_text(1e13), "1e13");
  EXPECT_EQ(number_text(1e-6), "1e-6");
  EXPECT_EQ(number_text(0.29), "0.29");
  EXPECT_EQ(number_text(-1e-100), "-1e-100");
  EXPECT_EQ(number_text(12345678901.5), "12345678901.5");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(number_text(std::nan("")), "nan");
  for (const double x : {1 / 3., std::nextafter(1e-7, 0), 1e-7 + 1e-23}) EXPECT_EQ(std::stod(number_text(x)), x);
}

TEST(NumberText, TellsANumberFromTheLimitThatItIsBeyond) {
  EXPECT_EQ(number_beside(1000001, 1e6), "1000001");
  EXPECT_EQ(number_beside(1234567, 1e6), "1.23e6");
  EXPECT_NE(std::stod(number_beside(std::nextafter(1.0, 2), 1)), 1);
  EXPECT_EQ(number_beside(1, 1), "1");
}

TEST(NumberText, BoundsThatAreComputedAreWhatTheyAreShownAs) {
  EXPECT_GT(0.1 / 1e6, 1e-7);
  EXPECT_EQ(nine_digits(0.1 / 1e6), 1e-7);
  EXPECT_EQ(std::stod(number_text(nine_digits(1 / 3e6))), nine_digits(1 / 3e6));
}

}  // namespace
}  // namespace mb
