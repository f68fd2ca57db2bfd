#include "harness/study/plan.h"

#include <gmock/gmock.h>

#include <set>

#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using testing::HasSubstr;

Scene scene_of(const std::string& content) {
  const ScratchFolder scratch;
  return read_toml(written(scratch / "small.toml", content), default_catalogue().vocabulary());
}

TEST(PlanTest, EveryContenderOnceGroupedByMesh) {
  const std::vector<Job> all = jobs(scene_of(small_case()), default_catalogue());
  ASSERT_EQ(all.size(), 4u);  // two mode counts, one mesh at two steps
  std::set<std::string> hashes, labels;
  for (const Job& job : all) hashes.insert(job.hash), labels.insert(job.label);
  EXPECT_EQ(hashes.size(), 4u);
  EXPECT_TRUE(labels.contains("static-correction r=12 exact Q2 1x2")) << testing::PrintToString(labels);
}

TEST(PlanTest, PartsAreDisjointAndTogetherWhole) {
  const std::vector<Job> all = jobs(scene_of(small_case()), default_catalogue());
  std::multiset<std::string> whole, parts;
  for (const Job& job : all) whole.insert(job.hash);
  for (int i = 1; i <= 3; ++i)
    for (const Job& job : part(all, {i, 3})) parts.insert(job.hash);
  EXPECT_EQ(parts, whole);
  EXPECT_EQ(part(all, {7, 9}).size(), 0u);
}

TEST(PlanTest, ShardsAreReadStrictly) {
  const auto shard = parse_shard("2/8");
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->i, 2);
  EXPECT_EQ(shard->n, 8);
  for (const char* wrong : {"", "2", "2/", "/8", "0/8", "9/8", "-1/8", "2/8x", "2/0", " 2/8", "1e0/2", "99999999999/2"})
    EXPECT_FALSE(parse_shard(wrong)) << wrong;
}

// Two machines run a part each; the merged store needs nothing more, and its checks hold.
TEST(PlanCases, MergingIsCopying) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  for (const std::string i : {"1", "2"}) {
    const Said part = modalbench(scratch.path(), {"run", "case.toml", "--store", "part" + i, "--shard", i + "/2"});
    EXPECT_EQ(part.code, 0) << part.err;
    EXPECT_THAT(part.err, HasSubstr("2 runs done"));
    EXPECT_EQ(part.out, "");  // checks are of the whole
    fs::copy(scratch / ("part" + i), scratch / "whole",
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  const Said whole = modalbench(scratch.path(), {"run", "case.toml", "--store", "whole"});
  EXPECT_EQ(whole.code, 0) << whole.err;
  EXPECT_THAT(whole.err, HasSubstr("0 runs done, 4 found"));
  EXPECT_THAT(whole.out, HasSubstr("holds small"));
}

TEST(PlanCases, SeveralProcessesFindWhatOneFinds) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  const Said said = modalbench(scratch.path(), {"run", "case.toml", "--jobs", "2"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("holds small"));
  const Said plan = modalbench(scratch.path(), {"run", "case.toml", "--plan"});
  EXPECT_THAT(plan.out, HasSubstr("stored   small"));
  EXPECT_THAT(plan.out, testing::Not(HasSubstr("to run")));
}

TEST(PlanCases, MarksFirstTimesLater) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0);
  EXPECT_THAT(text(scratch / "results/results.jsonl"), testing::Not(HasSubstr("online-time")));
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml"}).code, 0);
  EXPECT_THAT(text(scratch / "results/results.jsonl"), HasSubstr("online-time"));
}

}  // namespace
}  // namespace mb
