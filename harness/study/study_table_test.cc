// A study as tables, read again: the same study.
#include "harness/study/study_table.h"

#include <gtest/gtest.h>

#include "cases/scene/read_study.h"

namespace mb {
namespace {

const Vocabulary vocabulary{{"eigenmodes", "linear", "full-order"},
                            {"exact", "newmark", "sundials"},
                            {"displacement-error"},
                            {"linear"},
                            {"sundials"},
                            {"newmark", "sundials"},
                            {"budget"}};

// Of a scene of which it is not known whether it has contact, as of one that was read before.
Study read_again(const Study& study) {
  Findings findings("study", "");
  const TomlTable table = document(study_table(study));
  std::optional<Section> no_profile;
  Study again = read_study(Section(table, {}, "study", false, findings), no_profile, {}, vocabulary, {1, 1});
  if (!findings.empty()) throw CaseErrors(findings.found());
  return again;
}

TEST(StudyTable, holds_all_that_the_reader_takes) {
  Study study;
  study.methods = {"eigenmodes", "linear"};
  study.modes = {0, 8};
  study.contact_steps = {1e-3, 1e-4};
  study.analyses = {"budget"};
  study.load_tolerance = 1e-4;
  study.rivals = {{"newmark", {1, 2}, {{1}, {2}}, {0.1}, {}, 3}, {"sundials", {2}, {{4}}, {}, {1e-3}}};
  study.steppings = {{"newmark", {"linear"}, {}, {0.1, 0.2}, {}}};
  const Study again = read_again(study);
  EXPECT_EQ(again.methods, study.methods);
  EXPECT_EQ(again.modes, study.modes);
  EXPECT_EQ(again.contact_steps, study.contact_steps);
  EXPECT_EQ(again.analyses, study.analyses);
  EXPECT_EQ(again.load_tolerance, study.load_tolerance);
  ASSERT_EQ(again.rivals.size(), 2u);
  EXPECT_EQ(again.rivals[0].cells, study.rivals[0].cells);
  EXPECT_EQ(again.rivals[0].time_steps, study.rivals[0].time_steps);
  EXPECT_EQ(again.rivals[0].graded, 3);
  EXPECT_EQ(again.rivals[1].relative_tolerances, study.rivals[1].relative_tolerances);
  EXPECT_EQ(again.rivals[1].graded, 0);
  ASSERT_EQ(again.steppings.size(), 1u);
  EXPECT_EQ(again.steppings[0].time_steps, study.steppings[0].time_steps);
}

TEST(StudyTable, leaves_out_what_a_scene_without_contact_may_not_state) {
  Study study;
  study.methods = {"linear"};
  study.rivals = {{"newmark", {1}, {{1}}, {0.1}, {}}};
  const StudyTable table = study_table(study);
  EXPECT_FALSE(table.fields.contains("contact_steps"));
  EXPECT_FALSE(table.rivals.at(0).contains("graded"));
  study.contact_steps = {2};  // [s]
  EXPECT_THROW(read_again(study), CaseErrors);
}

}  // namespace
}  // namespace mb
