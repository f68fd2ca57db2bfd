#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/json/json.h"
#include "harness/commands/told_test.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/study/estimate.h"

namespace mb {
namespace {

using test::told;
using ::testing::HasSubstr;

test::Told list(const ScratchFolder& folder, const ListOptions& options) {
  return told(folder.path(), [&](const Console& c) { return list_command(options, default_catalogue(), c); });
}

TEST(ListTest, NamesRunsAndMinutes) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "cases");
  written(folder / "cases/small.toml", small_case());
  const test::Told table = list(folder, {});
  EXPECT_EQ(table.code, 0);
  EXPECT_THAT(table.out, HasSubstr("small"));
  for (const char* name : {"static-correction", "symplectic-euler", "aliasing", "displacement-error"})
    EXPECT_THAT(table.out, HasSubstr(name));
  EXPECT_EQ(table.err, "");
  const Json json = parse_json(list(folder, {.json = true}).out);
  ASSERT_EQ(json["cases"].size(), 1u);
  EXPECT_EQ(json["cases"][0]["name"], "small");
  EXPECT_EQ(json["cases"][0]["n_runs"], 4);
  EXPECT_EQ(json["cases"][0]["runs_in"], Json::array({"quick", "standard", "full"}));
  EXPECT_THAT(table.out, HasSubstr("every profile"));
  EXPECT_GT(json["cases"][0]["estimated_minutes"], 0);
}

TEST(ListTest, NothingFoundAndWrongFilesAreExitCodeTwo) {
  const ScratchFolder folder;
  EXPECT_EQ(list(folder, {.pattern = "no-such-case-anywhere"}).code, 2);
  std::filesystem::create_directory(folder / "cases");
  EXPECT_EQ(list(folder, {}).code, 2);
  written(folder / "cases/small.toml", small_case());
  written(folder / "cases/wrong.toml", "schema = 1\n");
  const test::Told said = list(folder, {});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.out, HasSubstr("small"));  // what can be read is listed all the same
  EXPECT_THAT(said.err, HasSubstr("wrong.toml"));
  EXPECT_EQ(list(folder, {.pattern = "mall"}).code, 0);
}

// The quick profile of cylinder-compression as it was when the constants were fitted: 45 s of truths and 134 s of
// contenders on two cores. A factor of three is what an estimate of other meshes and loads is good for.
TEST(EstimateTest, IsWithinAFactorOfThreeOfARunThatWasTimed) {
  const Catalogue catalogue = default_catalogue();
  Scene scene =
      read_toml(std::filesystem::path(MB_SOURCE_DIR) / "cases/cylinder-compression.toml", catalogue.vocabulary());
  scene.duration = 0.290643;
  scene.samples_per_second = 600;
  scene.bodies.front().resolution = {4, {1, 4}};
  scene.truth = {1e-6, {4, {2, 4}}, {3, {2, 4}}, ""};
  scene.study = {};
  scene.study.methods = {"eigenmodes", "static-correction"};
  scene.study.modes = {0, 1, 2, 4, 8, 16, 32, 64, 128, 256};
  std::vector<double> steps;
  for (double rate = 60; rate <= 3840; rate *= 2) steps.push_back(1 / rate);
  scene.study.rivals = {{"newmark", {1, 2, 3, 4}, {{1, 2}, {1, 4}, {2, 4}}, steps, {}}};
  const Estimate found = estimate(scene, catalogue);
  EXPECT_GT(found.truth, 45.0 / 3);
  EXPECT_LT(found.truth, 45.0 * 3);
  EXPECT_GT(found.contenders, 134.0 / 3);
  EXPECT_LT(found.contenders, 134.0 * 3);
  EXPECT_EQ(found.analyses, 0);
}

// As many cells in a row as in a cube: the factor's rows are a layer wide, a hundredth of the mesh or a seventh.
TEST(EstimateTest, ASlenderMeshIsCheaper) {
  const ScratchFolder folder;
  const Catalogue catalogue = default_catalogue();
  Scene scene = read_toml(written(folder / "small.toml", small_case()), catalogue.vocabulary());
  scene.bodies.front().shape = Box{{1, 1, 1}};
  scene.study.rivals.clear();  // their cells are of the other shape
  const auto truth_on = [&](const std::vector<int>& cells) {
    scene.bodies.front().resolution = scene.truth.finer = scene.truth.coarser = {2, cells};
    return estimate(scene, catalogue).truth;
  };
  EXPECT_LT(truth_on({1, 1, 512}), 0.8 * truth_on({8, 8, 8}));
  EXPECT_EQ(truth_on({1, 1, 512}), truth_on({512, 1, 1}));
}

TEST(EstimateTest, GrowsWithAllThatCosts) {
  const ScratchFolder folder;
  const Catalogue catalogue = default_catalogue();
  const Scene scene = read_toml(written(folder / "small.toml", small_case()), catalogue.vocabulary());
  const double base = estimate(scene, catalogue).total();
  EXPECT_GT(base, 0);
  const auto grows = [&](const char* what, const auto& change) {
    Scene other = scene;
    change(other);
    EXPECT_GT(estimate(other, catalogue).total(), base) << what;
  };
  grows("mesh", [](Scene& s) { s.bodies.front().resolution = {4, {2, 8}}; });
  grows("truth", [](Scene& s) { s.truth.finer = {4, {2, 8}}; });
  grows("tolerance", [](Scene& s) { s.truth.relative_tolerance = 1e-9; });
  grows("duration", [](Scene& s) { s.duration *= 100; });
  grows("modes", [](Scene& s) { s.study.modes = {4, 12, 50}; });
  grows("steps", [](Scene& s) { s.study.rivals.front().time_steps.push_back(1e-5); });
  grows("analyses", [](Scene& s) { s.study.analyses = {"step-limits"}; });
}

}  // namespace
}  // namespace mb
