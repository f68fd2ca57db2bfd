#include "harness/study/storable.h"

#include <gmock/gmock.h>

#include "cases/scene/case_files.h"
#include "harness/catalogue.h"
#include "harness/store/trajectory_content.h"
#include "harness/study/truth.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// By full order on a coarse mesh: what is kept does not depend on it.
Trajectory answer(const Scene& scene) {
  const Catalogue catalogue = default_catalogue();
  Resolution mesh{1, scene.bodies.at(0).resolution.cells};
  std::ranges::fill(mesh.cells, 1);
  const Model model = make_model(std::make_shared<const Scene>(scene), mesh);
  Settings settings;
  settings.time_step = 1e-3;
  return catalogue.method("full-order")
      .prepare(model, settings, catalogue.integrator("newmark"))
      ->simulate({sample_times(scene), true});
}

// Of bodies in contact but for their touches, which nobody foresees.
Index n_foreseen(Trajectory trajectory) {
  for (BodyTrajectory& body : trajectory.bodies) body.contact.touches.clear();
  return n_values(trajectory);
}

TEST(Storable, CountsWhatIsKept) {
  for (const std::string& text : {test::cylinder_text(), test::contact_text()}) {
    Scene scene = test::read(text);
    for (Body& body : scene.bodies) body.twist = {};  // full order of small rotations answers
    EXPECT_EQ(values_at_a_time(scene) * sample_times(scene).size(), n_foreseen(answer(scene)));
  }
}

// What is let through is written and read; one value less in a file, and it is refused with both numbers.
TEST(Storable, RefusesWhatIsWrittenButNeverRead) {
  const Scene scene = test::read(test::cylinder_text());
  const Trajectory kept = answer(scene);
  const Index n = n_values(kept);
  EXPECT_NO_THROW(require_storable(scene, n));
  EXPECT_NO_THROW(trajectory_of(content_of(kept)));
  const std::string samples = std::to_string(kept.t.size());
  EXPECT_THAT([&] { require_storable(scene, n - 1); },
              ThrowsMessage<std::runtime_error>(::testing::AllOf(
                  HasSubstr("keeps " + samples + " samples"), HasSubstr(std::to_string(n) + " in all"),
                  HasSubstr("takes " + std::to_string(n - 1)), HasSubstr("lower samples_per_second or duration"),
                  HasSubstr(std::to_string(kept.t.size() - 1) + " samples at most"))));
}

TEST(Storable, SamplesBeyondTheStoreAreRefused) {
  Scene scene = test::read(test::cylinder_text());
  scene.duration = 1;
  const Index most = hdf5_max_elements / values_at_a_time(scene);
  scene.samples_per_second = static_cast<double>(most - 1);  // and the one at t = 0
  EXPECT_EQ(sample_times(scene).size(), most);
  EXPECT_NO_THROW(require_storable(scene));
  scene.samples_per_second = static_cast<double>(most);
  EXPECT_THROW(require_storable(scene), std::runtime_error);
}

TEST(Storable, EveryCaseIsInItsLongestProfile) {
  const Vocabulary words = default_catalogue().vocabulary();
  for (const auto& folder : {test::cases_folder(), test::cases_folder() / "hard"})
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      EXPECT_NO_THROW(require_storable(read_toml(entry.path(), words, "full"))) << entry.path();
    }
}

}  // namespace
}  // namespace mb
