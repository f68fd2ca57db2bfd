#include "harness/study/overrides.h"

#include <gmock/gmock.h>

#include "harness/commands/usage_error.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scene overridden(const std::vector<std::string>& assignments) {
  const ScratchFolder scratch;
  const Vocabulary words = default_catalogue().vocabulary();
  return Overrides(assignments, words).applied(read_toml(written(scratch / "small.toml", small_case()), words));
}

std::string complaint(const std::vector<std::string>& assignments) {
  try {
    overridden(assignments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(OverridesTest, ReplaceWhatTheyNameAndNothingElse) {
  const Scene scene = overridden({"modal.methods=eigenmodes,linear", "modal.modes=1,2,3"});
  EXPECT_THAT(scene.study.methods, ElementsAre("eigenmodes", "linear"));
  EXPECT_THAT(scene.study.modes, ElementsAre(1, 2, 3));
  ASSERT_EQ(scene.study.rivals.size(), 1u);
  EXPECT_THAT(scene.study.rivals[0].time_steps, ElementsAre(0.01, 0.005));
}

TEST(OverridesTest, AGridOfIntegratorsAndSteps) {
  const Scene scene = overridden({"modal.integrators=newmark,sundials", "modal.time_steps=1e-3,1e-4",
                                  "modal.relative_tolerances=1e-4", "rival.integrators=none"});
  EXPECT_TRUE(scene.study.rivals.empty());
  ASSERT_EQ(scene.study.steppings.size(), 2u);
  EXPECT_THAT(scene.study.steppings[0].time_steps, ElementsAre(1e-3, 1e-4));
  EXPECT_THAT(scene.study.steppings[1].relative_tolerances, ElementsAre(1e-4));
}

TEST(OverridesTest, EveryProblemAtOnceWithTheNearestWord) {
  const std::string all = complaint(
      {"modal.mode=4", "modal.methods=eigenmode", "modal.modes=-1", "rival.degrees=9", "rival.cells=1y2", "novalue"});
  for (const char* part : {"modal.mode", "modal.modes", "eigenmodes", "-1", "9", "1y2", "novalue"})
    EXPECT_THAT(all, HasSubstr(part));
  EXPECT_THAT(complaint({"modal.integrators=newmark"}), HasSubstr("newmark"));  // no step is given
}

TEST(OverridesCases, TheSceneStaysAndSoDoItsTruths) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml"}).code, 0);
  const Said said = modalbench(scratch.path(), {"run", "case.toml", "--set", "modal.modes=4,6"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("1 runs done, 3 found"));
  EXPECT_THAT(said.err, testing::Not(HasSubstr("truth Q")));
}

}  // namespace
}  // namespace mb
