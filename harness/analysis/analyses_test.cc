// Every analysis through the program, on a clamped orthotropic board of which three modes have damping ratios of their
// own: what must hold between the numbers of its tables, whatever they are.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "reports/unbarred.h"

namespace mb {
namespace {

constexpr const char* board = R"(schema = 1
name = "board"
title = "t"
purpose = "p"
source = "s"
[time]
duration = 0.2
frame_rate = 60
samples_per_second = 3840
[[body]]
name = "board"
shape = { kind = "box", size = [0.02, 0.05, 0.3] }
[body.material]
density = 400
[body.material.orthotropy]
youngs_moduli = [0.8e6, 0.5e6, 11e6]
poissons_ratios = [0.02, 0.02, 0.3]
shear_moduli = [0.05e6, 0.7e6, 0.7e6]
[body.damping]
alpha = 0.5
beta = 1e-5
ratios = [0.02, 0.01, 0.03]
[[body.support]]
kind = "fixed"
face = "z-min"
[body.resolution]
degree = 2
cells = [1, 1, 6]
[[load]]
name = "push"
history = { kind = "step" }
[[load.traction]]
body = "board"
face = "x-max"
pressure = 10
[[probe]]
name = "tip"
body = "board"
point = [0, 0, 0.15]
direction = [1, 0, 0]
[truth]
relative_tolerance = 1e-5
finer = { degree = 2, cells = [1, 2, 12] }
coarser = { degree = 2, cells = [1, 1, 8] }
[study]
methods = ["eigenmodes", "static-correction"]
modes = [4, 16, 48]
analyses = ["budget", "step-limits", "aliasing", "frequency-response", "damping", "mode-amplitudes", "probe-extremes"]
[[study.stepping]]
integrator = "newmark"
methods = ["eigenmodes"]
modes = [16]
time_steps = [1e-3]
[[study.stepping]]
integrator = "explicit-euler"
methods = ["eigenmodes"]
modes = [4]
time_steps = [1e-3, 1e-5]
)";

struct Row {
  const Finding* table;
  const std::vector<FindingCell>* cells;
  size_t index(const std::string& column) const {
    for (size_t i = 0; i < table->columns.size(); ++i)
      if (table->columns[i].name == column) return i;
    throw std::out_of_range("no column '" + column + "' in " + table->name);
  }
  const FindingCell& operator[](const std::string& column) const { return cells->at(index(column)); }
  double bar(const std::string& column) const {
    return table->bars.at(static_cast<size_t>(cells - table->rows.data())).at(index(column));
  }
  double number(const std::string& column) const { return std::get<double>((*this)[column]); }
  std::string text(const std::string& column) const { return std::get<std::string>((*this)[column]); }
};

class AnalysesCases : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const ScratchFolder scratch;
    written(scratch / "board.toml", board);
    const Said said = modalbench(scratch.path(), {"run", "board.toml", "--untimed"});
    ASSERT_EQ(said.code, 0) << said.err;
    findings() = Store(scratch / "results").read_all_findings().findings;
  }
  static std::vector<Finding>& findings() {
    static std::vector<Finding> all;
    return all;
  }
  static std::vector<Row> rows(const std::string& name) {
    std::vector<Row> all;
    for (const Finding& finding : findings())
      if (finding.name == name)
        for (const auto& cells : finding.rows) all.push_back({&finding, &cells});
    if (all.empty()) ADD_FAILURE() << "no rows in a table " << name;
    return all;
  }
};

TEST_F(AnalysesCases, PartsOfTheBudgetAddUpAsVectors) {
  const auto run = [](const Row& row) { return row.text("integrator") + " " + row.text("setting"); };
  for (const char* norm : {"M norm", "K norm"}) {
    std::map<std::string, double> squares, totals;
    for (const Row& row : rows("budget")) {
      const double part = row.number(norm);
      if (row.text("part") == "total")
        totals[run(row)] = part;
      else if (!std::isnan(part))
        squares[run(row)] += part * part;
    }
    for (const Row& row : rows("budget-cross-terms")) squares[run(row)] += row.number(norm);
    EXPECT_FALSE(totals.empty());
    for (const auto& [name, total] : totals) {
      EXPECT_GT(total, 0) << name;
      EXPECT_NEAR(squares[name], total * total, 1e-9 * total * total) << name << " " << norm;
    }
  }
}

