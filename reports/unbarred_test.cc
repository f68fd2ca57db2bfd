#include "reports/unbarred.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

TEST(UnbarredColumns, AreThoseWithNumbersThatHaveNoBar) {
  Finding finding;
  finding.name = "stability-map";
  finding.columns = {{"integrator", ""}, {"dt", "s"}, {"energy", "-"}, {"error", "-"}, {"count", ""}, {"none", "m"}};
  finding.rows = {{"newmark", 0.1, 1.0, 2.0, 3.0, NAN}, {"newmark", 0.2, 1.0, 2.0, 3.0, INFINITY}};
  finding.bars = {{NAN, NAN, NAN, NAN, NAN, NAN}, {NAN, NAN, NAN, 0.0, NAN, NAN}};
  const Sheet sheet = unbarred_columns({finding});
  ASSERT_EQ(sheet.rows.size(), 3u);
  EXPECT_EQ(sheet.rows[0][1].text, "dt");
  EXPECT_NE(sheet.rows[0].back().text, "");
  EXPECT_EQ(sheet.rows[1][1].text, "energy");
  EXPECT_EQ(sheet.rows[1].back().text, "");  // should have one
  EXPECT_EQ(sheet.rows[2][1].text, "error");
  EXPECT_EQ(sheet.rows[2][3].text, "2");
  EXPECT_EQ(sheet.rows[2][4].text, "1");
}

TEST(UnbarredColumns, HaveReasonsOfTheirTable) {
  EXPECT_NE(reason_without_bar("any", "dt"), "");
  EXPECT_NE(reason_without_bar("contact-time", "time"), "");
  EXPECT_EQ(reason_without_bar("budget", "time"), "");
}

}  // namespace
}  // namespace mb
