// What the report says of a case: contacts, beams and plates by theory.
#include <gmock/gmock.h>

#include <cmath>

#include "cases/contract/touchdown.h"
#include "reports/case_words.h"
#include "reports/definitions.h"
#include "reports/number.h"
#include "reports/orders.h"
#include "reports/synthetic.h"

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A ball of 60 mm radius, half a metre above the floor.
Scene drop() {
  Scene scene = synthetic::scene();
  scene.bodies[0].name = "ball";
  scene.bodies[0].shape = Sphere{0.06};
  scene.bodies[0].material = {.youngs_modulus = 1e6, .poissons_ratio = 0.45, .density = 1100};
  scene.bodies[0].resolution = {3, {2}, 1};
  scene.bodies[0].pose.position = {0, 0, 0.56};
  scene.gravity = {0, 0, -9.81};
  scene.duration = 0.4;
  scene.obstacles = {{"floor", {HalfSpace{}, 0, {}}}};
  scene.contacts = {{"ball", "floor", 0}};
  return scene;
}

std::string line(const Scene& scene) {
  ReportInput input;
  input.scenes = {scene};
  return case_line(evaluate(input), scene);
}

TEST(ContactLine, NamesWhatPressesInThePlaceOfLoads) {
  const Scene scene = drop();
  const std::string text = line(scene);
  EXPECT_THAT(text, Not(HasSubstr("No loads")));
  EXPECT_THAT(text, HasSubstr("mesh Q3 2 graded 1. Gravity (0, 0, -9.81) m/s^2. ball starts at (0, 0, 0.56) m, at "
                              "rest. Obstacle floor: half-space with normal (0, 0, 1) through (0, 0, 0) m. Contact of "
                              "ball with floor: penalty per area, k = "));
  EXPECT_THAT(text, HasSubstr("undamped, frictionless; expected radius a = "));
}

// Free fall of half a metre, and k = 100 E*/a.
TEST(ContactLineVerification, HasSpeedAndTimeOfFreeFallAndTheStiffnessOfItsRadius) {
  const Scene scene = drop();
  const std::string text = line(scene);
  const double g = 9.81, fall = 0.5, modulus = 1e6 / (1 - 0.45 * 0.45);
  EXPECT_THAT(text, HasSubstr("approach at " + format_number(std::sqrt(2 * g * fall)) + " m/s, first touch at " +
                              format_number(std::sqrt(2 * fall / g)) + " s."));
  const double radius = touchdown(scene, scene.bodies[0]).meetings.at(0).size.radius;
  EXPECT_THAT(text, HasSubstr("k = " + format_number(100 * modulus / radius) + " Pa/m (auto)"));
  EXPECT_THAT(text, HasSubstr("expected radius a = " + format_number(radius) + " m"));
}

TEST(CaseWords, SayHowABodyIsTapered) {
  EXPECT_EQ(describe(Shape(TaperedSuperquadric{{{0.1, 0.2, 0.3}, 1, 0.5}, 0.4})),
            "superquadric of semi-axes 0.1, 0.2, 0.3 m and exponents 1, 0.5, tapered by 0.4");
}

TEST(ContactLine, SaysWhatIsGiven) {
  Scene scene = drop();
  scene.bodies[0].twist = {{0, 0, -2}, {0, 12, 0}};
  scene.contacts[0] = {"ball", "floor", 1e9, 0.5, 0.3, 1e-3};
  const Pose tilted{{0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(pi / 2, Vector3d::UnitX()))};
  scene.obstacles.push_back({"wall", {HalfSpace{}, 0, tilted}});
  scene.obstacles.push_back({"step", {Shape{Box{{1, 0.4, 0.5}}}, 0.01, {{3, 0, 0.25}, tilted.orientation}}});
  const std::string text = line(scene);
  EXPECT_THAT(text,
              HasSubstr("ball starts at (0, 0, 0.56) m, with velocity (0, 0, -2) m/s and spin (0, 12, 0) rad/s."));
  EXPECT_THAT(text, HasSubstr("k = 1e+09 Pa/m (given), damping 0.5 s/m, friction 0.3 regularised at 0.001 m/s;"));
  EXPECT_THAT(text, HasSubstr("Obstacle wall: half-space with normal (0, -1, 0) through (0, 0, 0) m."));
  EXPECT_THAT(text, HasSubstr("Obstacle step: box of 1 x 0.4 x 0.5 m, edges rounded by 0.01 m, at (3, 0, 0.25) m, "
                              "turned by 90.0 deg about (1, 0, 0)."));
}

TEST(ContactLine, OfWhatRestsTheSpeedIsOnlyThatOfTheEstimate) {
  Scene scene = drop();
  scene.bodies[0].pose.position.z() = 0.06;  // on the floor
  EXPECT_THAT(line(scene), ::testing::ContainsRegex("m, as of an approach at [0-9.e-]* m/s, first touch at 0 s"));
}

TEST(ContactLine, WhatDoesNotTouchInTimeIsSaid) {
  Scene scene = drop();
  scene.duration = 0.1;
  EXPECT_THAT(line(scene), HasSubstr("no touch within 0.1 s unless deformed."));
}

TEST(ContactLine, OfInvalidScenesLeavesOutWhatIsNotKnown) {
  Scene within = drop(), nowhere = drop();
  within.bodies[0].pose.position.z() = 0.01;  // 5 cm within the floor
  nowhere.obstacles.clear();
  for (const Scene& scene : {within, nowhere}) {
    EXPECT_THAT(line(scene), HasSubstr("Contact of ball with floor: penalty per area, k auto, undamped, "
                                       "frictionless."));
  }
}

