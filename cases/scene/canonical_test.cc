// Canonical text: what hashes name. That of scenes without contact is as old as the results that are stored under it.
#include <gtest/gtest.h>

#include "cases/scene/case_files.h"

namespace mb {
namespace {

using test::contact_text;
using test::with;

TEST(Canonical, text_of_scenes_without_contact_stays_as_it_was) {
  EXPECT_EQ(canonical(test::read(test::cylinder_text())), R"(scene 1
body cylinder
shape cylinder 0.050000000000000003 0.20000000000000001
material 20000 0.45000000000000001 1100
damping 1.5732999999999999 0
resolution Q4 1x4
load squeeze
history pulse amplitude 1 start 0 0.096880999999999995
traction cylinder face z-max 0 0 -400 0
traction cylinder face z-min 0 0 400 0
probe top-centre cylinder 0 0 0.10000000000000001 0 0 1
probe side-middle cylinder 0.050000000000000003 0 0 1 0 0
duration 0.29064299999999998
frame_rate 60
samples_per_second 600
truth 9.9999999999999995e-07 finer Q4 2x4 coarser Q3 2x4
)");
  EXPECT_EQ(canonical(read_toml(test::cases_folder() / "nafems-5t.toml", test::vocabulary())), R"(scene 1
body beam
shape box 10 2 2
material 200000000000 0.29999999999999999 8000
damping 5.3600000000000003 7.4599999999999997e-05
resolution Q2 10x2x2
support diaphragm face x-min
support diaphragm face x-max
support mean face x-min
load line
history step amplitude 1 start 0
traction beam face z-max 0 0 0 500000
probe midspan beam 0 0 0 0 0 -1
duration 0.059999999999999998
frame_rate 1000
samples_per_second 4000
truth 1.0000000000000001e-05 finer Q3 10x2x2 coarser Q2 10x2x2
)");
  EXPECT_EQ(canonical(read_toml(test::cases_folder() / "cylinder-shear-step.toml", test::vocabulary())),
            R"(scene 1
body cylinder
shape cylinder 0.050000000000000003 0.20000000000000001
material 20000 0.45000000000000001 1100
damping 1.5732999999999999 0
resolution Q3 1x8
support driven face z-min
drive 1 0 0 step amplitude 0.34999999999999998 start 0
probe top-sideways cylinder 0 0 0.10000000000000001 1 0 0
probe side-middle cylinder 0.050000000000000003 0 0 1 0 0
duration 0.80000000000000004
frame_rate 60
samples_per_second 960
truth 1.0000000000000001e-05 finer Q4 1x8 coarser Q4 1x5
)");
}

TEST(Canonical, depends_on_all_that_a_scene_with_contact_states) {
  const std::string text = contact_text();
  const std::string original = canonical(test::read(text));
  const std::pair<const char*, const char*> changes[] = {
      {"gravity = [0, 0, -9.81]", "gravity = [0, 0, -9.82]"},
      {"gravity = [0, 0, -9.81]", ""},
      {"position = [0, 0, 5]", "position = [0, 0, 0.57]"},
      {"axis = [0, 2, 0], angle = 0.5", "axis = [0, 2, 0.1], angle = 0.5"},
      {"angle = 0.5", "angle = 0.6"},
      {"velocity         = [0, 0, -3.13]", "velocity = [0, 0, -3.14]"},
      {"angular_velocity = [0, 12, 0]", "angular_velocity = [0, 13, 0]"},
      {"graded = 3 }\n\n[body.shape]", "graded = 2 }\n\n[body.shape]"},
      {"kind = \"half-space\"", "kind = \"sphere\", radius = 1"},
      {"size = [1, 0.4, 0.5]", "size = [1, 0.4, 0.6]"},
      {"kind = \"box\", size = [1, 0.4, 0.5]", "kind = \"cylinder\", radius = 0.5, length = 1"},
      {"rounding = 0.01", "rounding = 0.02"},
      {"rounding = 0.01", ""},
      {"angle = 0.3", "angle = 0.4"},
      {"stiffness = \"auto\"", "stiffness = 1e9"},
      {"stiffness = 1e9", "stiffness = 2e9"},
      {"damping   = 0.1", "damping = 0.2"},
      {"coefficient = 0.3", "coefficient = 0.4"},
      {"slip_speed = 1e-3", "slip_speed = 2e-3"},
      {"graded = 4 }\ncoarser", "graded = 5 }\ncoarser"},
  };
  for (const auto& [passage, replacement] : changes) {
    EXPECT_NE(canonical(test::read(with(text, passage, replacement))), original) << replacement;
  }
}

TEST(Canonical, of_contact_does_not_depend_on_defaults_that_are_written_out_nor_on_the_study) {
  const std::string text = contact_text();
  const std::string original = canonical(test::read(text));
  const std::pair<const char*, const char*> changes[] = {
      {"stiffness = \"auto\"", "stiffness = \"auto\"\ndamping = 0"},
      {"shape = { kind = \"half-space\" }",
       "shape = { kind = \"half-space\" }\npose = { position = [0, -0.0, 0], axis = [0, -1, 0], angle = 0 }"},
      {"axis = [0, 2, 0]", "axis = [0, 1, 0]"},
      {"contact_steps = [1e-4, 5e-5]", "contact_steps = [1e-4]"},
      {"graded     = 2", "graded = 1"},
  };
  for (const auto& [passage, replacement] : changes) {
    EXPECT_EQ(canonical(test::read(with(text, passage, replacement))), original) << replacement;
  }
}

TEST(Canonical, says_nothing_of_linear_kinematics) {
  const auto of = [](const char* kinematics) {
    return canonical(test::read(with(contact_text(), "[body.shape]", std::string(kinematics) + "[body.shape]")));
  };
  EXPECT_EQ(of("kinematics = \"linear\"\n"), canonical(test::read(contact_text())));  // stored results keep their names
  EXPECT_NE(of("kinematics = \"finite\"\n"), canonical(test::read(contact_text())));
}

TEST(Canonical, tells_superquadrics_apart) {
  const auto of = [](const char* numbers) {
    return canonical(
        test::read(with(contact_text(), "kind = \"half-space\"", std::string("kind = \"superquadric\", ") + numbers)));
  };
  const std::string original = of("semi_axes = [1, 2, 3], exponents = [0.5, 1]");
  EXPECT_NE(of("semi_axes = [1, 2, 4], exponents = [0.5, 1]"), original);
  EXPECT_NE(of("semi_axes = [1, 2, 3], exponents = [0.6, 1]"), original);
  EXPECT_NE(of("semi_axes = [1, 2, 3], exponents = [0.5, 1.1]"), original);
  EXPECT_EQ(of("semi_axes = [1, 2, 3], exponents = [0.5, 1], taper = 0"), original);
  const std::string tapered = of("semi_axes = [1, 2, 3], exponents = [0.5, 1], taper = 0.3");
  EXPECT_NE(tapered, original);
  EXPECT_NE(of("semi_axes = [1, 2, 3], exponents = [0.5, 1], taper = -0.3"), tapered);
}

}  // namespace
}  // namespace mb
