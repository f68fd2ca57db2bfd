#include "harness/study/memory.h"

#include <gmock/gmock.h>

#include "cases/scene/case_files.h"
#include "cases/scene/resolution.h"
#include "harness/catalogue.h"
#include "harness/program_test.h"
#include "harness/store/file.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/store/store.h"
#include "harness/study/catalogue_test.h"
#include "harness/study/estimate.h"
#include "harness/study/identity.h"
#include "harness/study/truth.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Memory, IsWhatIsAvailableOrWhatTheControlGroupLeaves) {
  const ScratchFolder root;
  EXPECT_FALSE(available_memory(root.path()));  // not told
  fs::create_directories(root / "proc");
  written(root / "proc/meminfo", "MemTotal: 8000000 kB\nMemAvailable:    4000000 kB\n");
  EXPECT_EQ(available_memory(root.path()), 4000000 * 1024.0);
  fs::create_directories(root / "sys/fs/cgroup");
  written(root / "sys/fs/cgroup/memory.max", "3000000\n");
  written(root / "sys/fs/cgroup/memory.current", "1000000\n");
  EXPECT_EQ(available_memory(root.path()), 2e6);
  written(root / "sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(available_memory(root.path()), 4000000 * 1024.0);
}

// Its own group may leave less than those above it, which may be all that a container shows.
TEST(Memory, IsWhatTheOwnControlGroupAndThoseAboveItLeave) {
  const ScratchFolder root;
  fs::create_directories(root / "proc/self");
  fs::create_directories(root / "sys/fs/cgroup/a/b");
  written(root / "proc/self/cgroup", "0::/a/b\n");
  written(root / "sys/fs/cgroup/a/memory.max", "5000000\n");
  written(root / "sys/fs/cgroup/a/memory.current", "1000000\n");
  EXPECT_EQ(available_memory(root.path()), 4e6);
  written(root / "sys/fs/cgroup/a/b/memory.max", "3000000\n");
  written(root / "sys/fs/cgroup/a/b/memory.current", "1000000\n");
  EXPECT_EQ(available_memory(root.path()), 2e6);
  written(root / "sys/fs/cgroup/a/b/memory.stat", "anon 1\ninactive_file 400000\n");  // given back where it is short
  EXPECT_EQ(available_memory(root.path()), 2.4e6);
  written(root / "proc/self/cgroup", "0::/somewhere/of/the/host\n");
  EXPECT_FALSE(available_memory(root.path()));
  written(root / "proc/self/cgroup", "12:cpu,cpuacct:/a\n4:memory:/c\nnonsense\n");  // version 1
  fs::create_directories(root / "sys/fs/cgroup/memory/c");
  written(root / "sys/fs/cgroup/memory/c/memory.limit_in_bytes", "900000\n");
  written(root / "sys/fs/cgroup/memory/c/memory.usage_in_bytes", "1000000\n");
  EXPECT_EQ(available_memory(root.path()), 0);
}

TEST(Memory, IsSharedByAsManyProcessesAsItHolds) {
  EXPECT_EQ(processes_that_fit(4, {1e9, 2e9}, std::nullopt), 4);
  EXPECT_EQ(processes_that_fit(4, {1e9, 2e9}, 8e9), 4);
  EXPECT_EQ(processes_that_fit(4, {1e9, 2e9}, 7.9e9), 3);
  EXPECT_EQ(processes_that_fit(4, {1e9, 2e9}, 2e9), 1);
  EXPECT_EQ(processes_that_fit(4, {1e9, 9e9}, 2e9), 2) << "what does not fit alone is refused, however many run";
  EXPECT_EQ(processes_that_fit(4, {}, 1e9), 4);
}

TEST(Memory, AnAllocationThatFailsIsToldInWords) {
  EXPECT_EQ(failure_text(std::runtime_error("no factor"), 1e9), "no factor");
  EXPECT_THAT(failure_text(std::bad_alloc(), 3.2e10), HasSubstr("out of memory: about 32 GB were expected"));
}

TEST(Memory, RefusesWithBothNumbers) {
  EXPECT_NO_THROW(require_memory(1e9, 1e9));
  EXPECT_NO_THROW(require_memory(1e12, std::nullopt));  // a system that does not tell
  EXPECT_THAT(
      [] { require_memory(3.2e10, 4e9); },
      ThrowsMessage<std::runtime_error>(HasSubstr("out of memory: takes about 32 GB of memory and 4 GB are there")));
}

TEST(Memory, KnowsWhatFailedForWantOfIt) {
  EXPECT_TRUE(is_shortage("failed: " + failure_text(std::bad_alloc(), 1e9)));
  EXPECT_TRUE(is_shortage("failed: CHOLMOD: out of memory"));
  EXPECT_FALSE(is_shortage("failed: not positive definite"));
}

TEST(Memory, EstimateGrowsFasterThanTheMesh) {
  Scene scene = test::read(test::cylinder_text());
  double before = 0;
  for (const int splits : {1, 2, 4, 8}) {
    const double now = memory(scene, {2, {splits, 2 * splits}});
    if (splits == 8) {
      EXPECT_GT(now, 6 * before);  // 8 times the unknowns
    }
    before = now;
  }
  EXPECT_GT(memory(scene), memory(scene, scene.truth.finer));
}