// Timoshenko's first example, k = 4/3 E* sqrt(R) of two equal moduli: E* = E/(2 (1 - nu^2)).
TEST(ContactLineVerification, AStrikerHasMassAndSpeedAndHertzItsOwnUnit) {
  Scene scene = synthetic::scene();
  Body& body = scene.bodies[0];
  body.name = "beam";
  body.shape = Box{{0.1535, 0.01, 0.01}};
  body.material = {.youngs_modulus = 2.157463e11, .poissons_ratio = 0.3, .density = 7960};
  body.theory = Theory::euler_bernoulli;
  body.resolution = {1, {319}};
  scene.obstacles = {{"ball", {Shape{Sphere{0.01}}, 0, {{0, 0, 0.015}}}, Striker{0.0333, 0.01, 2.157463e11, 0.3}}};
  scene.contacts = {{.body = "beam", .obstacle = "ball", .stiffness = 0, .law = ContactLaw::hertz}};
  const std::string text = line(scene);
  const double k = 4.0 / 3 * 2.157463e11 / (2 * (1 - 0.09)) * std::sqrt(0.01);
  EXPECT_THAT(text, HasSubstr("undamped; 319 half waves. "));
  EXPECT_THAT(text, HasSubstr("it strikes with mass 0.0333 kg and speed 0.01 m/s along -z; E = 2.15746e+11 Pa"));
  EXPECT_THAT(text, HasSubstr("Hertz's law, lumped, k = " + format_number(k) + " N/m^1.5 (auto)"));
  EXPECT_THAT(text, HasSubstr("approach at 0.0100 m/s, first touch at 0 s."));
}

TEST(ContactLine, NamesAnotherBodyThatIsMet) {
  Scene scene = drop();
  Body board = scene.bodies[0];
  board.name = "board";
  board.shape = Box{{1, 0.5, 0.1}};
  board.pose.position = {0, 0, -0.05};
  board.supports = {{Support::Kind::fixed, {"z-min", {}}}};
  board.settled = true;
  scene.bodies.push_back(board);
  scene.obstacles.clear();
  scene.contacts[0].obstacle = "board";
  const std::string text = line(scene);
  EXPECT_THAT(text, HasSubstr("Contact of ball with board"));
  EXPECT_THAT(text, HasSubstr("first touch at"));
  EXPECT_THAT(text, HasSubstr("at rest, bent by its weight"));
}

TEST(ContactLine, GravityAndSpeedStandWithoutContact) {
  Scene scene = synthetic::scene();
  EXPECT_TRUE(contact_sentences(scene).empty());
  scene.bodies[0].twist.angular_velocity = {0, 0, 3};
  EXPECT_THAT(contact_sentences(scene), ::testing::ElementsAre("cylinder starts with spin (0, 0, 3) rad/s"));
}

TEST(HalfWaves, StandInThePlaceOfTheMeshOfBeamsAndPlates) {
  EXPECT_EQ(describe_mesh({1, {5}}, Theory::euler_bernoulli), "5 half waves");
  EXPECT_EQ(describe_mesh({1, {1}}, Theory::euler_bernoulli), "1 half wave");
  EXPECT_EQ(describe_mesh({1, {7, 7}}, Theory::kirchhoff), "7x7 half waves");
  EXPECT_EQ(describe_mesh({1, {5}}, Theory::solid), "Q1 5");
  const Contender rival = synthetic::full(1, {5}, 1e-6);
  EXPECT_EQ(describe(rival, Theory::euler_bernoulli), "5 half waves, newmark, step 1e-06 s");
  EXPECT_EQ(describe_series(rival, Theory::euler_bernoulli), "full order in half waves, newmark");
}

TEST(HalfWaves, AreNamedInEveryTableOfContenders) {
  ReportInput input;
  input.scenes = {synthetic::scene()};
  input.scenes[0].bodies[0].theory = Theory::euler_bernoulli;
  synthetic::grade(input.records, synthetic::full(1, {5}, 1e-6), 1e-3, 2, 1);
  synthetic::grade(input.records, synthetic::reduced("eigenmodes", 8), 2e-3, 1, 1);
  const Evaluation evaluation = evaluate(input);
  const auto names = [](const Sheet& table) {
    for (const auto& row : table.rows) {
      for (const Cell& cell : row) {
        if (cell.text.find("5 half waves") != std::string::npos) return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(names(rivals_table(evaluation)));
  EXPECT_TRUE(names(contenders_table(evaluation)));
  EXPECT_TRUE(names(speed_up_table(evaluation, evaluation.speed_ups)));
  EXPECT_TRUE(names(phases_table(evaluation, evaluation.speed_ups)));
}

// Steps of its own are no floor under what steps in contact: an error that falls with them has its order.
TEST(ContactOrders, OfWhatFliesInClosedFormIsSeenOverItsSteps) {
  ReportInput input;
  for (const double h : {4e-4, 2e-4, 1e-4, 5e-5}) {
    input.records.push_back(
        synthetic::record("displacement-error", 1e6 * h * h, 0, synthetic::stepped("eigenmodes", 8, "exact", h)));
  }
  const std::vector<Curve> all = curves(evaluate(input));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].refinement, Refinement::step);
  EXPECT_NEAR(all[0].observed.order, 2, 1e-12);  // rounding of logarithms
  EXPECT_EQ(all[0].observed.n_points, 4);
}

TEST(Definitions, TellClosedFormsFromStepsInContact) {
  std::map<std::string, std::string> texts;
  for (const Explanation& one : own_words()) texts[one.term] = one.text;
  EXPECT_THAT(texts.at("closed form"), HasSubstr("without contact"));
  EXPECT_THAT(texts.at("closed form, steps in contact"), HasSubstr("time steps"));
  EXPECT_THAT(texts.at("speed-up at 1 % error"), HasSubstr("beam or plate theory do not count"));
}

}  // namespace
}  // namespace mb
