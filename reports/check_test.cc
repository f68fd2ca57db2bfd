#include <gtest/gtest.h>

#include <limits>

#include "cases/contract/status.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

using synthetic::record;
using synthetic::reduced;

Scene scene_with(const Check& check) {
  Scene scene = synthetic::scene();
  scene.checks = {check};
  return scene;
}

Check of_eight_modes() {
  Check check{};
  check.method = "eigenmodes";
  check.metric = "displacement-error";
  check.truth = "finer";
  check.modes = 8;
  check.why = "why";
  return check;
}

Check at_most(double bound) {
  Check check = of_eight_modes();
  check.at_most = bound;
  return check;
}

Check at_least(double bound) {
  Check check = of_eight_modes();
  check.at_least = bound;
  return check;
}

CheckResult result_of(const Check& check, const std::vector<Record>& records) {
  const auto results = check_results({scene_with(check)}, records);
  EXPECT_EQ(results.size(), 1u);
  return results.at(0);
}

std::vector<Record> answer(double value, double bar) {
  return {record("displacement-error", value, bar, reduced("eigenmodes", 8))};
}

TEST(CheckResults, HoldsWhereValueAndBarAreWithinTheBound) {
  EXPECT_TRUE(result_of(at_most(0.02), answer(0.01, 1e-3)).holds);
  EXPECT_TRUE(result_of(at_most(0.02), answer(0.02, 0)).holds);
  EXPECT_TRUE(result_of(at_least(0.02), answer(0.03, 1e-3)).holds);
  EXPECT_TRUE(result_of(at_least(0.02), answer(0.02, 0)).holds);
}

// Where the study runs several couplings of rotation, a check may be of one.
TEST(CheckResults, AreOfTheRotationAskedFor) {
  const auto coupled = [](RotationCoupling rotation) {
    Contender contender = reduced("eigenmodes", 8);
    contender.settings.rotation = rotation;
    return contender;
  };
  const std::vector<Record> records{record("displacement-error", 0.01, 0, coupled(RotationCoupling::coupled)),
                                    record("displacement-error", 30, 0, coupled(RotationCoupling::unstiffened))};
  Check check = at_most(0.02);
  EXPECT_FALSE(result_of(check, records).holds);
  check.rotation = "coupled";
  EXPECT_TRUE(result_of(check, records).holds);
  check.rotation = "unstiffened";
  EXPECT_FALSE(result_of(check, records).holds);
  check.rotation = "rigid";
  EXPECT_EQ(result_of(check, records).status, "no record");
}

// Likewise of several integrators and steps; where none is named closed form answers.
TEST(CheckResults, AreOfTheStepsAskedFor) {
  const auto stepped = [](double time_step) {
    Contender contender = reduced("eigenmodes", 8);
    contender.integrator = "newmark";
    contender.settings.time_step = time_step;
    return contender;
  };
  const std::vector<Record> records{record("displacement-error", 0.01, 0, reduced("eigenmodes", 8)),
                                    record("displacement-error", 0.2, 0, stepped(1e-2)),
                                    record("displacement-error", 0.02, 0, stepped(5e-3))};
  Check check = at_most(0.015);
  EXPECT_TRUE(result_of(check, records).holds);
  check.integrator = "newmark";
  EXPECT_EQ(result_of(check, records).value, 0.2);  // the worst of all steps
  check.time_step = 5e-3;
  EXPECT_EQ(result_of(check, records).value, 0.02);
  check.time_step = 1e-3;
  EXPECT_EQ(result_of(check, records).status, "no record");
  check.integrator = "symplectic-euler";
  check.time_step = {};
  EXPECT_EQ(result_of(check, records).status, "no record");
}

TEST(CheckResults, OfHowRunsEndHoldWhereAllMarksHaveThatStatus) {
  Check check = of_eight_modes();
  check.metric = check.truth = "";
  check.status = "unstable";
  const auto marks = [](const std::string& first, const std::string& second) {
    std::vector<Record> both{record("displacement-error", 0.01, 0, reduced("eigenmodes", 8)),
                             record("strain-error", 0.01, 0, reduced("eigenmodes", 8))};
    both[0].status = first;
    both[1].status = second;
    return both;
  };
  EXPECT_TRUE(result_of(check, marks("unstable", "unstable")).holds);
  EXPECT_TRUE(result_of(check, marks("unstable", "undefined: no contact")).holds);
  for (const auto& [first, second] :
       {std::pair{"unstable", "ok"}, {"ok", "ok"}, {"unstable", "failed: memory"}, {"unstable", unstable_by_theory}}) {
    const CheckResult result = result_of(check, marks(first, second));
    EXPECT_FALSE(result.holds) << first << second;
    EXPECT_TRUE(result.measured) << first << second;
    EXPECT_NE(result.status, "unstable") << first << second;
  }
  EXPECT_EQ(result_of(check, {}).status, "no record");
  EXPECT_FALSE(result_of(check, {}).holds);
}

