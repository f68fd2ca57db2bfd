// Analyses of contact through the program, of a ball of jelly that falls on a floor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cases/scene/read_toml.h"
#include "harness/analysis/context_test.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "reports/unbarred.h"

namespace mb {
namespace {

constexpr const char* ball = R"(schema = 1
name = "ball"
title = "t"
purpose = "p"
source = "s"
gravity = [0, 0, -9.81]
[time]
duration = 0.13
frame_rate = 60
samples_per_second = 4800
samples_from = 0.1
[[body]]
name = "ball"
kinematics = "finite"
pose = { position = [0, 0, 0.11] }
[body.shape]
kind = "sphere"
radius = 0.06
[body.material]
youngs_modulus = 1e6
poissons_ratio = 0.3
density = 1100
[body.damping]
beta = 1e-4
[body.resolution]
degree = 2
cells = [1]
[[obstacle]]
name = "floor"
shape = { kind = "half-space" }
[[contact]]
body = "ball"
obstacle = "floor"
stiffness = "auto"
[truth]
relative_tolerance = 1e-4
finer = { degree = 2, cells = [1], graded = 1 }
coarser = { degree = 2, cells = [1] }
[study]
methods = ["eigenmodes", "static-correction"]
modes = [8]
contact_steps = [2e-4]
analyses = ["budget", "amplitude", "contact-stiffness", "contact-stability"]
)";

using Row = std::map<std::string, FindingCell>;
double number(const Row& row, const std::string& column) { return std::get<double>(row.at(column)); }
std::string text(const Row& row, const std::string& column) { return std::get<std::string>(row.at(column)); }

class ContactAnalysesCases : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const ScratchFolder scratch;
    written(scratch / "ball.toml", ball);
    const Said said = modalbench(scratch.path(), {"run", "ball.toml", "--untimed"});
    ASSERT_EQ(said.code, 0) << said.err;
    const Store store(scratch / "results");
    findings() = store.read_all_findings().findings;
    records() = store.read_all_records().records;
  }
  static std::vector<Finding>& findings() {
    static std::vector<Finding> all;
    return all;
  }
  static std::vector<Record>& records() {
    static std::vector<Record> all;
    return all;
  }
  static std::vector<Row> rows(const std::string& name) {
    std::vector<Row> all;
    for (const Finding& finding : findings())
      if (finding.name == name)
        for (const auto& cells : finding.rows) {
          Row& row = all.emplace_back();
          for (size_t j = 0; j < cells.size(); ++j) row[finding.columns[j].name] = cells[j];
        }
    if (all.empty()) ADD_FAILURE() << "no rows in a table " << name;
    return all;
  }
};

TEST_F(ContactAnalysesCases, PartsOfTheBudgetAddUpToTheErrorThatIsMarked) {
  for (const char* norm : {"M norm", "K norm"}) {
    std::map<std::string, double> squares, totals;
    std::set<std::string> parts;
    for (const Row& row : rows("budget")) {
      const double part = number(row, norm);
      if (text(row, "part") == "total") {
        totals[text(row, "method")] = part;
        continue;
      }
      parts.insert(text(row, "part"));
      EXPECT_GT(part, 0) << text(row, "part");
      squares[text(row, "method")] += part * part;
    }
    EXPECT_EQ(parts, (std::set<std::string>{"time stepping", "contact on the surface", "mass of static shapes",
                                            "truncation", "discretisation", "finite strain"}));
    for (const Row& row : rows("budget-cross-terms")) squares[text(row, "method")] += number(row, norm);
    ASSERT_EQ(totals.size(), 2u);
    for (const auto& [method, total] : totals) {
      EXPECT_NEAR(squares[method], total * total, 1e-9 * total * total) << method << " " << norm;
      std::vector<double> errors;
      for (const Record& r : records())
        if (r.contender.method == method && r.truth == "finer" &&
            r.metric == (norm[0] == 'M' ? "displacement-error" : "strain-error"))
          errors.push_back(r.value);
      ASSERT_EQ(errors.size(), 1u);
      EXPECT_NEAR(errors.front(), total, 1e-9 * total) << method << " " << norm;
    }
  }
}

