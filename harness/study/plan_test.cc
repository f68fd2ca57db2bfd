#include "harness/study/plan.h"

#include <gmock/gmock.h>

#include <set>

#include "cases/json/json.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using ::testing::HasSubstr;

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
  EXPECT_TRUE(labels.contains("static-correction r=12 exact Q2 1x2")) << ::testing::PrintToString(labels);
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

TEST(PlanTest, WhatTheStudyListsTwiceIsOneJob) {
  std::string twice = small_case();
  const std::string from = "[[study.rival]]", to = "[[check]]";
  const size_t at = twice.find(from);
  twice.insert(at, twice.substr(at, twice.find(to) - at));
  EXPECT_EQ(jobs(scene_of(twice), default_catalogue()).size(), 4u);
}

TEST(PlanTest, RivalsWithoutCellsStandOnTheBodiesOwnMeshes) {
  const std::string own = "[[study.rival]]\nintegrator = \"newmark\"\ntime_steps = [3e-3]\n\n[[check]]";
  const std::string text = small_case();
  const Scene scene = scene_of(text.substr(0, text.find("[[check]]")) + own + text.substr(text.find("[[check]]") + 9));
  const std::vector<Contender> all = contenders(scene, default_catalogue());
  const auto found = std::ranges::find_if(all, [](const Contender& c) { return c.settings.time_step == 3e-3; });
  ASSERT_NE(found, all.end());
  EXPECT_EQ(found->method, "full-order");
  EXPECT_EQ(to_string(found->resolution), to_string(own_meshes(scene)));
}

TEST(PlanTest, PartsOfAPartAreThePart) {
  const std::vector<Job> all = jobs(scene_of(small_case()), default_catalogue());
  std::multiset<std::string> whole, parts;
  const Shard second{2, 2};
  for (const Job& job : part(all, second)) whole.insert(job.hash);
  for (int k = 1; k <= 3; ++k)
    for (const Job& job : part(all, second.part(k, 3))) parts.insert(job.hash);
  EXPECT_EQ(whole.size(), 2u);
  EXPECT_EQ(parts, whole);
}

TEST(PlanTest, ShardsAreReadStrictly) {
  const auto shard = parse_shard("2/8");
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->i, 2);
  EXPECT_EQ(shard->n, 8);
  for (const char* wrong :
       {"", "2", "2/", "/8", "0/8", "9/8", "-1/8", "2/8x", "2/0", " 2/8", "1e0/2", "99999999999/2", "1/1000001"})
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
  EXPECT_THAT(plan.out, ::testing::Not(HasSubstr("to run")));
}

// Once a call, by the process that is left when the others have ended; everything else by those.
TEST(PlanCases, TimesAreTakenByOneProcessAlone) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", bouncing_case("contact_steps = [1e-3]\nanalyses = [\"flight-cost\"]"));
  for (const char* how : {"--resume", "--again"}) {
    const Said said = modalbench(scratch.path(), {"run", "case.toml", "--jobs", "2", how});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_THAT(said.err, HasSubstr("[1/1] small · eigenmodes")) << how;  // without its time
    const size_t at = said.err.find("flight-cost");
    ASSERT_NE(at, std::string::npos) << how;
    EXPECT_EQ(said.err.find("flight-cost", at + 1), std::string::npos) << said.err;
    EXPECT_THAT(said.err.substr(at), HasSubstr("2 runs done")) << how;  // with the time of the other
  }
  EXPECT_THAT(modalbench(scratch.path(), {"run", "case.toml", "--jobs", "2"}).err, HasSubstr("0 runs done, 2 found"));
}

TEST(PlanCases, SeveralProcessesShareAPart) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  const std::vector<std::string> line{"run", "case.toml", "--untimed", "--jobs", "2", "--shard", "2/2"};
  const Said said = modalbench(scratch.path(), line);
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("[1/1]"));  // each of the two has one of the two jobs
  EXPECT_THAT(said.err, ::testing::Not(HasSubstr("[1/2]")));
  EXPECT_THAT(said.err, HasSubstr("0 runs done, 2 found"));
  auto again = line;
  again.push_back("--again");
  EXPECT_THAT(modalbench(scratch.path(), again).err, HasSubstr("[1/1]"));
}

TEST(PlanCases, ACaseNamedTwiceRunsOnce) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "cases");
  written(scratch / "cases/small.toml", small_case());
  const Said said =
      modalbench(scratch.path(), {"run", "small", "cases/small.toml", "./cases/../cases/small.toml", "--plan"});
  EXPECT_EQ(std::ranges::count(said.out, '\n'), 4);
}

TEST(PlanCases, SettingsOfEveryJobInFull) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  const Said said =
      modalbench(scratch.path(), {"run", "case.toml", "--plan", "--json", "--set", "rival.time_steps=0.0012345678901"});
  const Json jobs = parse_json(said.out)["jobs"];
  ASSERT_EQ(jobs.size(), 3u);
  for (const Json& job : jobs) {
    const bool full = job["method"] == "full-order";
    EXPECT_EQ(job["integrator"], full ? "newmark" : "exact");
    EXPECT_EQ(job["resolution"], full ? "Q1 1x2" : "Q2 1x2");
    EXPECT_EQ(job["modes"].is_null(), full);
    EXPECT_EQ(job["time_step"], full ? Json(0.0012345678901) : Json(nullptr));
    EXPECT_TRUE(job["relative_tolerance"].is_null());
  }
}

TEST(PlanCases, MarksFirstTimesLater) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml", "--untimed"}).code, 0);
  const auto plan = [&](const std::string& how) {
    return modalbench(scratch.path(), {"run", "case.toml", "--plan", how}).out;
  };
  EXPECT_THAT(plan("--resume"), ::testing::Not(HasSubstr("stored")));  // their times are left to take
  EXPECT_THAT(plan("--untimed"), ::testing::Not(HasSubstr("to run")));
  EXPECT_THAT(plan("--again"), ::testing::Not(HasSubstr("stored")));
  EXPECT_THAT(text(scratch / "results/results.jsonl"), ::testing::Not(HasSubstr("online-time")));
  ASSERT_EQ(modalbench(scratch.path(), {"run", "case.toml"}).code, 0);
  EXPECT_THAT(text(scratch / "results/results.jsonl"), HasSubstr("online-time"));
}

TEST(PlanTest, TakesApartWhatMeasuresTimes) {
  const auto of = [](const char* name) { return Job{Job::Kind::analysis, "", "", {}, name}; };
  for (const char* name : {"contact", "collision-cost", "flight-cost", "instructions"})
    EXPECT_TRUE(takes_times(of(name))) << name;
  for (const char* name : {"budget", "stability-map", "contact-stability"}) EXPECT_FALSE(takes_times(of(name))) << name;
  EXPECT_FALSE(takes_times({Job::Kind::marks, "", "", {}, ""}));
}

}  // namespace
}  // namespace mb
