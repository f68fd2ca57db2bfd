#include "harness/study/memory.h"

#include <gmock/gmock.h>

#include "cases/scene/case_files.h"
#include "harness/catalogue.h"
#include "harness/program_test.h"
#include "harness/store/scratch_folder_test.h"
#include "harness/study/estimate.h"

namespace mb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

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

TEST(Memory, RefusesWithBothNumbers) {
  EXPECT_NO_THROW(require_memory(1e9, 1e9));
  EXPECT_NO_THROW(require_memory(1e12, std::nullopt));  // a system that does not tell
  EXPECT_THAT([] { require_memory(3.2e10, 4e9); },
              ThrowsMessage<std::runtime_error>(HasSubstr("about 32 GB of memory and 4 GB are there")));
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

TEST(Memory, EveryCaseFitsASmallMachineInEveryProfile) {
  const Vocabulary words = default_catalogue().vocabulary();
  for (const auto& folder : {test::cases_folder(), test::cases_folder() / "hard"})
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      for (const char* profile : {"quick", "full"})
        EXPECT_LT(memory(read_toml(entry.path(), words, profile)), 8e9) << entry.path() << profile;
    }
}

}  // namespace
}  // namespace mb
