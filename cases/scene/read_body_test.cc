// Bodies, supports and loads beyond those of cylinder-compression.
#include <gtest/gtest.h>

#include "cases/scene/case_files.h"

namespace mb {
namespace {

using test::cylinder_text;
using test::problems_of_text;
using test::with;

const std::string isotropic = "youngs_modulus = 2e4       # [Pa]\npoissons_ratio = 0.45";

std::string with_supports(const std::string& supports) {
  return with(cylinder_text(), "[body.resolution]", supports + "\n[body.resolution]");
}

std::string support(const std::string& kind, const std::string& face, const std::string& more = "") {
  return "[[body.support]]\nkind = \"" + kind + "\"\nface = \"" + face + "\"\n" + more + "\n";
}

const std::string drive =
    "direction = [3, 4, 0]\nacceleration = { kind = \"pulse\", duration = 0.1, amplitude = 9.81 }";

std::string orthotropy(const std::string& youngs, const std::string& poissons) {
  return with(cylinder_text(), isotropic,
              "orthotropy = { youngs_moduli = " + youngs + ", poissons_ratios = " + poissons +
                  ", shear_moduli = [7e3, 8e3, 9e3] }");
}

// Without the load that would push against a driven or fixed face.
std::string without_load(std::string text) {
  const std::size_t at = text.find("[[load]]");
  return text.erase(at, text.find("[[probe]]") - at);
}

TEST(ReadMaterial, orthotropy_replaces_the_isotropic_moduli) {
  const Material material = test::read(orthotropy("[1e4, 2e4, 3e4]", "[0.3, 0.2, 0.1]")).bodies[0].material;
  ASSERT_TRUE(material.orthotropy.has_value());
  EXPECT_EQ(material.orthotropy->youngs_moduli, Vector3d(1e4, 2e4, 3e4));
  EXPECT_EQ(material.orthotropy->poissons_ratios, Vector3d(0.3, 0.2, 0.1));
  EXPECT_EQ(material.orthotropy->shear_moduli, Vector3d(7e3, 8e3, 9e3));
  EXPECT_EQ(material.youngs_modulus, 3e4) << "a scale: the largest";
  EXPECT_EQ(material.density, 1100);
  EXPECT_FALSE(test::read(cylinder_text()).bodies[0].material.orthotropy.has_value());
}

// nu_xy^2 < E_x/E_y = 4 with nu_xy alone: 1.99 is stable, 2.01 is not. With equal moduli and ratios nu the determinant
// (1 + nu)^2 (1 - 2 nu) vanishes at nu = 1/2.
TEST(ReadMaterial, refuses_an_orthotropy_that_gives_way) {
  EXPECT_EQ(problems_of_text(orthotropy("[4e4, 1e4, 1e4]", "[0, 0, 1.99]")), "");
  EXPECT_EQ(problems_of_text(orthotropy("[1e4, 1e4, 1e4]", "[0.499, 0.499, 0.499]")), "");
  for (const std::string& text :
       {orthotropy("[4e4, 1e4, 1e4]", "[0, 0, 2.01]"), orthotropy("[1e4, 1e4, 1e4]", "[0.501, 0.501, 0.501]")}) {
    EXPECT_NE(problems_of_text(text).find("the compliance is not positive definite"), std::string::npos);
  }
}

// One rounding below 1/2, and above -1, the range holds; K does not.
TEST(ReadMaterial, refuses_ratios_that_leave_the_stiffness_no_digits) {
  const auto problems = [](const std::string& ratio) {
    return problems_of_text(with(cylinder_text(), "poissons_ratio = 0.45", "poissons_ratio = " + ratio));
  };
  EXPECT_EQ(problems("0.49999999"), "");
  EXPECT_EQ(problems("-0.9999999"), "");
  for (const char* near : {"0.49999999999999994", "0.499999996", "-0.9999999999999999"})
    EXPECT_NE(problems(near).find("1 - 2 nu and 1 + nu must be at least 1e-8"), std::string::npos) << near;
}

TEST(ReadDamping, takes_ratios_of_the_first_modes) {
  const auto with_ratios = [](const std::string& ratios) {
    return with(cylinder_text(), "alpha = 1.5733", "alpha = 1.5733\nratios = " + ratios);
  };
  const Body body = test::read(with_ratios("[0.02, 0, 1.5]")).bodies[0];
  EXPECT_EQ(body.damping_ratios, (std::vector<double>{0.02, 0, 1.5}));
  EXPECT_EQ(body.damping.alpha, 1.5733);
  EXPECT_TRUE(test::read(cylinder_text()).bodies[0].damping_ratios.empty());
  std::string many = "[0";
  for (int i = 0; i < 256; ++i) many += ", 0";
  EXPECT_NE(problems_of_text(with_ratios(many + "]")).find("has 257 entries"), std::string::npos);
  EXPECT_NE(problems_of_text(with_ratios("[]")).find("has 0 entries"), std::string::npos);
}

TEST(ReadSupport, a_driven_body_needs_no_load) {
  const Scene scene = test::read(without_load(with_supports(support("driven", "z-min", drive))));
  EXPECT_TRUE(scene.loads.empty());
  const Support& driven = scene.bodies[0].supports.at(0);
  EXPECT_EQ(driven.kind, Support::Kind::driven);
  ASSERT_TRUE(driven.drive.has_value());
  EXPECT_NEAR((driven.drive->direction - Vector3d(0.6, 0.8, 0)).norm(), 0, 1e-15);
  EXPECT_EQ(driven.drive->acceleration, History(Pulse{0.1, 9.81, 0}));
  EXPECT_NE(problems_of_text(without_load(cylinder_text())).find("missing key 'load'"), std::string::npos);
  EXPECT_NE(problems_of_text(without_load(with_supports(support("fixed", "z-min")))).find("nothing would move"),
            std::string::npos);
}

TEST(ReadSupport, a_wrong_driven_support_is_not_a_missing_load) {
  const std::string problems = problems_of_text(without_load(with_supports(support("driven", "z-min"))));
  EXPECT_NE(problems.find("missing key 'acceleration'"), std::string::npos);
  EXPECT_EQ(problems.find("'load'"), std::string::npos);
}

TEST(ReadSupport, driven_faces_of_a_body_move_as_one_base) {
  const auto two = [](const std::string& other) {
    return problems_of_text(
        without_load(with_supports(support("driven", "z-min", drive) + support("driven", "z-max", other))));
  };
  EXPECT_EQ(two(drive), "");
  EXPECT_EQ(two("direction = [6, 8, 0]\nacceleration = { kind = \"pulse\", duration = 0.1, amplitude = 9.81 }"), "");
  EXPECT_NE(two("direction = [3, -4, 0]\nacceleration = { kind = \"pulse\", duration = 0.1, amplitude = 9.81 }")
                .find("the same direction"),
            std::string::npos);
  EXPECT_NE(two("direction = [3, 4, 0]\nacceleration = { kind = \"pulse\", duration = 0.1, amplitude = 9.82 }")
                .find("the same acceleration"),
            std::string::npos);
}

TEST(ReadSupport, a_diaphragm_leaves_the_normal_free) {
  const std::string text = with_supports(support("diaphragm", "z-max") + support("mean", "z-max"));
  const Scene scene = test::read(text);
  EXPECT_EQ(scene.bodies[0].supports.at(0).kind, Support::Kind::diaphragm);
  EXPECT_EQ(scene.bodies[0].supports.at(1).kind, Support::Kind::mean);
  EXPECT_EQ(problems_of_text(with(text, "traction = [0, 0, -400]", "pressure = 400")), "") << "does work";
  EXPECT_NE(problems_of_text(with(text, "[0, 0, -400]", "[1, 2, 0]")).find("a diaphragm support holds that face"),
            std::string::npos);
  EXPECT_NE(problems_of_text(with_supports(support("diaphragm", "z-max") + support("sliding", "z-max")))
                .find("supported twice"),
            std::string::npos);
}

TEST(ReadLoad, pressure_acts_on_any_face_that_is_not_held) {
  const std::string text =
      with(cylinder_text(), "face     = \"z-max\"\ntraction = [0, 0, -400]", "face = \"side\"\npressure = -400");
  const Traction side = test::read(text).loads[0].tractions[0];
  EXPECT_EQ(side.patch.face, "side");
  EXPECT_EQ(side.pressure, -400);
  for (const char* kind : {"fixed", "driven"}) {
    const std::string held =
        with(text, "[body.resolution]",
             support(kind, "side", kind == std::string("driven") ? drive : "") + "[body.resolution]");
    EXPECT_NE(problems_of_text(held).find("the pressure on face 'side' does no work"), std::string::npos) << kind;
  }
}

TEST(ReadResolution, a_cylinder_may_be_one_block_across) {
  const Scene scene = test::read(with(cylinder_text(), "cells  = [1, 4]", "cells = [0, 4]"));
  EXPECT_EQ(scene.bodies[0].resolution, (Resolution{4, {0, 4}}));
  EXPECT_NE(problems_of_text(with(cylinder_text(), "cells  = [1, 4]", "cells = [1, 0]")).find("only the edge splits"),
            std::string::npos);
}

const std::string held = support("fixed", "side");

TEST(ReadDashpot, is_of_linear_solids_that_supports_hold) {
  const std::string dashpot = "[[body.dashpot]]\nface = \"z-max\"\ndirection = [0, 3, 0]\ndamping = 2.5\n";
  const std::string text = with(cylinder_text(), "[body.resolution]", held + dashpot + "[body.resolution]");
  const Body body = test::read(text).bodies[0];
  ASSERT_EQ(body.dashpots.size(), 1u);
  EXPECT_EQ(body.dashpots[0].patch.face, "z-max");
  EXPECT_EQ(body.dashpots[0].direction, Vector3d(0, 1, 0));
  EXPECT_EQ(body.dashpots[0].damping, 2.5);
  EXPECT_NE(canonical(test::read(text)).find("dashpot face z-max 0 1 0 2.5"), std::string::npos);
  EXPECT_NE(problems_of_text(with_supports(dashpot)).find("no support holds the body"), std::string::npos);
  EXPECT_NE(
      problems_of_text(with(text, "[[body.support]]", "kinematics = \"finite\"\n[[body.support]]")).find("kinematics"),
      std::string::npos);
  EXPECT_NE(problems_of_text(with(text, "damping = 2.5", "damping = -1")).find("outside [1e-12, 1e15] N s/m"),
            std::string::npos);
  EXPECT_NE(problems_of_text(with(text, "face = \"z-max\"\ndirection", "face = \"x-min\"\ndirection")).find("x-min"),
            std::string::npos);
}

TEST(ReadMaterial, inclusions_are_boxes_of_another_stiffness) {
  const std::string inclusion =
      "[[body.material.inclusion]]\ncentre = [0, 0, 0.05]\nsize = [0.02, 0.02, 0.1]\nstiffness_factor = 1e6\n";
  const std::string text = with(cylinder_text(), "[body.resolution]", inclusion + "[body.resolution]");
  const Scene scene = test::read(text);
  ASSERT_EQ(scene.bodies[0].material.inclusions.size(), 1u);
  EXPECT_EQ(stiffness_factor(scene.bodies[0].material, {0.009, 0, 0.01}), 1e6);
  EXPECT_EQ(stiffness_factor(scene.bodies[0].material, {0.011, 0, 0.01}), 1);
  EXPECT_NE(canonical(scene).find("inclusion 0 0 0.05"), std::string::npos);
  EXPECT_NE(problems_of_text(with(text, "1e6", "1e9")).find("outside [1e-8, 100000000]"), std::string::npos);
}

TEST(ReadResolution, boxes_may_be_biased_and_distorted) {
  const std::string wrong = with(cylinder_text(), "cells  = [1, 4]", "cells = [1, 4]\nbias = [1, 1, 2]");
  EXPECT_NE(problems_of_text(wrong).find("'bias' is of boxes that are solids"), std::string::npos);
  const std::string distorted = with(cylinder_text(), "cells  = [1, 4]", "cells = [1, 4]\ndistorted = 0.1");
  EXPECT_NE(problems_of_text(distorted).find("'distorted' is of boxes that are solids"), std::string::npos);
  EXPECT_NE(problems_of_text(with(distorted, "distorted = 0.1", "distorted = 0.5")).find("outside [0, 0.4]"),
            std::string::npos);
  EXPECT_EQ(to_string(Resolution{2, {2, 2, 4}, 0, {1, 1, 20}, 0.2}), "Q2 2x2x4 bias 1x1x20 distorted 0.2");
}

}  // namespace
}  // namespace mb
