// Where a ball of jelly first touches a floor, and what the modes and static shapes of its mesh make of that place.
#include "harness/analysis/encounter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "harness/study/truth.h"

namespace mb {
namespace {

constexpr double radius = 0.06, E = 1e6, nu = 0.3;  // [m], [Pa], [-]
constexpr double beta = 1e-6;                       // [s] so little that no step of a thousandth of a second sees it

Scene ball_on_floor() {
  Scene scene = one_body(Sphere{radius}, {E, nu, 1100}, {.degree = 2, .cells = {1}, .graded = 2});
  Body& ball = scene.bodies[0];
  ball.damping.beta = beta;
  ball.pose.position = {0, 0, radius + 0.01};
  ball.twist.velocity = {0, 0, -1};
  scene.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({.body = ball.name, .obstacle = "floor", .stiffness = 0});  // auto: k a/E* = 100
  scene.duration = 0.05;
  scene.study.modes = {8};
  scene.study.contact_steps = {2e-4};
  return scene;
}

// The layer at the first touch in series with static shapes, or not.
struct Touched {
  PressedModes pressed_by(const std::string& method) const {
    const ImpactOnLayer impact = impact_on_layer(encounter, 1);
    PressedModes found = pressed(variants, encounter, 8, impact);
    found.yields = static_yields(*variants.bases(*scene, {method, 8, 2e-4}), encounter, impact.radius);
    return found;
  }

  std::shared_ptr<const Scene> scene = std::make_shared<const Scene>(ball_on_floor());
  Catalogue catalogue = default_catalogue();
  TruthSet none;
  std::unique_ptr<Model> made;
  AnalysisContext context{scene, catalogue, none, [this](const Resolution& mesh) -> const Model& {
                            made = std::make_unique<Model>(make_model(scene, mesh));
                            return *made;
                          }};
  ContactVariants variants{context};
  Encounter encounter = first_encounter(*scene);
};

// m v^2/2 of a rigid ball is taken by pi k R g^3/3, of a rigid block by k A g^2/2: integrated by small steps.
TEST(Encounter, ASoftLayerMakesTheImpactLongerAndWider) {
  Encounter encounter = first_encounter(ball_on_floor());
  ContactSize& size = encounter.meeting.size;
  const ImpactOnLayer own = impact_on_layer(encounter, 1);
  EXPECT_EQ(own.radius, size.radius) << "k a/E* = 100: the ball's own";
  EXPECT_EQ(own.duration, size.duration);
  for (const bool is_round : {true, false}) {
    if (!is_round) size.curvature = 0;
    const ImpactOnLayer soft = impact_on_layer(encounter, 1e-4);
    const double R = 1 / size.curvature, A = pi * size.radius * size.radius, h = soft.duration * 1e-5;
    double g = 0, v = size.speed, t = 0, deepest = 0;
    for (; g >= 0; t += h) {
      g += h * v;
      v -= h * soft.stiffness * (is_round ? pi * R * g * g : A * g) / encounter.mass;
      deepest = std::max(deepest, g);
    }
    EXPECT_NEAR(soft.duration / t, 1, 1e-4) << is_round;
    EXPECT_GT(soft.duration, 2 * size.duration) << is_round;
    EXPECT_NEAR(soft.radius / (is_round ? std::sqrt(2 * R * deepest) : size.radius), 1, 1e-4);
  }
}

// Of a half-space that is pressed evenly over a disc the mean yields by 16/(3 pi^2) F/(E* a) = 0.54 F/(E* a) (Johnson
// 1985, Contact Mechanics, sect. 3.4); eight modes have a part of it.
TEST(Encounter, StaticShapesYieldNearlyAsAHalfSpaceDoes) {
  const Touched at;
  EXPECT_TRUE(at.pressed_by("eigenmodes").yields.empty());
  const std::vector<StaticYield> yields = at.pressed_by("static-correction").yields;
  ASSERT_EQ(yields.size(), 1u);
  const double scale = E / (1 - nu * nu) * at.encounter.meeting.size.radius;
  EXPECT_GT(yields[0].c * scale, 0.3);
  EXPECT_LT(yields[0].c * scale, 16 / (3 * pi * pi));
  EXPECT_EQ(yields[0].beta, beta);
}

// A layer a hundred times as stiff asks eigenmodes, which all of it presses, for steps a tenth as long. Static shapes
// yield, and it makes next to no difference: 1/kappa' = 1/kappa + c with kappa c of a hundred and more.
TEST(Encounter, StepsOfStaticCorrectionAreHardlyLimitedByTheLayer) {
  const Touched at;
  const PressedModes plain = at.pressed_by("eigenmodes"), corrected = at.pressed_by("static-correction");
  for (const char* scheme : {"exact", "symplectic-euler", "central-difference"}) {
    const auto limit = [&](PressedModes pressed, double factor) {
      pressed.kappa *= factor;
      return pressed_limit(pressed, scheme, 8 * at.encounter.meeting.size.duration);
    };
    EXPECT_LT(limit(plain, 100), 0.15 * limit(plain, 1)) << scheme;
    EXPECT_GT(limit(corrected, 100), 0.95 * limit(corrected, 1)) << scheme;
    EXPECT_GT(limit(corrected, 1), 2 * limit(plain, 1)) << scheme;
  }
}

}  // namespace
}  // namespace mb
