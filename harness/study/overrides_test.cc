#include "harness/study/overrides.h"

#include <gmock/gmock.h>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene overridden(const std::vector<std::string>& assignments, const std::string& words_of_case = small_case()) {
  const ScratchFolder scratch;
  const Vocabulary words = default_catalogue().vocabulary();
  return Overrides(assignments, words).applied(read_toml(written(scratch / "small.toml", words_of_case), words));
}

std::string complaint(const std::vector<std::string>& assignments, const std::string& words_of_case = small_case()) {
  try {
    overridden(assignments, words_of_case);
  } catch (const CaseErrors& errors) {
    return errors.what();
  }
  return "";
}

std::string complaint_of(const char* case_file, const std::vector<std::string>& assignments) {
  const Vocabulary words = default_catalogue().vocabulary();
  const Scene scene = read_toml(fs::path(MB_SOURCE_DIR "/cases") / case_file, words);
  try {
    Overrides(assignments, words).applied(scene);
  } catch (const CaseErrors& errors) {
    return errors.what();
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

TEST(OverridesTest, UnknownKeysWithTheNearestOne) {
  const std::string all = complaint({"modal.mode=4", "modal.modes=4", "novalue", "modal.methods", "modal.modes=5"});
  EXPECT_THAT(all, HasSubstr("--set:1:1: error: unknown key 'modal.mode'"));
  EXPECT_THAT(all, HasSubstr("did you mean 'modal.modes'?"));
  EXPECT_THAT(all, HasSubstr("unknown key 'novalue'"));
  EXPECT_THAT(all, HasSubstr("'modal.methods' has no value"));
  EXPECT_THAT(all, HasSubstr("--set:5:1: error: 'modal.modes' is set twice"));
}

TEST(OverridesTest, EveryWrongValueAtOnceWhereItWasTyped) {
  const std::string all =
      complaint({"modal.methods=eigenmode", "modal.modes=-1", "rival.degrees=9", "rival.cells=1y2"});
  EXPECT_THAT(all, HasSubstr("small --set:1:15: error: unknown reduced method 'eigenmode'\n"
                             "    1 | modal.methods=eigenmode\n"
                             "      |               ^^^^^^^^^\n"
                             "  help: did you mean 'eigenmodes'?"));
  EXPECT_THAT(all, HasSubstr("small --set:2:13: error: entry 1 of 'modes' in [study] is -1, outside [0, 4096]"));
  EXPECT_THAT(all, HasSubstr("small --set:3:15: error: entry 1 of 'degrees' in [[study.rival]] is 9, outside [1, 4]"));
  EXPECT_THAT(all, HasSubstr("small --set:4:13: error: entry 1 of 'cells' in [[study.rival]] must be an integer"));
}

TEST(OverridesTest, TheLimitsOfCaseFilesHold) {
  const auto refused = [](const std::string& assignment, const std::string& message) {
    EXPECT_THAT(complaint({assignment}), HasSubstr(message)) << assignment;
  };
  refused("rival.cells=256x256x256", "'cells' of a cylinder has 3 entries: must be 2");
  refused("rival.cells=256x256", "degrees of freedom: at most 2000000");
  refused("rival.cells=0x0", "entry 2 of 'cells' is 0");
  refused("modal.modes=4096", "4096 elastic modes: Q2 1x2 of body 'body' has at most 369");
  refused("modal.modes=8,4", "'modes' must ascend: 4 follows 8");
  refused("rival.integrators=exact", "unknown stepping integrator 'exact'");
  refused("rival.integrators=none,newmark", "unknown stepping integrator 'none'");
  refused("study.analyses=none,budget", "unknown analysis 'none'");
  refused("study.analyses=budgte", "did you mean 'budget'?");
  refused("rival.time_steps=1", "outside [1e-7, 0.1] s");
  refused("rival.time_steps=nan", "is nan, outside");
  refused("rival.time_steps=1e999", "must be a number");
  refused("modal.modes=", "must be an integer");
  refused("modal.modes=12345678901234567890", "outside [0, 4096]");
  refused("modal.integrators=newmark", "missing key 'time_steps' in [[study.stepping]]");  // no step is given
  refused("modal.contact_steps=1e-4", "contact_steps");                                    // of scenes with contact
  refused("modal.time_steps=0.01", "'modal.time_steps' needs modal.integrators");
  refused("rival.integrators=central-difference", "missing key 'cells' in [[study.rival]]");
}

TEST(OverridesTest, KeysThatNoContenderTakesAreRefused) {
  EXPECT_THAT(complaint({"rival.relative_tolerances=1e-4"}),
              HasSubstr("small --set:1:27: error: no contender of the study takes 'rival.relative_tolerances'"));
  const std::string both = complaint({"rival.integrators=none", "rival.degrees=2", "modal.integrators=newmark",
                                      "modal.time_steps=0.01", "modal.relative_tolerances=1e-4"});
  EXPECT_THAT(both, HasSubstr("no contender of the study takes 'rival.degrees'"));
  EXPECT_THAT(both, HasSubstr("no contender of the study takes 'modal.relative_tolerances'"));
  EXPECT_THAT(both, ::testing::Not(HasSubstr("takes 'modal.time_steps'")));
  EXPECT_THAT(complaint({"modal.integrators=newmark", "modal.time_steps=0.01", "modal.methods=full", "modal.modes=3"}),
              HasSubstr("no contender of the study takes 'modal.modes'"));
}

TEST(OverridesTest, AnIntegratorListedTwiceIsRefused) {
  EXPECT_THAT(complaint({"rival.integrators=newmark,newmark"}),
              HasSubstr("small --set:1:27: error: 'newmark' is listed twice"));
  EXPECT_THAT(complaint({"modal.time_steps=0.01", "modal.integrators=exact,newmark,exact"}),
              HasSubstr("small --set:2:33: error: 'exact' is listed twice"));
}

// Modes that a dashpot couples are as many and of such analyses as a case file may ask for.
TEST(OverridesTest, TheLimitsOfADashpotHold) {
  EXPECT_THAT(complaint_of("hard/dashpot.toml", {"study.analyses=step-limits"}),
              HasSubstr("dashpot --set:1:16: error: analysis 'step-limits' is of modes one by one"));
}

// It has no place of its own on the command line.
TEST(OverridesTest, WhatTheCaseStatesIsRefusedAtTheWordsThatMakeItWrong) {
  EXPECT_THAT(complaint_of("ball-on-two-by-four.toml", {"study.analyses=none", "rival.cells=2"}),
              HasSubstr("ball-on-two-by-four --set:2:13: error: 'second_cells' has 2 entries, 'cells' 1: one a mesh"));
  EXPECT_THAT(complaint_of("ball-on-two-by-four.toml",
                           {"study.analyses=none", "rival.integrators=newmark", "rival.degrees=2", "rival.cells=2"}),
              HasSubstr("ball-on-two-by-four --set:4:13: error: 'second_cells' has 2 entries, 'cells' 1: one a mesh"));
  std::string steps = "rival.time_steps=0.01";
  for (int i = 1; i < 64; ++i) steps += ",0.01";
  EXPECT_THAT(complaint({"modal.modes=4", steps, "rival.degrees=1,2,3,4", "rival.cells=1x1,1x2,1x3,1x4"}),
              HasSubstr("small --set:3:15: error: 1024 rival runs: at most 1000"));
}

// A rival on the bodies' own meshes keeps them, beside one that does not and alone.
TEST(OverridesTest, RivalsOnTheBodiesOwnMeshesTakeNoOther) {
  const std::string own = "[[study.rival]]\nintegrator = \"newmark\"\ntime_steps = [3e-3]\n";
  const Scene beside =
      overridden({"rival.degrees=2", "rival.cells=1x4", "rival.time_steps=1e-3"}, small_case_with("\n" + own));
  ASSERT_EQ(beside.study.rivals.size(), 2u);
  EXPECT_THAT(beside.study.rivals[0].degrees, ElementsAre(2));
  EXPECT_THAT(beside.study.rivals[0].cells, ElementsAre(ElementsAre(1, 4)));
  EXPECT_TRUE(beside.study.rivals[1].degrees.empty());
  EXPECT_TRUE(beside.study.rivals[1].cells.empty());
  for (const Rival& rival : beside.study.rivals) EXPECT_THAT(rival.time_steps, ElementsAre(1e-3));
  std::string alone = small_case();
  const size_t at = alone.find("[[study.rival]]");
  alone.replace(at, alone.find("[[check]]") - at, own);
  for (const char* key : {"rival.degrees=2", "rival.cells=1x4"})
    EXPECT_THAT(complaint({key}, alone),
                HasSubstr("no contender of the study takes '" + std::string(key).substr(0, 11)));
}

// Words that are valid alone, in what is left of the case.
TEST(OverridesTest, NoneAndTheClosedForm) {
  EXPECT_TRUE(overridden({"rival.integrators=none"}).study.rivals.empty());
  EXPECT_TRUE(overridden({"study.analyses=none"}).study.analyses.empty());
  EXPECT_THAT(overridden({"study.analyses=budget"}).study.analyses, ElementsAre("budget"));
  EXPECT_TRUE(overridden({"modal.integrators=newmark", "modal.time_steps=0.01"}).study.methods.empty());
  const Scene both = overridden({"modal.integrators=exact,newmark", "modal.time_steps=0.01", "modal.methods=linear"});
  EXPECT_THAT(both.study.methods, ElementsAre("linear"));
  ASSERT_EQ(both.study.steppings.size(), 1u);
  EXPECT_THAT(both.study.steppings[0].methods, ElementsAre("linear"));
  EXPECT_TRUE(both.study.steppings[0].modes.empty());
}

// What a study may ask of its scene it may still ask of it when a part of it is replaced.
TEST(OverridesTest, ApplyToEveryCase) {
  const Vocabulary words = default_catalogue().vocabulary();
  const Overrides no_analyses({"study.analyses=none"}, words);
  int n = 0;
  for (const char* folder : {MB_SOURCE_DIR "/cases", MB_SOURCE_DIR "/cases/hard"})
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      const Scene scene = read_toml(entry.path(), words);
      const Scene found = no_analyses.applied(scene);
      EXPECT_TRUE(found.study.analyses.empty()) << entry.path();
      EXPECT_EQ(found.study.methods, scene.study.methods) << entry.path();
      EXPECT_EQ(found.study.rotations, scene.study.rotations) << entry.path();
      ++n;
    }
  EXPECT_GE(n, 60);
}

TEST(OverridesCases, TheSceneStaysAndSoDoItsTruths) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml"}).code, 0);
  const Said said = modalbench(scratch.path(), {"run", "case.toml", "--set", "modal.modes=4,6"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("1 runs done, 3 found"));
  EXPECT_THAT(said.err, ::testing::Not(HasSubstr("truth Q")));
}

}  // namespace
}  // namespace mb