TEST_F(ContactAnalysesCases, LinearTheoryIsTheBetterTheSofterTheBlow) {
  const std::vector<Row> all = rows("amplitude");
  ASSERT_EQ(all.size(), 6u);
  for (size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(text(all[i], "status"), "ok");
    if (i == 0) continue;
    EXPECT_GT(number(all[i], "error of linear"), number(all[i - 1], "error of linear"));
    EXPECT_GT(number(all[i], "largest strain"), number(all[i - 1], "largest strain"));
    EXPECT_NEAR(number(all[i], "speed"), 2 * number(all[i - 1], "speed"), 1e-6 * number(all[i], "speed"));
  }
  EXPECT_LT(std::abs(number(all[0], "linear/finite peak force") - 1), 0.02);  // strains of some per cent
  for (const Row& row : rows("amplitude-exponents")) {
    if (std::isnan(number(row, "expected"))) continue;
    EXPECT_NEAR(number(row, "exponent"), number(row, "expected"), 0.5) << text(row, "grows with");  // over six speeds
  }
  for (const Row& row : rows("amplitude-limits"))
    if (text(row, "passed") == "between them") {
      EXPECT_GT(number(row, "speed"), number(all.front(), "speed"));
      EXPECT_LT(number(row, "speed"), number(all.back(), "speed"));
    }
}

// Of a ball one sample after another touches, in the order that its shape has it: rounding decides nothing.
TEST_F(ContactAnalysesCases, CellsOfTheMapAreStableWithTheirBars) {
  size_t n_stable = 0;
  for (const Finding& map : findings()) {
    if (map.name != "contact-stability" && map.name != "corrected-stability") continue;
    const auto column = [&](const std::string& name) {
      return static_cast<size_t>(std::ranges::find(map.columns, name, &FindingColumn::name) - map.columns.begin());
    };
    ASSERT_EQ(map.bars.size(), map.rows.size());
    for (size_t i = 0; i < map.rows.size(); ++i) {
      if (std::get<std::string>(map.rows[i][column("found")]) != "stable") continue;
      ++n_stable;
      for (const char* error : {"peak force error", "impulse error"})
        EXPECT_LE(std::get<double>(map.rows[i][column(error)]) + map.bars[i][column(error)], 0.05) << error << i;
      EXPECT_LT(map.bars[i][column("energy")], 1e-6) << map.name << i;
    }
  }
  EXPECT_GT(n_stable, 50u);
}

TEST_F(ContactAnalysesCases, NumbersOfAnswersHaveBars) {
  const std::map<std::string, std::set<std::string>> of{
      {"amplitude", {"error of linear", "modal against finite", "peak force", "linear/finite impulse", "duration"}},
      {"contact-stiffness", {"first touch", "peak force", "change of duration", "change of peak force"}},
      {"contact-conditions", {"condition of duration", "condition of peak force"}},
      {"contacts-in-turn", {"duration", "peak force", "error of impulse"}}};
  std::set<std::string> seen;
  for (const Finding& finding : findings()) {
    if (!of.contains(finding.name)) continue;
    seen.insert(finding.name);
    ASSERT_EQ(finding.bars.size(), finding.rows.size()) << finding.name;
    for (size_t j = 0; j < finding.columns.size(); ++j) {
      if (!of.at(finding.name).contains(finding.columns[j].name)) continue;
      for (size_t i = 0; i < finding.rows.size(); ++i)
        EXPECT_EQ(std::isfinite(finding.bars[i][j]), std::isfinite(std::get<double>(finding.rows[i][j])))
            << finding.name << ", " << finding.columns[j].name << ", row " << i;
    }
  }
  EXPECT_EQ(seen.size(), of.size());
}

TEST_F(ContactAnalysesCases, ColumnsHaveBarsOrAReason) {
  for (const auto& row : unbarred_columns(findings(), {}).rows)
    EXPECT_NE(row.back().text, "") << row[0].text << ", column " << row[1].text;
}

// Its truths may be there, made where there was more memory: the mesh itself is asked for here.
TEST(ContactBudgetCases, AFinerMeshBeyondMemoryIsRefusedWithTheEstimate) {
  const ScratchFolder scratch;
  written(scratch / "ball.toml", ball);
  Scene scene = read_toml(scratch / "ball.toml", default_catalogue().vocabulary());
  scene.duration = 0.11;
  scene.truth.finer = {.degree = 4, .cells = {1024}};  // 4e12 unknowns
  try {
    test::analysed("budget", scene);
    ADD_FAILURE() << "a mesh of a thousand terabytes was made";
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("out of memory: takes about"));
  }
}

}  // namespace
}  // namespace mb