TEST_F(AnalysesCases, StepLimitsAreThoseOfTheory) {
  for (const Row& row : rows("step-limits"))
    if (row.number("dt formula") > 0) {
      EXPECT_NEAR(row.number("measured / formula"), 1, 1e-6) << row.text("scheme");
    }
  for (const Row& row : rows("step-limit-runs"))
    EXPECT_EQ(row.text("verdict"), "confirmed") << row.text("system") << row.text("scheme");
  double runs = 0;
  for (const Row& row : rows("step-limit-summary")) {
    EXPECT_EQ(row.number("confirmed"), row.number("runs")) << row.text("system and scheme");
    EXPECT_EQ(row.number("not confirmed"), 0) << row.text("system and scheme");
    if (row.text("system and scheme") == "all") continue;
    runs += row.number("runs");
  }
  EXPECT_EQ(runs, static_cast<double>(rows("step-limit-runs").size()));
  EXPECT_EQ(rows("step-limit-summary").back().number("runs"), runs);
}

// A mesh moves a frequency, and the limit with it; that of full order is the mesh's own.
TEST_F(AnalysesCases, StepLimitsOfModesHaveTheBarsOfTheirMesh) {
  for (const Row& row : rows("step-limits"))
    if (row.text("system") == "reduced") {
      const double of_omega = row.bar("omega deciding") / row.number("omega deciding");
      EXPECT_GT(of_omega, 1e-6);
      EXPECT_LT(of_omega, 0.5);
      EXPECT_GT(row.bar("omega max"), 0);
      if (row.number("dt measured") > 0 && std::isfinite(row.number("dt measured"))) {
        EXPECT_LT(row.bar("dt measured") / row.number("dt measured"), 2.1 * of_omega) << "of 1/omega^2, and no more";
      }
      if (row.text("scheme") == "central-difference" && row.number("zeta") < 0.1) {
        EXPECT_NEAR(row.bar("dt measured") / row.number("dt measured"), of_omega, of_omega * of_omega)
            << "1/(1 + x) - 1 is -x but for x^2";
      }
    } else if (row.number("dt measured") > 0 && std::isfinite(row.number("dt measured"))) {
      EXPECT_LT(row.bar("dt measured") / row.number("dt measured"), 2e-9) << "of the search alone";
    }
}

TEST_F(AnalysesCases, EveryModeIsDampedAsTheSceneAsks) {
  const std::vector<double> ratios{0.02, 0.01, 0.03};
  for (const Row& row : rows("damping")) {
    const auto i = static_cast<size_t>(row.number("mode")) - 1;
    const double omega = 2 * pi * row.number("frequency");
    const double asked = i < ratios.size() ? ratios[i] : 0.5 / (2 * omega) + 1e-5 * omega / 2;
    for (const char* column : {"zeta asked", "zeta full", "zeta reduced", "zeta by decay"})
      if (const double zeta = row.number(column); !std::isnan(zeta)) {
        EXPECT_NEAR(zeta, asked, 1e-7 * asked) << column << " " << i;
      }
    EXPECT_LT(row.number("coupling"), 1e-8);
  }
}

TEST_F(AnalysesCases, StepsDampAsTheirSchemesSayAndExplicitEulerTooLittle) {
  const std::vector<Row> all = rows("damping-of-steps");
  EXPECT_EQ(all.size(), 8u * 3);  // 8 of 16 modes; newmark and two steps of explicit Euler
  for (const Row& row : all) {
    const std::string what = row.text("integrator") + " mode " + std::to_string(row.number("mode"));
    EXPECT_NEAR(row.number("zeta of run"), row.number("zeta of scheme"), 1e-8) << what;
    EXPECT_NEAR(row.number("difference"), row.number("zeta of scheme") - row.number("zeta asked"), 1e-15) << what;
    if (row.text("integrator") == "newmark")
      EXPECT_GT(row.number("zeta of scheme"), 0) << what;
    else
      EXPECT_LT(row.number("difference"), 0) << what;
  }
  EXPECT_EQ(all.front().number("mode"), 1);
  EXPECT_GE(all.back().number("mode"), 16);
}

TEST_F(AnalysesCases, FrequencyResponsesConvergeAndPeakAtTheFirstMode) {
  double previous = 1;
  for (const Row& row : rows("frequency-response-error")) {
    EXPECT_LT(row.number("error"), previous * 1.0001);  // r ascends, each without and with correction
    if (row.text("contender") == "static-correction") previous = row.number("error");
  }
  EXPECT_LT(previous, 1e-5);
  const double first = rows("mode-amplitudes").front().number("frequency");
  for (const Row& row : rows("frequency-response-peaks"))  // displacement peaks at f sqrt(1 - 2 zeta^2), zeta = 0.02
    EXPECT_NEAR(row.number("frequency"), first * std::sqrt(1 - 2 * 0.02 * 0.02), 1e-4 * first);
}

