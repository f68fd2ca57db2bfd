// Obstacles, contacts, and what goes with them.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/case_files.h"

namespace mb {
namespace {

using test::contact_text;
using test::cylinder_text;
using test::problems_of_text;
using test::with;

bool says(const std::string& text, const std::string& message) {
  return problems_of_text(text).find(message) != std::string::npos;
}

const std::string floor_shape = "shape = { kind = \"half-space\" }";

// The text without one [[table]] and all of it up to the next blank line; the table is found by one of its lines.
std::string without_table(std::string text, const std::string& line) {
  const std::size_t at = text.rfind("\n[[", text.find(line)) + 1;
  return text.erase(at, text.find("\n\n", at) + 2 - at);
}

TEST(ReadContact, takes_what_the_file_states) {
  const Scene scene = test::read(contact_text());
  EXPECT_EQ(scene.gravity, Vector3d(0, 0, -9.81));
  EXPECT_TRUE(scene.loads.empty());
  ASSERT_EQ(scene.obstacles.size(), 2u);
  EXPECT_EQ(scene.obstacles[1].name, "step");
  const RigidSurface& step = scene.obstacles[1].surface;
  EXPECT_EQ(std::get<Box>(std::get<Shape>(step.shape)).size, Vector3d(1, 0.4, 0.5));
  EXPECT_EQ(step.rounding, 0.01);
  EXPECT_EQ(step.pose.position, Vector3d(0, 0, 0.25));
  ASSERT_EQ(scene.contacts.size(), 2u);
  EXPECT_EQ(scene.contacts[0].obstacle, "floor");
  EXPECT_EQ(scene.contacts[1].body, "ball");
  EXPECT_EQ(scene.contacts[1].obstacle, "step");
  EXPECT_EQ(scene.contacts[1].stiffness, 1e9);
  EXPECT_EQ(scene.contacts[1].damping, 0.1);
  EXPECT_EQ(scene.contacts[1].friction, 0.3);
  EXPECT_EQ(scene.contacts[1].slip_speed, 1e-3);
}

TEST(ReadContact, leaves_out_friction_damping_rounding_and_pose) {
  const Scene scene = test::read(contact_text());
  EXPECT_EQ(scene.contacts[0].stiffness, 0) << "auto";
  EXPECT_EQ(scene.contacts[0].damping, 0);
  EXPECT_EQ(scene.contacts[0].friction, 0);
  const RigidSurface& floor = scene.obstacles[0].surface;
  EXPECT_TRUE(std::holds_alternative<HalfSpace>(floor.shape));
  EXPECT_EQ(floor.rounding, 0);
  EXPECT_TRUE(floor.pose.position.isZero(0));
  EXPECT_EQ(floor.pose.orientation.w(), 1);
}

TEST(ReadContact, stiffness_is_auto_or_a_number) {
  const auto stiff = [](const std::string& value) {
    return with(contact_text(), "stiffness = 1e9", "stiffness = " + value);
  };
  EXPECT_EQ(test::read(stiff("\"auto\"")).contacts[1].stiffness, 0);
  EXPECT_EQ(test::read(stiff("1")).contacts[1].stiffness, 1);
  EXPECT_EQ(test::read(stiff("1e20")).contacts[1].stiffness, 1e20);
  EXPECT_TRUE(says(stiff("0"), "is 0, outside [1, 1e20] Pa/m"));
  EXPECT_TRUE(says(stiff("nan"), "outside [1, 1e20] Pa/m"));
  EXPECT_TRUE(says(stiff("\"Auto\""), "did you mean 'auto'?"));
  EXPECT_TRUE(says(stiff("true"), "must be \"auto\" or a number, not a boolean"));
  EXPECT_TRUE(says(with(contact_text(), "stiffness = 1e9", ""), "missing key 'stiffness' in [[contact]]: \"auto\" or"));
}

TEST(ReadContact, names_what_there_is) {
  EXPECT_TRUE(says(with(contact_text(), "obstacle  = \"step\"", "obstacle = \"stepp\""), "did you mean 'step'?"));
  EXPECT_FALSE(says(with(contact_text(), "obstacle  = \"step\"", "obstacle = \"stepp\""), "no [[contact]] names"))
      << "once is enough";
  EXPECT_TRUE(says(with(contact_text(), "obstacle  = \"step\"", "obstacle = \"floor\""),
                   "there is another [[contact]] of body 'ball' and obstacle 'floor'"));
  EXPECT_TRUE(says(without_table(contact_text(), "obstacle  = \"step\""), "no [[contact]] names obstacle 'step'"));
  const std::string stranger =
      with(contact_text(), "body      = \"ball\"\nobstacle  = \"step\"", "body = \"bell\"\nobstacle = \"step\"");
  EXPECT_TRUE(says(stranger, "did you mean 'ball'?"));
}

TEST(ReadObstacle, takes_every_shape) {
  const auto shape = [](const std::string& value) {
    const Scene scene = test::read(with(contact_text(), floor_shape, "shape = { " + value + " }"));
    return std::get<Shape>(scene.obstacles[0].surface.shape);
  };
  EXPECT_EQ(std::get<Sphere>(shape("kind = \"sphere\", radius = 0.3")).radius, 0.3);
  EXPECT_EQ(std::get<Cylinder>(shape("kind = \"cylinder\", radius = 0.3, length = 2")).length, 2);
  const auto stone =
      std::get<Superquadric>(shape("kind = \"superquadric\", semi_axes = [1, 2, 3], exponents = [0.1, 2]"));
  EXPECT_EQ(stone.semi_axes, Vector3d(1, 2, 3));
  EXPECT_EQ(stone.e1, 0.1);
  EXPECT_EQ(stone.e2, 2);
  const auto pear = std::get<TaperedSuperquadric>(
      shape("kind = \"superquadric\", semi_axes = [1, 2, 3], exponents = [1, 2], taper = -0.707"));
  EXPECT_EQ(pear.straight.semi_axes, Vector3d(1, 2, 3));
  EXPECT_EQ(pear.taper, -0.707);
  const std::string hollow = "kind = \"superquadric\", semi_axes = [1, 2, 3], exponents = [1, 2], taper = 0.708";
  EXPECT_TRUE(says(with(contact_text(), floor_shape, "shape = { " + hollow + " }"),
                   "'taper' is 0.708: with exponent e1 = 1 a body is convex up to 0.707"));
}

TEST(ReadObstacle, rounding_leaves_something_of_every_face) {
  const auto rounded = [](const std::string& shape, double radius) {
    return problems_of_text(
        with(contact_text(), floor_shape, "shape = { " + shape + " }\nrounding = " + std::to_string(radius)));
  };
  const std::string flat = "kind = \"cylinder\", radius = 1, length = 0.2";
  const std::string thin = "kind = \"cylinder\", radius = 0.05, length = 2";
  EXPECT_EQ(rounded(flat, 0.099), "");
  EXPECT_NE(rounded(flat, 0.1).find("outside (0, 0.1) m"), std::string::npos);
  EXPECT_EQ(rounded(thin, 0.049), "");
  EXPECT_NE(rounded(thin, 0.05).find("outside (0, 0.05) m"), std::string::npos);
  EXPECT_NE(rounded("kind = \"half-space\"", 0.1).find("'rounding' is of no use"), std::string::npos);
}

TEST(ReadPose, turns_about_an_axis_of_any_length) {
  const Body body = test::read(contact_text()).bodies[0];
  EXPECT_EQ(body.pose.position, Vector3d(0, 0, 5));
  const Vector3d x = body.pose.orientation * Vector3d::UnitX();  // right-handed about y: x turns towards -z
  EXPECT_NEAR((x - Vector3d(std::cos(0.5), 0, -std::sin(0.5))).norm(), 0, 1e-15);
  EXPECT_NEAR(body.pose.orientation.norm(), 1, 1e-15);
  EXPECT_EQ(body.twist.velocity, Vector3d(0, 0, -3.13));
  EXPECT_EQ(body.twist.angular_velocity, Vector3d(0, 12, 0));
  EXPECT_TRUE(says(with(contact_text(), "axis = [0, 2, 0], angle", "angle"), "missing key 'axis' in [body.pose]"));
  EXPECT_TRUE(says(with(contact_text(), "angle = 0.5", "angle = inf"), "outside [-7, 7] rad"));
}

TEST(ReadStart, a_body_without_pose_and_velocity_rests_at_the_origin) {
  std::string text = with(contact_text(), "velocity         = [0, 0, -3.13]", "");
  text = with(text, "pose             = { position = [0, 0, 5], axis = [0, 2, 0], angle = 0.5 }", "");
  text = with(text, "position = [0, 0, 0.25]", "position = [0, 0, -5]");  // obstacles out of its way
  text = with(text, "shape = { kind = \"half-space\" }",
              "shape = { kind = \"half-space\" }\npose = { position = [0, 0, -5] }");
  const Body body = test::read(with(text, "angular_velocity = [0, 12, 0]", "")).bodies[0];
  EXPECT_TRUE(body.pose.position.isZero(0));
  EXPECT_EQ(body.pose.orientation.w(), 1);
  EXPECT_TRUE(body.twist.velocity.isZero(0));
  EXPECT_TRUE(body.twist.angular_velocity.isZero(0));
}

TEST(ContactRules, something_moves) {
  std::string text = with(contact_text(), "gravity = [0, 0, -9.81]", "");
  EXPECT_EQ(problems_of_text(text), "") << "the ball is thrown";
  text = with(text, "velocity         = [0, 0, -3.13]", "");
  EXPECT_EQ(problems_of_text(text), "") << "it spins";
  text = with(text, "angular_velocity = [0, 12, 0]", "");
  EXPECT_TRUE(says(text, "nothing would move"));
  EXPECT_FALSE(says(text, "[[load]]")) << "which would be refused";
  EXPECT_FALSE(says(with(text, "source  =", "gravity = 9.81\nsource ="), "nothing would move")) << "gravity is wrong";
  EXPECT_EQ(problems_of_text(with(text, "source  =", "gravity = [0, 0, 1]\nsource =")), "");
}

TEST(ContactRules, contact_alone_takes_its_keys) {
  const std::pair<const char*, const char*> additions[] = {
      {"source  =", "gravity = [0, 0, 0]\nsource ="},
      {"[body.shape]", "[body.pose]\n[body.shape]"},
      {"[body.shape]", "[body.pose]\nposition = [0, 0, 1]\n[body.shape]"},
      {"[body.shape]", "velocity = [0, 0, 1]\n[body.shape]"},
      {"[body.shape]", "angular_velocity = [0, 0, 1]\n[body.shape]"},
      {"[study]", "[study]\ncontact_steps = [1e-4]"},
      {"[profile.full]", "[profile.full]\ncontact_steps = [1e-4]"},
      {"source  =", "contact = []\ngravity = [0, 0, 1]\nsource ="},
  };
  for (const auto& [passage, replacement] : additions) {
    EXPECT_TRUE(says(with(cylinder_text(), passage, replacement), "only scenes with contact take it")) << replacement;
  }
  const std::string meant = with(cylinder_text(), "source  =", "contact = 3\ngravity = [0, 0, 1]\nsource =");
  EXPECT_TRUE(says(meant, "'contact' in the case must be"));
  EXPECT_FALSE(says(meant, "only scenes with contact"));
}

TEST(ContactRules, some_things_cannot_be_simulated_together_with_contact) {
  const std::string later = "is understood, but cannot be simulated yet together with contact";
  const std::string load =
      "[[load]]\nname = \"push\"\nhistory = { kind = \"step\" }\n[[load.traction]]\nbody = \"ball\"\n"
      "face = \"surface\"\npressure = 1\n\n[[probe]]";
  EXPECT_TRUE(says(with(contact_text(), "[[probe]]", load), "a load " + later));
  EXPECT_EQ(problems_of_text(with(contact_text(), "source  =", "load = []\nsource =")), "");
  EXPECT_TRUE(says(with(contact_text(), "[body.material]", "[body.damping]\nratios = [0.1]\n[body.material]"),
                   "damping of single modes " + later));
  EXPECT_EQ(problems_of_text(with(contact_text(), "[body.material]", "[body.damping]\nbeta = 1e-4\n[body.material]")),
            "");
  EXPECT_TRUE(says(with(contact_text(), "[body.material]",
                        "[[body.support]]\nkind = \"driven\"\nface = \"surface\"\n[body.material]"),
                   "a driven support " + later))
      << "whatever else is wrong with it";
}

TEST(ContactRules, bodies_of_finite_strain_share_their_mass_damping) {
  const std::string text = test::content(test::cases_folder() / "soft-ball-on-two-by-four.toml");
  EXPECT_EQ(problems_of_text(text), "");
  EXPECT_TRUE(
      says(with(text, "beta = 2e-5  #", "alpha = 4\nbeta = 2e-5  #"),
           "body 'board' has alpha = 4, body 'ball' 0: where one is of finite kinematics, all must have the same"));
}

TEST(ContactRules, a_body_with_supports_starts_at_rest) {
  std::string text =
      with(contact_text(), "[body.material]", "[[body.support]]\nkind = \"mean\"\nface = \"surface\"\n[body.material]");
  EXPECT_TRUE(says(text, "'velocity' in [[body]]: a body with supports starts at rest"));
  EXPECT_TRUE(says(text, "'angular_velocity' in [[body]]: a body with supports starts at rest"));
  text = with(text, "velocity         = [0, 0, -3.13]", "");
  text = with(text, "angular_velocity = [0, 12, 0]", "");
  EXPECT_EQ(problems_of_text(text), "") << "gravity moves it";
}

TEST(ReadGraded, meshes_of_bodies_with_contact) {
  const Scene quick = test::read(contact_text());
  EXPECT_EQ(quick.bodies[0].resolution.graded, 3);
  EXPECT_EQ(test::read(contact_text(), "full").bodies[0].resolution.graded, 5);
  EXPECT_EQ(quick.truth.finer.graded, 4);
  EXPECT_EQ(quick.truth.coarser.graded, 3);
  EXPECT_EQ(quick.study.rivals[0].graded, 2);
  EXPECT_EQ(test::read(with(contact_text(), "graded     = 2", "")).study.rivals[0].graded, 0);
  EXPECT_EQ(test::read(with(contact_text(), "graded = 5", "graded = 12"), "full").bodies[0].resolution.graded, 12);
  EXPECT_TRUE(says(with(contact_text(), "graded = 5", "graded = 13"), "is 13, outside [0, 12]"));
}

// 21^3 cells of degree 4 have 1.84e6 degrees of freedom; gradings add some 3e4 each.
TEST(ReadGraded, counts_towards_the_largest_mesh) {
  std::string text =
      with(contact_text(), "kind   = \"sphere\"\nradius = 0.05", "kind = \"box\"\nsize = [0.1, 0.1, 0.1]");
  const auto graded = [&](const char* n) {
    return with(text, "degree = 2, cells = [2], graded = 3",
                std::string("degree = 4, cells = [21, 21, 21], graded = ") + n);
  };
  EXPECT_FALSE(says(graded("1"), "degrees of freedom: at most 2000000"));
  EXPECT_TRUE(says(graded("12"), "degrees of freedom: at most 2000000"));
}

TEST(ReadGraded, is_of_no_use_without_contact) {
  const auto graded = [](const char* passage, const char* n) {
    return with(cylinder_text(), passage, std::string(passage) + ", graded = " + n);
  };
  EXPECT_EQ(problems_of_text(graded("finer   = { degree = 4", "0")), "");
  EXPECT_TRUE(says(graded("finer   = { degree = 4", "1"), "no [[contact]] names body 'cylinder'"));
  EXPECT_TRUE(says(graded("coarser = { degree = 3", "1"), "no [[contact]] names body 'cylinder'"));
  EXPECT_TRUE(says(with(cylinder_text(), "[body.resolution]", "[body.resolution]\ngraded = 1"),
                   "no [[contact]] names body 'cylinder'"));
  EXPECT_TRUE(
      says(with(cylinder_text(), "[[study.rival]]", "[[study.rival]]\ngraded = 1"), "no [[contact]] names a body"));
}

TEST(ReadGraded, may_be_of_use_where_a_contact_is_misspelt) {
  std::string misspelt = without_table(without_table(contact_text(), "obstacle  = \"floor\""), "name  = \"floor\"");
  misspelt = with(misspelt, "\"ball\"\nobstacle", "\"bal\"\nobstacle");
  EXPECT_TRUE(says(misspelt, "unknown body 'bal'"));
  EXPECT_FALSE(says(misspelt, "of no use")) << "the contact may be meant to name it";
}

TEST(ReadStudy, scenes_with_contact_state_their_steps) {
  EXPECT_EQ(test::read(contact_text()).study.contact_steps, (std::vector<double>{1e-4, 5e-5}));
  EXPECT_EQ(test::read(contact_text(), "full").study.contact_steps, (std::vector<double>{1e-5}));
  EXPECT_TRUE(says(with(contact_text(), "contact_steps = [1e-4, 5e-5]", ""), "missing key 'contact_steps' in [study]"));
  EXPECT_TRUE(says(with(contact_text(), "contact_steps = [1e-5]", "contact_steps = [0]"), "is 0, outside (0, 1] s"));
}

}  // namespace
}  // namespace mb
