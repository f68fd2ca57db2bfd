// What a run takes at its peak, as the system counts it, against what was estimated before it began: each of what the
// estimate is made of grows alone, and what does not grow cancels.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cases/scene/case_files.h"
#include "harness/catalogue.h"
#include "harness/process_test.h"
#include "harness/program_test.h"
#include "harness/store/file.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/study/estimate.h"

namespace mb {
namespace {

using Changes = std::vector<std::pair<std::string, std::string>>;  // from, to

// [byte] Of a case in words, some of them changed.
struct Taken {
  double peak, own_peak, estimated;  // own: without pages of libraries, which the system takes away and gives back
};
Taken taken(std::string words, const Changes& changes, bool timed = false) {
  for (const auto& [from, to] : changes) words.replace(words.find(from), from.size(), to);
  const ScratchFolder folder;
  const fs::path file = folder / "case.toml";
  written(file, words);
  Process run(folder.path(), timed ? std::vector<std::string>{"run", "case.toml"}
                                   : std::vector<std::string>{"run", "case.toml", "--untimed"});
  const double own = run.most_memory_of_its_own();
  EXPECT_EQ(run.code(), 0) << run.err();
  const Scene scene = read_toml(file, default_catalogue().vocabulary());
  double most = 0;
  for (const Job& job : jobs(scene, default_catalogue())) most = std::max(most, memory(scene, job, timed));
  return {run.most_memory(), own, std::max(memory(scene), memory_of_answers(scene) + most)};
}

// The peak grows by what is estimated at most, and by a quarter of it at least: an estimate of ten times what is needed
// would refuse what fits.
void expect_growth_as_estimated(const std::string& words, const Changes& small, const Changes& large,
                                bool timed = false) {
  const Taken of_small = taken(words, small, timed), of_large = taken(words, large, timed);
  const double grown = of_large.own_peak - of_small.own_peak, expected = of_large.estimated - of_small.estimated;
#ifdef MB_SANITIZED  // whose shadow is an eighth of what is held, and which keeps up to 256 MiB of what was freed
  EXPECT_LT(grown, 9. / 8 * expected + 0x1p28);
#else
  EXPECT_LT(grown, expected);
  EXPECT_GT(grown, expected / 4);
  EXPECT_LT(of_large.peak, of_large.estimated);
#endif
  ::testing::Test::RecordProperty("grown_over_expected", fmt::format("{:.3f}", grown / expected));
  ::testing::Test::RecordProperty("peak_over_estimated", fmt::format("{:.3f}", of_large.peak / of_large.estimated));
}

TEST(MemoryCases, GrowsWithSamplesNoFasterThanEstimated) {
  const auto at = [](int rate) {  // [1/s] for 0.1 s
    return Changes{{"second = 200", fmt::format("second = {}", rate)},
                   {"[study]\n", "[study]\nanalyses = [\"budget\", \"aliasing\", \"probe-extremes\"]\n"}};
  };
  expect_growth_as_estimated(small_case("1"), at(2500), at(12500));
}

// A contender of every mode of the mesh beside those of small_case.
std::string with_full_basis() {
  std::string words = small_case("1");
  const std::string methods = "[\"static-correction\"";
  return words.insert(words.find(methods) + methods.size(), ", \"full\"");
}

// What is timed answers at every frame: by every mode of the mesh, whose states are the most.
TEST(MemoryCases, GrowsWithFramesNoFasterThanEstimated) {
  const auto at = [](int rate) { return Changes{{"frame_rate = 60", fmt::format("frame_rate = {}", rate)}}; };
  expect_growth_as_estimated(with_full_basis(), at(50000), at(250000), true);
}

// Another mesh of the body, and of its truths likewise.
Changes with_cells(const std::string& cells) {
  return {{"cells = [1, 2]\n[[", cells + "\n[["},
          {"coarser = { degree = 2, cells = [1, 2] }", "coarser = { degree = 2, " + cells + " }"},
          {"finer = { degree = 3, cells = [1, 2] }", "finer = { degree = 3, " + cells + " }"}};
}

// A cube, which of all bodies has the widest factors.
TEST(MemoryCases, GrowsWithMeshesNoFasterThanEstimated) {
  const auto of = [](int n) {
    const std::string cells = fmt::format("cells = [{0}, {0}, {0}]", n);
    Changes all = with_cells(cells);
    all.push_back({"kind = \"cylinder\"\nradius = 0.05\nlength = 0.2", "kind = \"box\"\nsize = [0.2, 0.2, 0.2]"});
    all.push_back({"cells = [[1, 2]]", "cells = [[1, 1, 1]]"});
    return all;
  };
  expect_growth_as_estimated(small_case("1"), of(3), of(5));
}

// By a dense solver.
TEST(MemoryCases, GrowsWithDenseBasesNoFasterThanEstimated) {
  expect_growth_as_estimated(with_full_basis(), with_cells("cells = [1, 8]"), with_cells("cells = [1, 16]"));
}

// Modes that a dashpot couples, in closed form by complex ones.
TEST(MemoryCases, GrowsWithCoupledModesNoFasterThanEstimated) {
  std::string words = with_full_basis();
  words.insert(words.find("[[load]]\n"), R"([[body.support]]
kind = "fixed"
face = "z-min"
[[body.dashpot]]
face = "z-max"
direction = [0, 0, 1]
damping = 0.1
)");
  const auto of = [](const std::string& cells) {
    Changes all = with_cells(cells);
    all.push_back({"face = \"z-min\"\ntraction", "face = \"side\"\ntraction"});
    return all;
  };
  expect_growth_as_estimated(words, of("cells = [1, 2]"), of("cells = [1, 4]"));
}

TEST(MemoryCases, GrowsWithMeshesInContactNoFasterThanEstimated) {
  const auto of = [](int n) {
    const auto cells = [](int m) { return fmt::format("cells = [{0}, {0}, {0}]", m); };
    return Changes{{"duration = 0.5", "duration = 0.06"},
                   {"cells = [1, 1, 1]\n[[obstacle]]", cells(n) + "\n[[obstacle]]"},
                   {"degree = 1, cells = [2, 2, 2]", "degree = 1, " + cells(n + 1)},
                   {"degree = 1, cells = [1, 1, 1]", "degree = 1, " + cells(n / 2)}};
  };
  expect_growth_as_estimated(bouncing_case("contact_steps = [1e-3]"), of(6), of(12));
}

}  // namespace
}  // namespace mb
