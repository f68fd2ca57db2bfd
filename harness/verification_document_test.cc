// docs/verification.md is generated (CONTRIBUTING.md): whether it is of the cases as they are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "cases/scene/read_toml.h"
#include "harness/catalogue.h"
#include "harness/metrics/metric.h"
#include "reports/check_cells.h"
#include "reports/render.h"
#include "reports/verification.h"

namespace mb {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of_document() {
  std::ifstream stream(fs::path(MB_SOURCE_DIR) / "docs/verification.md");
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// "| case | profile | what |", later "| tolerance | why |", and at the end that it holds.
bool holds_check(const std::vector<std::string>& lines, const std::string& start, const std::string& bounds) {
  return std::ranges::any_of(lines, [&](const std::string& line) {
    return line.starts_with(start) && line.find(bounds) != std::string::npos && line.ends_with("| holds |");
  });
}

// All stand in it in the standard profile, and those of the quick one in that; hard cases whose quick profile is the
// standard one only once.
std::vector<std::string> profiles_of(const Scene& scene, const fs::path& file) {
  const bool hard = !scene.hard.empty(), quick = hard || std::ranges::count(scene.runs_in, "quick") > 0;
  std::vector<std::string> profiles;
  if (quick) profiles.push_back("quick");
  std::ifstream stream(file);
  bool differs = !hard;
  for (std::string line; !differs && std::getline(stream, line);) differs = line == "[profile.quick]";
  if (differs) profiles.push_back("standard");
  return profiles;
}

TEST(VerificationDocument, SaysThatEveryCheckHolds) {
  const std::vector<std::string> lines = lines_of_document();
  const Vocabulary names = default_catalogue().vocabulary();
  int n_checks = 0;
  for (const char* folder : {"cases", "cases/hard"})
    for (const auto& entry : fs::directory_iterator(fs::path(MB_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".toml") continue;
      const Scene scene = read_toml(entry.path(), names);
      for (const std::string& profile : profiles_of(scene, entry.path()))
        for (const Check& check : read_toml(entry.path(), names, profile).checks) {
          const auto cells = [](auto... cell) { return (("| " + markdown_text(cell) + " ") + ...) + "|"; };
          const std::string start = cells(scene.name, profile, checked(check));
          const std::string bounds = cells(bound(check), check.why);
          EXPECT_TRUE(holds_check(lines, start, bounds))
              << start << " ... " << bounds << "\ndocs/verification.md is out of date: cmake/verification-document";
          ++n_checks;
        }
    }
  EXPECT_GT(n_checks, 1800);
}

// A number that has lost its bar would be held to its bound as if it were exact: no error goes without one. That of
// closed forms, of the same modes or of a flight to the first touch, is rounding.
TEST(VerificationDocument, GivesEveryErrorItsUncertainty) {
  const std::regex row(
      R"(\| [^|]* \| (?:quick|standard) \| ([^|]*): ([a-z-]+) \| [^|]* \| ([^|]*) \| [^|]* \| ([^|]*) \| .*)");
  const std::regex number(R"(\d[\d.]*(?:e-?\d+)?)");
  std::smatch cell;
  int n_errors = 0;
  for (const std::string& line : lines_of_document()) {
    if (!std::regex_match(line, cell, row) || cell.str(1).starts_with("table ")) continue;
    const std::string name = cell.str(2), reference = cell.str(3), uncertainty = cell.str(4);
    if (metric(name).of_answer_alone) {
      EXPECT_EQ(uncertainty, "none: of the answer alone") << line;
      continue;
    }
    const bool closed = reference == "closed form of the same modes" || name == "first-touch";
    EXPECT_TRUE(std::regex_match(uncertainty, number) || (closed && uncertainty == "below the digits shown")) << line;
    ++n_errors;
  }
  EXPECT_GT(n_errors, 400);
}

// Bars that a reason names "bar of 0.2 %", in units of one.
std::vector<double> bars_named(const std::string& why) {
  static const std::regex bar(R"(bar of (\d+(?:\.\d+)?(?:e-?\d+)?)( %| mm| micrometres)?)");
  std::vector<double> bars;
  for (auto at = std::sregex_iterator(why.begin(), why.end(), bar); at != std::sregex_iterator(); ++at) {
    const std::string unit = at->str(2);
    const double one = unit == " %" ? 1e-2 : unit == " mm" ? 1e-3 : unit == " micrometres" ? 1e-6 : 1;
    bars.push_back(std::stod(at->str(1)) * one);
  }
  return bars;
}

// A bound is argued from what was seen and how well that was known: to a factor of two, in one of the profiles.
TEST(VerificationDocument, NamesBarsInReasonsAsTheyAre) {
  const std::regex row(
      R"(\| ([^|]*) \| (?:quick|standard) \| ([^|]*) \| [^|]* \| [^|]* \| [^|]* \| (\d[^|]*) \| [^|]* \| ([^|]*) \|.*)");
  std::map<std::string, std::vector<double>> of_checks;  // by case, what is checked and why
  std::smatch cell;
  for (const std::string& line : lines_of_document())
    if (std::regex_match(line, cell, row))
      of_checks[cell.str(1) + " | " + cell.str(2) + " | " + cell.str(4)].push_back(std::stod(cell.str(3)));
  int n_bars = 0;
  for (const auto& [check, bars] : of_checks)
    for (const double named : bars_named(check)) {
      EXPECT_TRUE(std::ranges::any_of(bars, [&](double bar) { return bar <= 2 * named && named <= 2 * bar; }))
          << check << "\nnames a bar of " << named << " where the table has " << bars.front();
      ++n_bars;
    }
  EXPECT_GT(n_bars, 200);
}

// Likewise of tables: what is no count has a bar, but for a column of bars and the step that a map begins to fail at.
TEST(VerificationDocument, GivesEveryNumberOfATableItsUncertainty) {
  const std::regex row(
      R"(\| [^|]* \| (?:quick|standard) \| table ([^|]*) \| [^|]* \| [^|]* \| [^|]* \| ([^|]*) \| .*)");
  const std::regex known(
      R"(\d[\d.]*(?:e-?\d+)?|below the digits shown|none: counts are exact|none: how a run ends .*)");
  std::smatch cell;
  int n_numbers = 0;
  for (const std::string& line : lines_of_document()) {
    if (!std::regex_match(line, cell, row)) continue;
    const std::string checked = cell.str(1);
    if (checked.ends_with("column bar") || checked.find("column unstable from") != std::string::npos) continue;
    EXPECT_TRUE(std::regex_match(cell.str(2), known)) << line;
    ++n_numbers;
  }
  EXPECT_GT(n_numbers, 700);
}

// "| table | column | unit | numbers | without a bar | why |"
TEST(VerificationDocument, SaysWhyANumberHasNoBar) {
  const std::vector<std::string> lines = lines_of_document();
  const std::regex row(R"(\| ([^|]*) \| ([^|]*) \|.*\| ([^|]*) \|)");
  std::smatch cell;
  int n_columns = 0;
  for (auto line = std::ranges::find(lines, "## Numbers without a bar"); line != lines.end(); ++line) {
    if (!std::regex_match(*line, cell, row) || cell.str(1) == "table" || cell.str(1) == "---") continue;
    EXPECT_NE(cell.str(3), "") << *line;
    ++n_columns;
  }
  EXPECT_GT(n_columns, 20);
}

// Sources of all tests, one after the other.
std::string sources_of_tests() {
  std::string all;
  for (const char* layer : {"cases", "harness", "mechanics", "modal", "reference", "reports"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MB_SOURCE_DIR) / layer)) {
      if (!entry.path().filename().string().ends_with("_test.cc")) continue;
      std::ifstream stream(entry.path());
      all.append(std::istreambuf_iterator<char>(stream), {});
    }
  return all;
}

// A test that changes its row fails where the document does not follow (verified_test.h); one that is gone cannot.
TEST(VerificationDocument, NamesNoTestThatIsGone) {
  const std::vector<std::string> lines = lines_of_document();
  const std::string sources = sources_of_tests();
  const std::regex row(R"(\| (?:\w+/)?(\w+)\.(\w+)(?:/\w+)? \|.*)");
  std::smatch name;
  int n_tests = 0;
  for (auto line = std::ranges::find(lines, "## Of the tests"); line != lines.end(); ++line) {
    if (!std::regex_match(*line, name, row)) continue;
    const std::string test = fmt::format("({}, {})", name.str(1), name.str(2));
    EXPECT_NE(sources.find(test), std::string::npos) << test;
    ++n_tests;
  }
  EXPECT_GT(n_tests, 120);
}

TEST(VerificationDocument, SaysOfWhichCommitsItsResultsAre) {
  const std::regex origin(
      "Made by `modalbench report` from stored results of "
      R"((commit [0-9a-f]{12}|commits [0-9a-f]{12} \([^()]*\)( and [0-9a-f]{12} \([^()]*\))+); nothing here.*)");
  EXPECT_TRUE(std::ranges::any_of(lines_of_document(), [&](const std::string& line) {
    return std::regex_match(line, origin);
  })) << "docs/verification.md is not as cmake/verification-document makes it of committed trees";
}

}  // namespace
}  // namespace mb
