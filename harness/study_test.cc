// Runs of whole cases: what names them, what happens when one fails, supports and loads that used to break.
#include <gmock/gmock.h>

#include "cases/json/record_json.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/study/catalogue_test.h"
#include "harness/study/front.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  if (at == std::string::npos) throw std::invalid_argument("no '" + what + "' in the case");
  return text.replace(at, what.size(), by);
}

Said run(const ScratchFolder& scratch, const std::string& content, std::vector<std::string> options = {}) {
  written(scratch / "case.toml", content);
  options.insert(options.begin(), {"run", "case.toml"});
  return modalbench(scratch.path(), options);
}

TEST(StudyCases, TheSamePhysicsUnderAnotherNameOrProfileHasRunsOfItsOwn) {
  const ScratchFolder scratch;
  ASSERT_EQ(run(scratch, small_case()).code, 0);
  const Said other = run(scratch, replaced(small_case(), "name = \"small\"", "name = \"other\""));
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_THAT(other.err, HasSubstr("4 runs done"));
  EXPECT_THAT(other.err, ::testing::Not(HasSubstr("truth Q")));  // the truth is the same: found
  const Said full = run(scratch, small_case(), {"--profile", "full"});
  EXPECT_EQ(full.code, 0) << full.err;
  EXPECT_THAT(full.out, HasSubstr("holds small"));
}

TEST(StudyCases, ABodyHeldByItsFaceRunsWithoutModesToo) {
  const ScratchFolder scratch;
  std::string held = replaced(small_case("2"), "[body.material]",
                              "[[body.support]]\nkind = \"fixed\"\nface = \"z-min\"\n[body.material]");
  held = replaced(held, "[[load.traction]]\nbody = \"body\"\nface = \"z-min\"\ntraction = [0, 0, 400]\n", "");
  held = replaced(held, "modes = [4, 12]", "modes = [0, 4, 12]");
  const Said said = run(scratch, held);
  EXPECT_EQ(said.code, 0) << said.err;
  for (const Record& r : read_records(scratch / "results/results.jsonl").records)
    if (r.metric == "displacement-error") {
      EXPECT_EQ(r.status, "ok");
    }
}

TEST(StudyCases, StiffBodiesUnderANetLoadFly) {
  const ScratchFolder scratch;
  std::string steel = replaced(small_case("1"), "youngs_modulus = 2e4", "youngs_modulus = 2.1e11");
  steel = replaced(steel, "density = 1100", "density = 7850");
  steel = replaced(steel, "[[load.traction]]\nbody = \"body\"\nface = \"z-min\"\ntraction = [0, 0, 400]\n", "");
  steel = replaced(steel, "duration = 0.1\nframe_rate = 60\nsamples_per_second = 200",
                   "duration = 1e-4\nframe_rate = 1e5\nsamples_per_second = 2e5");
  steel = replaced(steel, "{ kind = \"pulse\", duration = 0.1 }", "{ kind = \"pulse\", duration = 5e-5 }");
  steel = replaced(steel, "time_steps = [0.01, 0.005]", "time_steps = [1e-5, 5e-6]");
  const Said said = run(scratch, steel);
  EXPECT_EQ(said.code, 0) << said.err;
}

TEST(StudyCases, ALateShortLoadIsNotSteppedOver) {
  const ScratchFolder scratch;
  const std::string late = small_case("0.9", R"x({ kind = "expression", formula = "exp(-((t-0.06)/0.004)^2)" })x");
  const Said said = run(scratch, late);
  EXPECT_EQ(said.code, 0) << said.err;  // the check compares with the truth: both must see the load
  EXPECT_THAT(said.out, HasSubstr("holds"));
}

TEST(StudyCases, OneCaseThatFailsDoesNotTakeTheOthersWithIt) {
  const ScratchFolder scratch;
  std::string broken = replaced(small_case(), "name = \"small\"", "name = \"broken\"");
  broken = replaced(broken, R"(["static-correction"])", R"(["static-correction", "breaks"])");
  written(scratch / "broken.toml", broken);
  written(scratch / "small.toml", small_case());
  for (int i = 0; i < 2; ++i) {  // and it is not forgotten
    const Said said = modalbench(scratch.path(), {"run", "broken.toml", "small.toml"}, with_a_method_that_breaks());
    EXPECT_EQ(said.code, 3) << said.err;
    EXPECT_THAT(said.out, HasSubstr("holds broken"));
    EXPECT_THAT(said.out, HasSubstr("holds small"));
    EXPECT_THAT(said.err, HasSubstr(i == 0 ? "small · 4 runs done" : "small · 0 runs done"));
  }
}

// Linear elements with every vertex of the lateral face held: only the inner block's corners move.
TEST(StudyCases, AlmostNothingIsLeftToMove) {
  const ScratchFolder scratch;
  std::string stuck =
      replaced(small_case(), "[body.material]", "[[body.support]]\nkind = \"fixed\"\nface = \"side\"\n[body.material]");
  stuck = replaced(stuck, "degree = 2\ncells = [1, 2]", "degree = 1\ncells = [1, 2]");
  stuck = replaced(stuck, "modes = [4, 12]", "modes = [1]");
  stuck = replaced(stuck, "modes = 12", "modes = 1");
  const Said said = run(scratch, stuck);
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("0 failed"));
}

Record timed(const std::string& run, double time, bool once) {
  Record r;
  r.run = run;
  r.contender.method = "full-order";
  r.status = "ok";
  r.metric = "online-time";
  r.value = time;
  if (!once) r.error_bar = 0.01 * time;
  return r;
}
Record marked(const std::string& run, double error, double bar) {
  Record r = timed(run, 0, true);
  r.metric = "displacement-error";
  r.truth = "finer";
  r.value = error;
  r.error_bar = bar;
  return r;
}

TEST(Front, HoldsWhatNoOtherRunBeatsAndWasTimedOnce) {
  std::vector<Record> records;
  const auto add = [&](const std::string& run, double error, double time, bool once) {
    records.push_back(timed(run, time, once));
    records.push_back(marked(run, error, 1e-3));
  };
  add("cheap", 1e-1, 0.1, false);
  add("beaten", 2e-1, 1.0, true);
  add("best", 1e-2, 1.0, true);
  add("below-bar", 5e-4, 2.0, true);
  add("further-below", 1e-4, 9.0, true);  // both count as the bar: the cheaper one decides
  add("within-5-percent", 3e-2, 1.2, false);
  add("no-better-by-its-value", 2.9e-2, 2.0, true);
  EXPECT_THAT(dear_front(records), ::testing::UnorderedElementsAre("best", "below-bar"));
  records.push_back(timed("dear", 4.0, true));  // its bar is less: the first that is sure to be within 1 %
  records.push_back(marked("dear", 9e-3, 5e-4));
  EXPECT_THAT(dear_front(records), ::testing::UnorderedElementsAre("best", "below-bar"));
  std::erase_if(records, [](const Record& r) { return r.run == "below-bar" || r.run == "further-below"; });
  EXPECT_THAT(dear_front(records), ::testing::UnorderedElementsAre("best", "dear"));
  EXPECT_TRUE(dear_front({}).empty());
}

}  // namespace
}  // namespace mb