// Truths that are stored are read, and no mesh of them is made.
TEST(Memory, EstimateCountsTheTruthsThatAreComputed) {
  Scene scene = test::read(test::cylinder_text());
  scene.truth.finer = {2, {8, 16}};
  const double read = memory_of_truths(scene, {}), one = memory_of_truths(scene, {scene.truth.finer});
  EXPECT_GT(read, memory_of_answers(scene));
  EXPECT_GT(one, read);
  EXPECT_GT(memory(scene), one);
}

// Lanczos keeps three vectors a mode and their images; a dense solver holds several matrices of n^2 numbers.
TEST(Memory, EstimateCountsModesAndDenseMatrices) {
  const Scene scene = test::read(test::cylinder_text());
  const Body& body = scene.bodies.front();
  const Resolution mesh{2, {8, 16}};
  const double n = n_dofs(body.shape, mesh), bare = memory(scene, mesh);
  ASSERT_GT(n, 10000);
  const auto of_modes = [&](int r) {
    return memory(scene, Contender{"eigenmodes", "exact", mesh, {.modes = r}}, false) - bare;
  };
  EXPECT_GT(of_modes(1000), 6 * 8 * n * 1000);
  EXPECT_GT(of_modes(2000), 1.5 * of_modes(1000));
  const Resolution small{2, {2, 4}};
  const double k = n_dofs(body.shape, small);
  const auto of_full = [&](const char* integrator) {
    return memory(scene, Contender{"full", integrator, small, {}}, false) - memory(scene, small);
  };
  EXPECT_GT(of_full("exact"), of_full("newmark") + 5 * 8 * k * k);
  EXPECT_EQ(memory(scene, Contender{"full-order", "newmark", small, {}}, false), memory(scene, small));
  EXPECT_GT(memory_of_modes(scene, body, 64), memory_of_modes(scene, body, 8));
}

TEST(Memory, EveryCaseFitsASmallMachineInEveryProfile) {
  const Vocabulary words = default_catalogue().vocabulary();
  for (const auto& folder : {test::cases_folder(), test::cases_folder() / "hard"})
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      for (const char* profile : {"quick", "full"}) {
        const Scene scene = read_toml(entry.path(), words, profile);
        EXPECT_LT(memory(scene), 8e9) << entry.path() << profile;
        for (const Job& job : jobs(scene, default_catalogue()))
          EXPECT_LT(memory(scene, job, true), 8e9) << entry.path() << profile << job.label;
      }
    }
}

// 85^3 cubes of degree 1, whose factor takes a terabyte: that files of its truths are there does not mean that they can
// be read.
TEST(Memory, ATruthThatIsDamagedIsComputedOnlyWhereItFits) {
  const ScratchFolder folder;
  auto scene = std::make_shared<Scene>(test::read(test::cylinder_text()));
  scene->bodies.front().shape = Box{{0.1, 0.1, 0.2}};
  scene->bodies.front().resolution = scene->truth.coarser = {1, {85, 85, 85}};
  scene->truth.finer = {1, {86, 86, 86}};
  const double rtol = scene->truth.relative_tolerance;
  for (const auto& [mesh, tolerance] :
       {std::pair(scene->truth.finer, rtol), {scene->truth.coarser, rtol}, {scene->truth.coarser, rtol / 100}})
    write_file(folder / ("truth/" + truth_hash(*scene, mesh, tolerance) + ".h5"), "damaged");
  std::string said;
  const Progress progress = [&](const std::string& line) { said += line + "\n"; };
  EXPECT_THAT([&] { truths(scene, default_catalogue(), Store(folder.path()), progress, [] { return false; }); },
              ThrowsMessage<std::runtime_error>(HasSubstr("GB of memory")));
  EXPECT_THAT(said, HasSubstr("computed again"));
}

// What allocations that fail all the same say, of a truth and of a contender.
TEST(MemoryCases, BadAllocIsAMessageWithTheEstimate) {
  const ScratchFolder scratch;
  written(scratch / "case.toml", small_case());
  const auto fails = [](const System&, const Settings&, double) -> std::unique_ptr<Stepper> { throw std::bad_alloc(); };
  const Said truth = modalbench(scratch.path(), {"run", "case.toml", "--untimed"}, with_sundials(fails));
  EXPECT_EQ(truth.code, 3);
  EXPECT_THAT(truth.err, HasSubstr("failed: out of memory: about"));
  Catalogue catalogue = default_catalogue();
  for (Integrator& integrator : catalogue.integrators)
    if (integrator.name == "exact") integrator.prepare = fails;
  const Said contender = modalbench(scratch.path(), {"run", "case.toml", "--untimed", "--again"}, catalogue);
  EXPECT_EQ(contender.code, 3);
  EXPECT_THAT(contender.err, HasSubstr("static-correction r=4 exact"));
  EXPECT_THAT(contender.err, HasSubstr("failed: out of memory: about"));
  EXPECT_EQ(contender.err.find("bad_alloc"), std::string::npos);
}

}  // namespace
}  // namespace mb