TEST(CheckResults, OfATablesStatusesHoldWhereAllRowsSayIt) {
  Finding finding = synthetic::finding("cylinder", "long-run", "long-run", {{"integrator", ""}, {"status", ""}});
  const Scene scene = synthetic::scene();
  finding.case_name = scene.name;
  finding.profile = scene.profile;
  finding.rows = {{"exact", "ok"}, {"explicit-euler", "not_finite"}};
  Check check{};
  check.table = "long-run";
  check.column = "status";
  check.status = "not_finite";
  check.why = "why";
  const auto result = [&] { return check_results({scene_with(check)}, {}, {finding}).at(0); };
  EXPECT_FALSE(result().holds);
  EXPECT_EQ(result().status, "ok");
  check.row = "explicit-euler";
  EXPECT_TRUE(result().holds);
  check.row = "newmark";
  EXPECT_EQ(result().status, "no record");
}

TEST(CheckResults, FailsWhereEvenTheNearestValueOfTheBarIsOutside) {
  for (const CheckResult& result :
       {result_of(at_most(0.02), answer(0.022, 1e-3)), result_of(at_least(0.02), answer(0.018, 1e-3)),
        result_of(at_most(1e-4), answer(1e-2, 4e-4))}) {
    EXPECT_FALSE(result.holds);
    EXPECT_TRUE(result.measured);
    EXPECT_TRUE(result.decidable);
  }
}

TEST(CheckResults, CannotTellWhereTheBoundLiesWithinTheErrorBar) {
  for (const CheckResult& result :
       {result_of(at_most(1e-4), answer(5e-5, 4e-4)), result_of(at_most(0.012), answer(0.0078, 0.0078)),
        result_of(at_most(0.02), answer(0.0205, 1e-3)), result_of(at_least(0.02), answer(0.0205, 1e-3)),
        result_of(at_least(0.02), answer(0.0195, 1e-3))}) {
    EXPECT_FALSE(result.decidable) << result.value;
    EXPECT_FALSE(result.holds) << result.value;
    EXPECT_TRUE(result.measured) << result.value;
  }
}

TEST(CheckResults, IsNotMeasuredWithoutRecord) {
  const CheckResult result = result_of(at_most(1), {});
  EXPECT_FALSE(result.measured);
  EXPECT_FALSE(result.holds);
  EXPECT_EQ(result.status, "no record");
}

TEST(CheckResults, AnswersOnlyWithItsOwnMethodMetricTruthModesAndProfile) {
  for (int variant = 0; variant < 6; ++variant) {
    std::vector<Record> records = answer(0.5, 0);
    Record& other = records[0];
    if (variant == 0) other.contender.method = std::string("static-correction");
    if (variant == 1) other.metric = std::string("strain-error");
    if (variant == 2) other.truth = std::string("same_mesh");
    if (variant == 3) other.contender.settings.modes = 16;
    if (variant == 4) other.profile = std::string("full");
    if (variant == 5) other.case_name = std::string("another");
    EXPECT_FALSE(result_of(at_most(1), records).measured) << variant;
  }
}

TEST(CheckResults, AFailedRecordIsNoNumber) {
  std::vector<Record> records = answer(1e-9, 0);
  records[0].status = std::string("no_convergence");
  EXPECT_FALSE(result_of(at_most(1), records).measured);
  EXPECT_EQ(result_of(at_most(1), records).status, "no_convergence");
  records[0].status = std::string("ok");
  records[0].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(result_of(at_most(1), records).holds);
}

TEST(CheckResults, TheWorstBodyDecides) {
  std::vector<Record> records = answer(0.01, 0);
  records[0].subject = std::string("ball");
  records.push_back(answer(0.03, 0)[0]);
  records[1].subject = std::string("plate");
  EXPECT_DOUBLE_EQ(result_of(at_most(0.02), records).value, 0.03);
  EXPECT_FALSE(result_of(at_most(0.02), records).holds);
  EXPECT_DOUBLE_EQ(result_of(at_least(0.02), records).value, 0.01);
}

