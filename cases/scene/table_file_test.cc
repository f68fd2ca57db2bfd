#include "cases/scene/table_file.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

TEST(TableOfText, KnowsTheLineOfEveryEntry) {
  const TableFile read = table_of_text("\xEF\xBB\xBF# of a shaker\ntime, load\n\n0, 1\r\n+0.5,-2e3\n", "a.csv", 10);
  EXPECT_EQ(read.problem, "");
  EXPECT_EQ(read.table.t, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(read.table.s, (std::vector<double>{1, -2000}));
  EXPECT_EQ(read.lines, (std::vector<int>{4, 5}));
}

TEST(TableOfText, TakesNoNumberForAHeader) {
  for (const char* first : {"nan, nan\n", "inf, x\n"}) {
    const TableFile read = table_of_text(std::string(first) + "0, 1\n1, 2\n", "a.csv", 10);
    EXPECT_TRUE(!read.problem.empty() || read.table.t.size() == 3) << first;
  }
}

TEST(TableOfText, ShowsNothingOfWhatItRefuses) {
  EXPECT_EQ(table_of_text("0, 1\nsecret\n", "a.csv", 10).problem, "line 2 of 'a.csv' is not 't, s', two numbers");
  EXPECT_EQ(table_of_text("0, 1\n1, 20\n2, 3", "a.csv", 10).problem,
            "'a.csv' does not end with a line break: it may be cut");
  EXPECT_EQ(table_of_text("", "a.csv", 10).problem, "'a.csv' has 0 entries: at least 2");
  EXPECT_EQ(table_of_text("0, 1\n", "a.csv", 10).problem, "'a.csv' has 1 entries: at least 2");
  EXPECT_EQ(table_of_text("0,1\n1,1\n2,1\n", "a.csv", 2).problem, "'a.csv' has more than 2 entries");
}

}  // namespace
}  // namespace mb
