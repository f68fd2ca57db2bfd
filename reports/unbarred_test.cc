#include "reports/unbarred.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/synthetic.h"

namespace mb {
namespace {

TEST(UnbarredColumns, AreThoseWithNumbersThatHaveNoBar) {
  Finding finding;
  finding.name = "stability-map";
  finding.columns = {{"integrator", ""}, {"dt", "s"}, {"energy", "-"}, {"error", "-"}, {"count", ""}, {"none", "m"}};
  finding.rows = {{"newmark", 0.1, 1.0, 2.0, 3.0, NAN}, {"newmark", 0.2, 1.0, 2.0, 3.0, INFINITY}};
  finding.bars = {{NAN, NAN, NAN, NAN, NAN, NAN}, {NAN, NAN, NAN, 0.5, NAN, NAN}};
  const Sheet sheet = unbarred_columns({finding}, {});
  ASSERT_EQ(sheet.rows.size(), 3u);
  EXPECT_EQ(sheet.rows[0][1].text, "dt");
  EXPECT_NE(sheet.rows[0].back().text, "");
  EXPECT_EQ(sheet.rows[1][1].text, "energy");
  EXPECT_EQ(sheet.rows[1].back().text, "");  // should have one
  EXPECT_EQ(sheet.rows[2][1].text, "error");
  EXPECT_EQ(sheet.rows[2][3].text, "2");
  EXPECT_EQ(sheet.rows[2][4].text, "1");
}

// A distance of 0 to a neighbour that shares all it depends on, or that has no such number, is no uncertainty.
TEST(UnbarredColumns, AreThoseWithBarsOfZeroToo) {
  Finding finding;
  finding.name = "budget";
  finding.columns = {{"same", "-"}, {"nothing", "-"}, {"unknown", "-"}};
  finding.rows = {{2.0, 0.0, 2.0}};
  finding.bars = {{0.0, 0.0, INFINITY}};
  const Sheet sheet = unbarred_columns({finding}, {});
  ASSERT_EQ(sheet.rows.size(), 2u);
  EXPECT_EQ(sheet.rows[0][1].text, "same");
  EXPECT_EQ(sheet.rows[1][1].text, "unknown");
}

TEST(UnbarredColumns, HaveReasonsOfTheirTable) {
  EXPECT_NE(reason_without_bar("any", "dt", true), "");
  EXPECT_NE(reason_without_bar("contact-time", "time", true), "");
  EXPECT_EQ(reason_without_bar("budget", "time", false), "");
  EXPECT_NE(reason_without_bar("step-limits", "omega max", false), "");
  EXPECT_EQ(reason_without_bar("step-limits", "omega max", true), "");  // of the modes' rows it has bars
}

TEST(UnbarredColumns, AreMetricsOfRecordsToo) {
  const Contender contender = synthetic::reduced("eigenmodes", 8);
  std::vector<Record> records = {synthetic::record("displacement-error", 0.1, 0.01, contender),
                                 synthetic::record("energy-gain", 1e-9, 0, contender),
                                 synthetic::record("displacement-error", NAN, 0, contender)};
  for (std::size_t i : {1, 2}) records[i].error_bar.reset();
  EXPECT_EQ(unbarred_columns({}, {records[0], records[2]}).rows.size(), 0u);  // one has a bar, one is no number
  const Sheet sheet = unbarred_columns({}, records);
  ASSERT_EQ(sheet.rows.size(), 1u);
  EXPECT_EQ(sheet.rows[0][0].text, "records");
  EXPECT_EQ(sheet.rows[0][1].text, "energy-gain");
  EXPECT_NE(sheet.rows[0].back().text, "");
  records[0].error_bar.reset();
  EXPECT_EQ(unbarred_columns({}, records).rows[0].back().text, "");  // no error goes without
}

}  // namespace
}  // namespace mb
