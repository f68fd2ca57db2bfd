#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/analysis/analysis.h"
#include "harness/commands/formulas.h"
#include "harness/commands/paragraph.h"
#include "harness/commands/told_test.h"
#include "harness/commands/usage_error.h"
#include "harness/metrics/definitions.h"
#include "harness/metrics/metric.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/study/overrides.h"

namespace mb {
namespace {

using test::told;
using ::testing::HasSubstr;

test::Told explain(const std::filesystem::path& folder, const std::string& word) {
  return told(folder, [&](const Console& c) { return explain_command({word}, default_catalogue(), c); });
}

TEST(ExplainTest, SaysWhatEachKindOfWordMeans) {
  const ScratchFolder folder;
  const std::pair<const char*, const char*> words[] = {{"displacement-error", "formula: sqrt("},
                                                       {"online-time", "metric [s]"},
                                                       {"static-correction", "Craig 1981"},
                                                       {"newmark", "integrator"},
                                                       {"step-limits", "analysis"},
                                                       {"rod-step", "closed form"},
                                                       {"body.material.density", "kg/m^3"},
                                                       {"density", "kg/m^3"},
                                                       {"load.history.kind", "pulse: A sin^2"},
                                                       {"speed-up", "cheapest full-order run"},
                                                       {"same_mesh", "the contender's own M and K"},
                                                       {"unstable", "past the limit"},
                                                       {"not_finite", "overflows"},
                                                       {"closed form", "the body flies in closed form"},
                                                       {"C2", "judged by: "}};
  for (const auto& [word, told_of_it] : words) {
    const test::Told said = explain(folder.path(), word);
    EXPECT_EQ(said.code, 0) << word;
    EXPECT_THAT(said.out, HasSubstr(told_of_it)) << word;
    EXPECT_EQ(said.err, "") << word;
  }
}

TEST(ExplainTest, AWordOfSeveralMeaningsHasThemAll) {
  const ScratchFolder folder;
  const std::string out = explain(folder.path(), "modes").out;
  EXPECT_THAT(out, HasSubstr("study.modes (key"));
  EXPECT_THAT(out, HasSubstr("check.modes (key"));
}

TEST(ExplainTest, ACaseByNameAndByFile) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "cases");
  written(folder / "cases/small.toml", small_case());
  for (const char* word : {"small", "cases/small.toml"}) {
    const test::Told said = explain(folder.path(), word);
    EXPECT_THAT(said.out, HasSubstr("small (case)")) << word;
    EXPECT_THAT(said.out, HasSubstr("displacement-error against same_mesh at most 0.5")) << word;
  }
  EXPECT_THROW(explain(folder.path(), "missing.toml"), CaseErrors);
}

TEST(ExplainTest, ALimitHasAllItsDigits) {
  const ScratchFolder folder;
  std::string text = small_case();
  const size_t at = text.find("at_most = 0.5");
  ASSERT_NE(at, std::string::npos);
  written(folder / "small.toml", text.replace(at, 13, "at_most = 1.000000001"));
  EXPECT_THAT(explain(folder.path(), "small.toml").out, HasSubstr("at most 1.000000001"));
}

TEST(ExplainTest, AnUnknownWordGetsTheNearest) {
  const ScratchFolder folder;
  try {
    explain(folder.path(), "displacment-error");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'displacement-error'?"));
  }
  EXPECT_THROW(explain(folder.path(), ""), UsageError);
  EXPECT_THROW(explain(folder.path(), "."), UsageError);
}

TEST(ExplainTest, KnowsEveryKeyOfSet) {
  const ScratchFolder folder;
  for (const std::string& key : set_keys()) EXPECT_THAT(explain(folder.path(), key).out, HasSubstr(key + " (key of"));
}

TEST(ExplainTest, ListsEveryWordOnce) {
  const ScratchFolder folder;
  try {
    explain(folder.path(), "zzzqqqqzzzqqqqzzzqqqq");
    FAIL();
  } catch (const UsageError& error) {
    const std::string all = error.what(), words = all.substr(all.find("known: ") + 7);
    std::set<std::string> seen;
    for (size_t at = 0; at < words.size();) {
      const size_t end = std::min(words.find(", ", at), words.size());
      EXPECT_TRUE(seen.insert(words.substr(at, end - at)).second) << words.substr(at, end - at);
      at = end + 2;
    }
    EXPECT_TRUE(seen.contains("same_mesh") && seen.contains("unstable") && seen.contains("closed form"));
  }
}

TEST(DefinitionsTest, EveryMetricHasFormulaUnitAndSource) {
  std::set<std::string> names;
  for (const MeasureDoc& d : measure_docs()) {
    EXPECT_TRUE(names.insert(d.name).second) << d.name;
    for (const std::string& part : {d.unit, d.meaning, d.formula, d.source}) EXPECT_FALSE(part.empty()) << d.name;
  }
  for (const Metric& metric : metric_catalogue()) EXPECT_TRUE(names.contains(metric.name)) << metric.name;
  EXPECT_EQ(meanings().size(), measure_docs().size());
}

TEST(DefinitionsTest, EveryMethodIntegratorAndAnalysisOfOursHasAFormula) {
  const Catalogue catalogue = default_catalogue();
  std::vector<std::string> names;
  for (const auto& method : catalogue.methods) names.push_back(method->name());
  for (const auto& integrator : catalogue.integrators) names.push_back(integrator.name);
  for (const auto& one : analysis_catalogue()) names.push_back(one.name);
  for (const std::string& name : names) EXPECT_FALSE(formula_of(name).formula.empty()) << name;
  EXPECT_TRUE(formula_of("a-method-from-elsewhere").formula.empty());
}

TEST(ParagraphTest, BreaksLinesAndHidesWhatMovesTheCursor) {
  EXPECT_EQ(paragraph("one two three", "- ", "  ", 9), "- one two\n  three\n");
  EXPECT_EQ(paragraph("incomprehensible", "", "  ", 5), "incomprehensible\n");
  EXPECT_EQ(paragraph("\xc3\xa9\xc3\xa9 x", "", "", 4), "\xc3\xa9\xc3\xa9 x\n");  // two letters of two bytes
  EXPECT_THAT(paragraph("a \x1b[31m b", "", ""), ::testing::Not(HasSubstr("\x1b")));
  EXPECT_EQ(paragraph("", "x", ""), "x\n");
}

}  // namespace
}  // namespace mb
