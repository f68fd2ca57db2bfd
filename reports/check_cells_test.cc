#include "reports/check_cells.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

// 2 rows of 2 are 2; a ratio of 1.0000001 to hold below 1.001 is not 1.
TEST(CheckCells, CountsAreWholeAndWhatIsCloseToItsBoundHasMoreDigits) {
  CheckResult result{};
  result.measured = true;
  result.check.table = "step-limit-summary";
  result.check.at_least = 2;
  result.value = 2;
  EXPECT_EQ(measured_cell(result).text, "2");
  result.unit = "-";
  EXPECT_EQ(measured_cell(result).text, "2.000000");
  result.value = 3;
  EXPECT_EQ(measured_cell(result).text, "3.00");
}

}  // namespace
}  // namespace mb