// As far as the mesh moves the first frequency, and a height in proportion to its compliance, 1/f^2.
TEST_F(AnalysesCases, PeaksOfFrequencyResponsesHaveBarsOfTheMesh) {
  const Finding& peaks = *rows("frequency-response-peaks").front().table;
  ASSERT_EQ(peaks.bars.size(), peaks.rows.size());
  for (size_t i = 0; i < peaks.rows.size(); ++i) {
    const double f = std::get<double>(peaks.rows[i][3]), height = std::get<double>(peaks.rows[i][4]);
    const double of_f = peaks.bars[i][3] / f, of_height = peaks.bars[i][4] / height;
    EXPECT_GT(of_f, 1e-5);
    EXPECT_LT(of_f, 0.3);
    EXPECT_NEAR(of_height, 2 * of_f, 0.5 * of_height);
  }
}

// Whatever follows from the mesh of the body, in the first row: another mesh of the case moves it, by less than half.
TEST_F(AnalysesCases, WhatFollowsFromTheMeshHasABarOfIt) {
  const std::tuple<const char*, const char*> told[] = {{"damping", "frequency"},
                                                       {"mode-amplitudes", "frequency"},
                                                       {"mode-amplitudes", "fixed force"},
                                                       {"aliasing-modes", "frequency"},
                                                       {"frequency-response", "amplitude"},
                                                       {"frequency-response", "phase"},
                                                       {"frequency-response-error", "error"},
                                                       {"probe-extremes", "static"}};
  for (const auto& [name, column] : told) {
    const Row row = rows(name).front();
    const auto j = static_cast<size_t>(std::ranges::find(row.table->columns, column, &FindingColumn::name) -
                                       row.table->columns.begin());
    ASSERT_EQ(row.table->bars.size(), row.table->rows.size()) << name;
    const double value = std::abs(row.number(column)), bar = row.table->bars.front().at(j);
    EXPECT_TRUE(bar > 0 && bar < 0.5 * value) << name << ", " << column << ": " << value << " +- " << bar;
  }
}

TEST_F(AnalysesCases, FramesOfExactMeansAliasLessAndDroopMore) {
  for (const Row& row : rows("aliasing")) {
    const std::string what = row.text("contender") + " " + row.text("shutter");
    if (row.text("shutter") == "point") {
      EXPECT_EQ(row.number("droop"), 0) << what;
    } else {
      EXPECT_GT(row.number("droop"), 0) << what;
    }
  }
  for (const Row& row : rows("aliasing-claim")) {
    EXPECT_GE(row.number("energy above F/2"), 0);
    EXPECT_LE(row.number("energy above F/2"), 1);
    EXPECT_LE(row.number("aliasing cut modal"), row.number("aliasing full order") * 1.01);
  }
  // What correction adds is the slow motion of the modes cut.
  double plain = NAN;
  for (const Row& row : rows("aliasing")) {
    if (row.text("contender") == "modal, cut at F/2") plain = row.number("low-band error");
    if (row.text("contender") == "static-correction, cut at F/2") {
      EXPECT_LT(row.number("low-band error"), plain) << row.number("frame rate");
    }
  }
}

TEST_F(AnalysesCases, ModesFallAsTheirEnergyForceAndImpulseSay) {
  for (const Row& row : rows("mode-amplitudes")) {
    const double omega = row.number("omega"), force = row.number("fixed force");
    EXPECT_NEAR(row.number("fixed impulse") / row.number("fixed energy"),
                rows("mode-amplitudes").front().number("fixed impulse") /
                    rows("mode-amplitudes").front().number("fixed energy"),
                0.01);  // both 1/omega where damping is light
    EXPECT_GT(force * omega * omega, 0);
  }
  for (const Row& row : rows("mode-amplitude-exponents"))
    EXPECT_NEAR(row.number("exponent"), row.number("theory"), 0.05) << row.text("held fixed");
}

TEST_F(AnalysesCases, ColumnsHaveBarsOrAReason) {
  for (const auto& row : unbarred_columns(findings(), {}).rows)
    EXPECT_NE(row.back().text, "") << row[0].text << ", column " << row[1].text;
}

TEST_F(AnalysesCases, ASuddenPushOvershootsItsStaticValue) {
  for (const Row& row : rows("probe-extremes")) {  // a light oscillator: up to twice, on the side of the push
    EXPECT_GT(row.number("largest/static"), 1.5);
    EXPECT_LT(row.number("largest/static"), 2.1);
  }
}

}  // namespace
}  // namespace mb
