#include "cases/scene/scene.h"

#include <gtest/gtest.h>

#include "cases/scene/case_files.h"

namespace mb {
namespace {

TEST(SceneTimes, run_from_zero_to_the_duration_at_the_rate) {
  Scene scene{};
  scene.duration = 0.290643;
  scene.frame_rate = 60;
  scene.samples_per_second = 600;
  const VectorXd frames = frame_times(scene), samples = sample_times(scene);
  ASSERT_EQ(frames.size(), 18);  // 17.4 frames fit
  EXPECT_EQ(frames[0], 0);
  EXPECT_EQ(frames[17], 17.0 / 60);
  ASSERT_EQ(samples.size(), 175);
  for (Index i = 0; i < frames.size(); ++i) EXPECT_NEAR(frames[i], samples[10 * i], 1e-16);
}

// 0.7 * 10 = 6.999... and 0.29 * 100 = 28.999... in double precision: the last sample belongs to the duration.
TEST(SceneTimes, keep_the_last_sample_where_rounding_would_lose_it) {
  Scene scene{};
  scene.duration = 0.29;
  scene.frame_rate = 100;
  ASSERT_LT(scene.duration * scene.frame_rate, 29);
  ASSERT_EQ(frame_times(scene).size(), 30);
  EXPECT_EQ(frame_times(scene)[29], scene.duration) << "never beyond the duration";
}

TEST(Resolution, compares_and_prints) {
  EXPECT_EQ((Resolution{4, {1, 4}}), (Resolution{4, {1, 4}}));
  EXPECT_FALSE((Resolution{4, {1, 4}}) == (Resolution{3, {1, 4}}));
  EXPECT_FALSE((Resolution{4, {1, 4}}) == (Resolution{4, {1, 4, 1}}));
  EXPECT_EQ(to_string(Resolution{4, {1, 4}}), "Q4 1x4");
  EXPECT_EQ(to_string(Resolution{2, {3}}), "Q2 3");
}

TEST(Resolution, of_a_whole_scene_becomes_the_bodies_own) {
  const Scene scene = test::read(test::content(test::cases_folder() / "ball-on-two-by-four.toml"));
  ASSERT_GT(scene.bodies.size(), 1u);
  ASSERT_FALSE(own_meshes(scene) == scene.truth.finer);
  EXPECT_EQ(own_meshes(on_meshes(scene, scene.truth.finer)), scene.truth.finer);
  EXPECT_EQ(own_meshes(on_meshes(scene, own_meshes(scene))), own_meshes(scene));
  Resolution of_one = scene.truth.finer;
  of_one.others.clear();
  EXPECT_THROW(on_meshes(scene, of_one), std::out_of_range);
}

TEST(Canonical, depends_on_all_that_determines_a_run) {
  const std::string text = test::cylinder_text();
  const std::string original = canonical(test::read(text));
  const std::pair<const char*, const char*> changes[] = {
      {"radius = 0.05 ", "radius = 0.051 "},
      {"length = 0.20", "length = 0.21"},
      {"youngs_modulus = 2e4", "youngs_modulus = 20000.000000000004"},
      {"poissons_ratio = 0.45", "poissons_ratio = 0.46"},
      {"density        = 1100", "density = 1101"},
      {"alpha = 1.5733", "alpha = 1.5734"},
      {"alpha = 1.5733", "beta = 1e-3\nalpha = 1.5733"},
      {"cells  = [1, 4]", "cells = [1, 5]"},
      {"duration = 0.096881 }", "duration = 0.096882 }"},
      {"[0, 0, -400]", "[0, 0, -401]"},
      {"face     = \"z-max\"", "face = \"side\""},
      {"face     = \"z-max\"", "face = \"z-max\"\ndisc = { centre = [0, 0, 0.1], radius = 0.04 }"},
      {"point     = [0, 0, 0.1]", "point = [0, 0, 0.09]"},
      {"direction = [0, 0, 1]", "direction = [0, 1, 1]"},
      {"duration           = 0.290643", "duration = 0.3"},
      {"frame_rate         = 60", "frame_rate = 30"},
      {"samples_per_second = 600", "samples_per_second = 1200"},
      {"relative_tolerance = 1e-6", "relative_tolerance = 1e-7"},
      {"finer   = { degree = 4, cells = [2, 4]", "finer = { degree = 4, cells = [2, 8]"},
      {"coarser = { degree = 3", "coarser = { degree = 2"},
      {"[body.resolution]", "[[body.support]]\nkind = \"mean\"\nface = \"side\"\n[body.resolution]"},
      {"[body.resolution]", "[[body.support]]\nkind = \"diaphragm\"\nface = \"z-min\"\n[body.resolution]"},
      {"alpha = 1.5733", "alpha = 1.5733\nratios = [0.02]"},
      {"traction = [0, 0, -400]", "pressure = 400"},
      {"[study]", "[reference_frequencies]\nhertz = [10]\n[study]"},
      {"[body.resolution]",
       "[[body.support]]\nkind = \"driven\"\nface = \"side\"\ndirection = [1, 0, 0]\n"
       "acceleration = { kind = \"step\" }\n[body.resolution]"},
      {"youngs_modulus = 2e4       # [Pa]\npoissons_ratio = 0.45",
       "orthotropy = { youngs_moduli = [2e4, 2e4, 2e4], poissons_ratios = [0.45, 0.45, 0.45], "
       "shear_moduli = [6896.5517241379312, 6896.5517241379312, 6896.5517241379312] }"},
      {"[profile.standard]",
       "[profile.quick]\nresolution = { cylinder = { degree = 3, cells = [1, 4] } }\n"
       "[profile.standard]"},
  };
  for (const auto& [passage, replacement] : changes) {
    EXPECT_NE(canonical(test::read(test::with(text, passage, replacement))), original) << replacement;
  }
}

TEST(Canonical, does_not_depend_on_prose_study_checks_or_layout) {
  const std::string text = test::cylinder_text();
  const std::string original = canonical(test::read(text));
  const std::pair<const char*, const char*> changes[] = {
      {"squeezed along its axis", "squeezed"},
      {"modes   = [0, 1, 2,", "modes = [0, 1, 2, 3,"},
      {"at_most = 0.02\n", "at_most = 0.03\n"},
      {"integrator = \"newmark\"", "integrator = \"central-difference\""},
      {"[[study.rival]]",
       "[[study.stepping]]\nintegrator = \"newmark\"\nmethods = [\"full\"]\ntime_steps = [0.01]\n"
       "[[study.rival]]"},
      {"schema  = 1", "schema = 1\nexercises = \"Damping.\""},
      {"schema  = 1", "schema = 1\nhard = \"Nothing grows.\""},
      {"length = 0.20", "length = 0.200000"},
      {"density        = 1100", "density = 1.1e3"},
      {"direction = [0, 0, 1]", "direction = [-0.0, 0, 7.0]"},
  };
  for (const auto& [passage, replacement] : changes) {
    EXPECT_EQ(canonical(test::read(test::with(text, passage, replacement))), original) << replacement;
  }
}

}  // namespace
}  // namespace mb
