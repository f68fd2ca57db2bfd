// cases/bad: every wrong file beside the exact text of all its messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "cases/scene/case_files.h"
#include "cases/scene/printable.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

fs::path bad_folder() { return test::cases_folder() / "bad"; }

std::vector<std::string> stems(const std::string& extension) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(bad_folder())) {
    if (entry.path().extension() == extension) out.push_back(entry.path().stem().string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string identifier(const ::testing::TestParamInfo<std::string>& info) {
  std::string out = info.param;
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

class BadCase : public ::testing::TestWithParam<std::string> {};

TEST_P(BadCase, gives_exactly_the_expected_messages) {
  const std::string expected = test::content(bad_folder() / (GetParam() + ".expected"));
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(test::problems(bad_folder() / (GetParam() + ".toml")), expected);
}

TEST_P(BadCase, messages_are_sorted_and_print) {
  try {
    read_toml(bad_folder() / (GetParam() + ".toml"), test::vocabulary());
    FAIL() << "the file reads";
  } catch (const CaseErrors& errors) {
    const auto& found = errors.diagnostics();
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const Diagnostic& a, const Diagnostic& b) {
      return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    }));
    for (const Diagnostic& diagnostic : found) {
      const std::string shown = diagnostic.file + diagnostic.message + diagnostic.excerpt + diagnostic.help;
      EXPECT_EQ(printable(shown, shown.size()), shown);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BadCase, ::testing::ValuesIn(stems(".toml")), identifier);

TEST(BadCaseFolder, holds_pairs_of_at_least_sixty_wrong_files) {
  EXPECT_GE(stems(".toml").size(), 60u);
  EXPECT_EQ(stems(".toml"), stems(".expected"));
}

TEST(BadCaseFolder, no_message_shows_what_a_referenced_file_holds) {
  const std::string messages = test::problems(bad_folder() / "table-files.toml");
  EXPECT_NE(messages.find("secret.csv"), std::string::npos);
  EXPECT_EQ(messages.find("root:x"), std::string::npos);
}

}  // namespace
}  // namespace mb
