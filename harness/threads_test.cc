// Results with two threads of the BLAS in place of one: sums in another order, and what they may change.
#include <algorithm>
#include <cmath>
#include <set>

#include "cases/json/record_json.h"
#include "harness/faults_test.h"
#include "harness/threaded_cases_test.h"

namespace mb {
namespace {

using namespace faults;

// Numbers that are none are the same where both are none.
void expect_near(double a, double b, double tolerance, const std::string& what) {
  EXPECT_EQ(std::isnan(a), std::isnan(b)) << what;
  if (std::isfinite(a) || std::isfinite(b)) {
    EXPECT_NEAR(a, b, tolerance) << what;
  } else if (!std::isnan(a)) {
    EXPECT_EQ(a, b) << what;
  }
}

// The largest finite number of a column: its unit is of no account.
double size_of_column(const Finding& a, size_t j) {
  double largest = 0;
  for (const auto& row : a.rows)
    if (const auto* const value = std::get_if<double>(&row[j]); value && std::isfinite(*value))
      largest = std::max(largest, std::abs(*value));
  return largest;
}

// Of tables; within bars are records and truths, too.
enum class Cells { all, within_bars, texts_and_counts };

void expect_near(const FindingCell& a, const FindingCell& b, double tolerance, const std::string& what) {
  ASSERT_EQ(a.index(), b.index()) << what;
  if (a.index() == 0) {
    EXPECT_EQ(a, b) << what;
  } else {
    expect_near(std::get<double>(a), std::get<double>(b), tolerance, what);
  }
}

// Orders are fitted to logarithms of errors as small as 1e-6 of the motion, which is known to 1e-12 of itself:
// rounding of that moves them by 1e-6.
constexpr double rounding_of_fits = 1e-5;
bool is_fitted(const std::string& column) { return column == "order" || column == "standard error"; }

// Cells of tables, of the largest in their column.
void expect_near(const Finding& a, const Finding& b, double relative, Cells cells) {
  ASSERT_EQ(a.rows.size(), b.rows.size()) << a.name;
  ASSERT_EQ(a.bars.size(), b.bars.size()) << a.name;
  for (size_t i = 0; i < a.rows.size(); ++i)
    for (size_t j = 0; j < a.columns.size(); ++j) {
      if (cells == Cells::texts_and_counts && !a.columns[j].unit.empty()) continue;
      const std::string what = fmt::format("{}, row {}, {}", a.name, i + 1, a.columns[j].name);
      const double allowed = is_fitted(a.columns[j].name) ? std::max(relative, rounding_of_fits) : relative;
      const double tolerance = allowed * size_of_column(a, j);
      expect_near(a.rows[i][j], b.rows[i][j], tolerance, what);
      if (!a.bars.empty()) expect_near(a.bars[i][j], b.bars[i][j], tolerance, "bar of " + what);
    }
}

// Of maps of contact, whose bars tell of rounding: numbers within both bars, those without one and names to rounding;
// neither verdicts nor what is counted or fitted. Rounding decides the class of few cells, at a bound: that one run is
// unstable and the other is not leaves nothing to compare. How many numbers had bars that say something.
size_t expect_within_bars(const Finding& a, const Finding& b, double relative) {
  size_t n = 0, n_reclassed = 0;
  if (a.rows.size() != b.rows.size() || a.bars.size() != b.bars.size() || a.bars.empty()) {
    ADD_FAILURE() << a.name << ": other rows or no bars";
    return n;
  }
  const auto column = [&](const char* name) {
    return static_cast<size_t>(std::ranges::find(a.columns, name, &FindingColumn::name) - a.columns.begin());
  };
  const size_t found = column("found"), verdict = column("verdict"), n_columns = a.columns.size();
  const bool is_map = found < n_columns;
  for (size_t i = 0; i < a.rows.size(); ++i) {
    if (is_map && a.rows[i][found] != b.rows[i][found] && ++n_reclassed) continue;
    for (size_t j = 0; j < n_columns; ++j) {
      const double bars = a.bars[i][j] + b.bars[i][j], largest = size_of_column(a, j);
      const bool has_bar = bars >= 0;
      if (j == verdict || (!is_map && j > 0 && !has_bar)) continue;
      expect_near(a.rows[i][j], b.rows[i][j], relative * largest + (has_bar ? bars : 0),
                  fmt::format("{}, row {}, {}", a.name, i + 1, a.columns[j].name));
      n += has_bar && bars < 0.1;
    }
  }
  EXPECT_LE(20 * n_reclassed, a.rows.size()) << a.name;
  return n;
}

// Displacements, of the largest.
void expect_near(const Trajectory& a, const Trajectory& b, double tolerance, const std::string& what) {
  ASSERT_EQ(a.t.size(), b.t.size()) << what;
  ASSERT_EQ(a.bodies.size(), b.bodies.size()) << what;
  EXPECT_EQ(a.status, b.status) << what;
  for (size_t i = 0; i < a.bodies.size(); ++i) {
    const MatrixXd &u = a.bodies[i].displacement, &v = b.bodies[i].displacement;
    ASSERT_TRUE(u.rows() == v.rows() && u.cols() == v.cols()) << what;
    ASSERT_TRUE(u.allFinite() && v.allFinite() && u.size() > 0) << what;
    EXPECT_LE((u - v).cwiseAbs().maxCoeff(), tolerance * u.cwiseAbs().maxCoeff()) << what;
  }
}

// To rounding, or where steps chosen by an error estimate meet a touch: which are taken is decided by a bit there, and
// two truths are as far apart as either is from the motion. That is what their bars are made of, both of them: no more
// than half of the larger apart.
void expect_near(const Record& a, const Record& b, double rounding, Cells cells) {
  EXPECT_EQ(a.provenance.at("threads"), "1");
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.metric, b.metric);
  EXPECT_EQ(a.status, b.status) << a.metric;
  EXPECT_EQ(a.error_bar.has_value(), b.error_bar.has_value()) << a.metric;
  const double bar = a.error_bar.value_or(0), other = b.error_bar.value_or(0);
  const bool within = cells == Cells::within_bars;
  expect_near(a.value, b.value, rounding + (within ? bar + other : 0), a.metric);
  expect_near(bar, other, rounding + (within ? std::max(bar, other) / 2 : 0), "bar of " + a.metric);
}

// How many answers there were to compare. Truths within bars have steps to 1e-4, whose errors add up over the motion:
// ten of them.
size_t expect_near(const Store& a, const Store& b, double tolerance, Cells cells) {
  const auto findings = a.read_all_findings().findings, others = b.read_all_findings().findings;
  EXPECT_EQ(findings.size(), others.size());
  for (size_t i = 0; i < std::min(findings.size(), others.size()); ++i)
    if (cells == Cells::within_bars)
      EXPECT_GE(expect_within_bars(findings[i], others[i], tolerance), 4u) << findings[i].name;
    else
      expect_near(findings[i], others[i], tolerance, cells);
  size_t n_answers = 0;
  for (const auto& [name, content] : finished(a.directory())) {
    const fs::path file = name;
    if (file.extension() != ".h5") continue;
    const bool truth = file.parent_path() == "truth";
    const auto read = [&](const Store& s) {
      return truth ? s.read_truth(file.stem()) : s.read_trajectory(file.stem());
    };
    expect_near(read(a), read(b), truth && cells == Cells::within_bars ? 1e-3 : tolerance, name);
    ++n_answers;
  }
  return n_answers;
}

// Of free bodies, whose truth needs a mesh fine enough for two threads.
std::string finely_meshed_case() {
  std::string all = analysed_case();
  const std::string coarse_mesh = "finer = { degree = 3, cells = [1, 2] }";
  return all.replace(all.find(coarse_mesh), coarse_mesh.size(), "finer = { degree = 3, cells = [2, 4] }");
}

std::string hard_case(const std::string& name) {
  return text(fs::path(MB_SOURCE_DIR) / "cases/hard" / (name + ".toml"));
}

struct Threaded {
  std::string name, content;
  size_t n_answers;  // at least
  bool analysed;
  double rounding;  // of records: [-] of the truth, [m] or [rad] of bodies of 0.2 m
  Cells cells = Cells::all;
};

class ThreadsCases : public ::testing::TestWithParam<Threaded> {};

// The rounding of some hundred steps, far below every error bar; tables and motions, with differences and times of
// extremes, lose two digits more. A box that falls flat on a stiff layer touches with one sample after another, as
// rounding has it: answers by steps of one size agree to 1e-7, truths and maps as far as their bars go, and what a map
// calls unstable may change. Of hard cases, over some ten thousand steps, 5e-9 was seen, 2e-8 where pairs of modes lie
// 2e-4 apart; their tables hold sizes of rounding itself, but what they count and say is the same.
TEST_P(ThreadsCases, ResultsOnTwoAreTheSameToRoundingAndInTwoProcessesToTheBit) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", GetParam().content);
  for (const std::vector<std::string>& how : {std::vector<std::string>{"--threads", "1", "--store", "1"},
                                              {"--threads", "2", "--store", "2"},
                                              {"--threads", "1", "--jobs", "2", "--store", "again"}}) {
    Process process(scratch.path(), run_with(how));
    EXPECT_EQ(process.code(), 0) << process.err();
  }
  expect_same_results(scratch / "1", scratch / "again", GetParam().n_answers + 5);  // runs, marks of truths
  const auto one = read_records(scratch / "1/results.jsonl").records;
  const auto two = read_records(scratch / "2/results.jsonl").records;
  ASSERT_EQ(one.size(), two.size());
  ASSERT_FALSE(one.empty());
  if (two[0].provenance.at("threads") == "1") GTEST_SKIP() << "a BLAS of one thread";
  for (size_t i = 0; i < one.size(); ++i) expect_near(one[i], two[i], GetParam().rounding, GetParam().cells);
  const Store first(scratch / "1"), second(scratch / "2");
  EXPECT_EQ(!first.read_all_findings().findings.empty(), GetParam().analysed);
  EXPECT_GE(expect_near(first, second, 100 * GetParam().rounding, GetParam().cells), GetParam().n_answers);
}

INSTANTIATE_TEST_SUITE_P(Of, ThreadsCases,
                         ::testing::Values(Threaded{"free", finely_meshed_case(), 7, true, 1e-10},
                                           Threaded{"dashpot", dashpot_case, 7, true, 1e-10},
                                           Threaded{"contact", contact_case, 5, true, 1e-9, Cells::within_bars},
                                           Threaded{"turning", turning_case, 6, false, 1e-10},
                                           Threaded{"collision", collision_case, 4, false, 1e-9, Cells::within_bars},
                                           Threaded{"distorted", hard_case("distorted-mesh"), 7, true, 1e-8,
                                                    Cells::texts_and_counts},
                                           Threaded{"nearly_degenerate", hard_case("nearly-degenerate-bar"), 7, true,
                                                    1e-7, Cells::texts_and_counts}),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace mb
