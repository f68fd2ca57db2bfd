// The numbers of cylinder-compression, each as its definition gives it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cases/scene/case_files.h"
#include "cases/scene/resolution.h"

namespace mb {
namespace {

Scene cylinder(const std::string& profile = "quick") {
  return read_toml(test::cases_folder() / "cylinder-compression.toml", test::vocabulary(), profile);
}

TEST(CylinderCompression, is_the_body_that_the_paper_squeezes) {
  const Scene scene = cylinder();
  EXPECT_EQ(scene.name, "cylinder-compression");
  ASSERT_EQ(scene.bodies.size(), 1u);
  const Body& body = scene.bodies[0];
  EXPECT_EQ(body.name, "cylinder");
  const auto& shape = std::get<Cylinder>(body.shape);
  EXPECT_EQ(shape.radius, 0.05);
  EXPECT_EQ(shape.length, 0.20);
  EXPECT_EQ(body.material.youngs_modulus, 2e4);
  EXPECT_EQ(body.material.poissons_ratio, 0.45);
  EXPECT_EQ(body.material.density, 1100);
  EXPECT_EQ(body.damping.alpha, 1.5733);
  EXPECT_EQ(body.damping.beta, 0);
  EXPECT_EQ(body.resolution, (Resolution{3, {1, 4}}));
  EXPECT_EQ(n_dofs(body.shape, body.resolution), 2028);
  EXPECT_TRUE(body.supports.empty());
}

// Every stated number has five significant digits: half a unit of the last is the tolerance, relative 5e-5 at most.
TEST(CylinderCompression, numbers_follow_from_the_body) {
  const Scene scene = cylinder();
  const Body& body = scene.bodies[0];
  const auto& shape = std::get<Cylinder>(body.shape);
  const double c_t =
      std::sqrt(body.material.youngs_modulus / (2 * (1 + body.material.poissons_ratio)) / body.material.density);
  const double torsion = pi * c_t / shape.length;  // [rad/s] first torsion mode of a free bar, exact
  EXPECT_NEAR(torsion, 39.331, 5e-4);
  EXPECT_NEAR(body.damping.alpha / (2 * 0.02 * torsion), 1, 5e-5);
  const double axial = 1.29506 * c_t / shape.radius;  // [rad/s]
  const auto& pulse = std::get<Pulse>(scene.loads[0].history);
  EXPECT_NEAR(pulse.duration * axial / (2 * pi), 1, 5e-5);
  EXPECT_NEAR(scene.duration / pulse.duration, 3, 1e-12);
}

TEST(CylinderCompression, is_loaded_by_equal_and_opposite_compression) {
  const Scene scene = cylinder();
  ASSERT_EQ(scene.loads.size(), 1u);
  EXPECT_EQ(scene.loads[0].history, History(Pulse{0.096881, 1, 0}));
  ASSERT_EQ(scene.loads[0].tractions.size(), 2u);
  Vector3d sum = Vector3d::Zero();
  for (const Traction& traction : scene.loads[0].tractions) {
    EXPECT_EQ(traction.body, "cylinder");
    EXPECT_FALSE(traction.patch.disc.has_value());
    const Vector3d normal = plane_normal(scene.bodies[0].shape, traction.patch.face);
    EXPECT_EQ(traction.traction, -400 * normal) << "against the outward normal: compression";
    sum += traction.traction;
  }
  EXPECT_EQ(sum, Vector3d::Zero());
}

TEST(CylinderCompression, is_looked_at_where_and_when_it_says) {
  const Scene scene = cylinder();
  EXPECT_EQ(scene.duration, 0.290643);
  EXPECT_EQ(scene.frame_rate, 60);
  EXPECT_EQ(scene.samples_per_second, 960);
  ASSERT_EQ(scene.probes.size(), 2u);
  EXPECT_EQ(scene.probes[0].name, "top-centre");
  EXPECT_EQ(scene.probes[0].point, Vector3d(0, 0, 0.1));
  EXPECT_EQ(scene.probes[0].direction, Vector3d::UnitZ());
  EXPECT_EQ(scene.probes[1].name, "side-middle");
  EXPECT_EQ(scene.probes[1].point, Vector3d(0.05, 0, 0));
  EXPECT_EQ(scene.probes[1].direction, Vector3d::UnitX());
}

TEST(CylinderCompression, lasts_ten_periods_in_the_longer_profiles) {
  EXPECT_EQ(cylinder("standard").duration, 0.96881);
  EXPECT_EQ(cylinder("full").duration, 0.96881);
  EXPECT_EQ(cylinder("full").profile, "full");
  EXPECT_THROW(cylinder("overnight"), std::invalid_argument);
}

TEST(CylinderCompression, truth_and_study) {
  const Scene scene = cylinder();
  EXPECT_LE(scene.truth.relative_tolerance, 1e-4);
  EXPECT_EQ(scene.truth.finer, (Resolution{4, {1, 4}}));
  EXPECT_EQ(scene.truth.coarser, (Resolution{3, {1, 4}}));
  EXPECT_EQ(scene.study.methods, (std::vector<std::string>{"eigenmodes", "static-correction", "linear", "quadratic"}));
  EXPECT_EQ(scene.study.modes, (std::vector<int>{0, 2, 4, 8, 16, 32, 64, 128}));
  std::set<std::string> full_order, reduced;
  for (const Rival& rival : scene.study.rivals) full_order.insert(rival.integrator);
  for (const Stepping& stepping : scene.study.steppings) reduced.insert(stepping.integrator);
  EXPECT_EQ(full_order, (std::set<std::string>{"central-difference", "newmark", "sundials"}));
  EXPECT_EQ(reduced,
            (std::set<std::string>{"central-difference", "explicit-euler", "newmark", "sundials", "symplectic-euler"}));
}

TEST(CylinderCompression, checks_say_why) {
  const Scene scene = cylinder();
  ASSERT_GE(scene.checks.size(), 2u);
  for (const Check& check : scene.checks) {
    EXPECT_NE(check.at_most.has_value(), check.at_least.has_value());
    EXPECT_GT(check.why.size(), 40u);
  }
}

}  // namespace
}  // namespace mb
