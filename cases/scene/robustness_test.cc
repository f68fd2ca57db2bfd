// Whatever bytes a file holds: it reads, or every problem is reported. Nothing crashes, hangs or throws anything else.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "cases/scene/case_files.h"

namespace mb {
namespace {

constexpr unsigned seed = 20260;

// Whether the text reads; any exception but CaseErrors escapes and fails the test.
bool reads(const std::string& text) {
  try {
    test::read(text);
    return true;
  } catch (const CaseErrors& errors) {
    EXPECT_FALSE(errors.diagnostics().empty());
    return false;
  }
}

// Cut after whatever line, as the suite's own.
TEST(CaseFileBytes, a_file_that_says_how_it_ends_is_told_from_one_that_was_cut) {
  int n_files = 0;
  for (const char* folder : {".", "hard"})
    for (const auto& entry : std::filesystem::directory_iterator(test::cases_folder() / folder)) {
      if (entry.path().extension() != ".toml") continue;
      const std::string text = test::content(entry.path()), end = "\n[end]\n";
      ASSERT_TRUE(text.ends_with(end)) << entry.path();
      EXPECT_FALSE(reads(text.substr(0, text.size() - end.size()))) << entry.path();
      ++n_files;
    }
  EXPECT_GT(n_files, 60);
  const std::string text = test::content(test::cases_folder() / "hard/dashpot.toml");
  ASSERT_TRUE(reads(text));
  int n_cuts = 0;
  for (std::size_t n = text.find('\n') + 1; n < text.size(); n = text.find('\n', n) + 1, ++n_cuts)
    EXPECT_FALSE(reads(text.substr(0, n))) << text.substr(0, n);
  EXPECT_GT(n_cuts, 100);
}

TEST(CaseFileBytes, every_prefix_reads_or_reports) {
  const std::string text = test::cylinder_text();
  const std::size_t last_check = text.rfind("[[check]]");
  int n_read = 0;
  for (std::size_t n = 0; n < text.size(); ++n) n_read += reads(text.substr(0, n));
  EXPECT_TRUE(reads(text.substr(0, last_check))) << "checks are optional";
  EXPECT_GT(n_read, 0);
  EXPECT_LT(n_read, 200) << "only cuts between checks, in comments and in the last line's end leave a whole case";
}

TEST(CaseFileBytes, flipped_bytes_read_or_report) {
  for (const std::string& text : {test::cylinder_text(), test::contact_text()}) {
    std::mt19937 random(seed);
    int n_read = 0;
    for (int i = 0; i < 2000; ++i) {
      std::string flipped = text;
      for (int k = 0; k <= i % 4; ++k) flipped[random() % text.size()] = static_cast<char>(random() % 256);
      n_read += reads(flipped);
    }
    EXPECT_GT(n_read, 0);     // a digit of a comment
    EXPECT_LT(n_read, 1500);  // far from all
  }
}

TEST(CaseFileBytes, shuffled_lines_read_or_report) {
  const std::string text = test::cylinder_text();
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::mt19937 random(seed);
  int n_read = 0;
  for (int i = 0; i < 2000; ++i) {
    auto changed = lines;
    for (int k = 0; k <= i % 5; ++k) {
      const std::size_t at = random() % changed.size();
      if (random() % 2 == 0) {
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(at));
      } else {
        changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(at), lines[random() % lines.size()]);
      }
    }
    std::string joined;
    for (const auto& line : changed) joined += line + "\n";
    n_read += reads(joined);
  }
  EXPECT_LT(n_read, 1600);
}

TEST(CaseFileBytes, deep_nesting_is_refused_before_the_stack_overflows) {
  std::string dotted;
  for (int i = 0; i < 200000; ++i) dotted += "a.";
  EXPECT_FALSE(reads(dotted + "b = 1\n"));
  EXPECT_FALSE(reads("[" + dotted + "b]\n"));
  EXPECT_FALSE(reads("x = \"\"\"a\"\"\"\"\ny = { " + dotted + "b = 1 }\n")) << "a quote before the closing three";
  EXPECT_FALSE(reads("y = [\"\"\"a\"\"\"\", { " + dotted + "b = 1 }]\n"));
  EXPECT_FALSE(reads("x = " + std::string(100000, '[') + "\n"));
  std::string deepest;  // 16 dots a level, all the levels of inline tables that the parser admits
  for (int i = 0; i < 250; ++i) deepest += "{a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a=";
  EXPECT_FALSE(reads("x = " + deepest + "1" + std::string(250, '}') + "\n"));
}

TEST(CaseFileBytes, dots_in_strings_comments_and_numbers_are_no_nesting) {
  const std::string text = test::cylinder_text();
  EXPECT_TRUE(reads("# ........................................\n" + text));
  EXPECT_TRUE(reads(test::with(text, "squeezed along its axis", "squeezed ..................... along its axis")));
}

TEST(CaseFileBytes, a_megabyte_of_problems_is_reported_in_part) {
  std::string text;
  for (int i = 0; text.size() < 1000000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  try {
    test::read(text);
    FAIL() << "the file reads";
  } catch (const CaseErrors& errors) {
    EXPECT_EQ(errors.diagnostics().size(), 201u);
    EXPECT_EQ(errors.diagnostics()[0].message, "more than 200 problems: the rest is not shown");
  }
}

}  // namespace
}  // namespace mb