TEST(CheckResults, AFailureOutweighsWhatIsNotDecidableAndThatWhatHolds) {
  std::vector<Record> records = answer(0.019, 1e-4);  // holds
  records[0].subject = std::string("ball");
  records.push_back(answer(0.015, 0.01)[0]);  // not decidable, though further inside
  records[1].subject = std::string("plate");
  EXPECT_FALSE(result_of(at_most(0.02), records).decidable);
  records.push_back(answer(0.0205, 1e-4)[0]);  // fails
  records[2].subject = std::string("rod");
  records.push_back(answer(0.03, 0.05)[0]);  // not decidable, though further outside
  records[3].subject = std::string("bar");
  EXPECT_TRUE(result_of(at_most(0.02), records).decidable);
  EXPECT_FALSE(result_of(at_most(0.02), records).holds);
}

TEST(CheckResults, StepsDoNotAnswerForTheClosedForm) {
  std::vector<Record> records = answer(0.01, 0);
  records.push_back(record("displacement-error", 0.5, 0, synthetic::stepped("eigenmodes", 8, "newmark", 0.001)));
  EXPECT_DOUBLE_EQ(result_of(at_most(0.02), records).value, 0.01);
  records.erase(records.begin());
  EXPECT_FALSE(result_of(at_most(0.02), records).measured);
}

CheckResult of_table(const std::string& column, const std::string& row, double at_most) {
  Check check{};
  check.table = "damping";
  check.column = column;
  check.row = row;
  check.at_most = at_most;
  const auto results = check_results({scene_with(check)}, {}, synthetic::findings("cylinder-compression"));
  EXPECT_EQ(results.size(), 1u);
  return results.at(0);
}

TEST(CheckResults, OfATableTheWorstRowDecides) {
  EXPECT_TRUE(of_table("zeta full", "", 0.0221).holds);
  EXPECT_FALSE(of_table("zeta full", "", 0.0219).holds);  // 0.022 in row 20
  EXPECT_DOUBLE_EQ(of_table("zeta full", "", 0.03).value, 0.022);
}

TEST(CheckResults, OfATableOneRowByItsFirstCell) {
  EXPECT_TRUE(of_table("zeta full", "3", 0.0204).holds);
  EXPECT_FALSE(of_table("zeta full", "21", 1).measured);
  EXPECT_EQ(of_table("zeta full", "21", 1).status, "no record");
}

TEST(CheckResults, OfATableBarsCountAndItsUnitAndFootingComeAlong) {
  Check check{};
  check.table = "t";
  check.column = "error";
  check.at_most = 0.02;
  Finding finding = synthetic::finding("cylinder-compression", "a", "t", {{"name", ""}, {"error", "m"}});
  finding.rows = {{"x", 0.019}};
  finding.footing = {"the truth", "second route", "as the bars say"};
  const auto result = [&](double bar) {
    finding.bars = {{synthetic::nan, bar}};
    return check_results({scene_with(check)}, {}, {finding}).at(0);
  };
  EXPECT_TRUE(result(5e-4).holds);
  EXPECT_FALSE(result(2e-3).decidable);
  EXPECT_TRUE(result(synthetic::nan).holds);
  EXPECT_FALSE(result(synthetic::nan).has_bar);
  EXPECT_TRUE(result(0).has_bar);
  EXPECT_FALSE(result(std::numeric_limits<double>::infinity()).decidable);
  EXPECT_EQ(result(0).unit, "m");
  EXPECT_EQ(result(0).footing.kind, "second route");
  check.reference = "a book", check.kind = "published";
  EXPECT_EQ(result(0).footing.reference, "a book");
  EXPECT_EQ(result(0).footing.kind, "published");
  EXPECT_EQ(result(0).footing.uncertainty, "as the bars say");
}

TEST(CheckResults, CellsWithoutANumberAndColumnsThatAreMissingAreNotMeasured) {
  EXPECT_FALSE(of_table("zeta asked", "", 1).measured);  // n/a from row 7 on
  EXPECT_EQ(of_table("zeta asked", "", 1).status, "not a number in row 7");
  EXPECT_FALSE(of_table("no such", "", 1).holds);
  EXPECT_EQ(of_table("no such", "", 1).status, "no column 'no such'");
  EXPECT_EQ(of_table("zeta ful", "", 1).status, "no column 'zeta ful': did you mean 'zeta full'?");
}

}  // namespace
}  // namespace mb
