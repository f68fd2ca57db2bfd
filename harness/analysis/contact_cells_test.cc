// Cells of a ball that falls onto a soft layer, and what they say where one of their two runs fails.
#include "harness/analysis/contact_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "harness/analysis/contact_variants.h"

namespace mb {
namespace {

Scene falling_ball() {
  Scene scene = one_body(Sphere{0.06}, {1e6, 0.3, 1100, {}}, {2, {1}});
  scene.loads.clear();
  scene.probes.clear();
  scene.gravity = {0, 0, -9.81};
  scene.bodies[0].damping.beta = 1e-4;
  scene.bodies[0].pose.position = {0, 0, 0.11};
  scene.obstacles = {{"floor", {HalfSpace{}, 0, {}}}};
  scene.contacts = {{scene.bodies[0].name, "floor", 2e6}};
  scene.duration = 0.13;
  scene.samples_per_second = 4800;
  scene.frame_rate = 60;
  scene.study.methods = {"eigenmodes"};
  scene.study.modes = {6};
  scene.study.contact_steps = {2e-4};
  return scene;
}

class ContactCellTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto scene = std::make_shared<const Scene>(falling_ball());
    const TruthSet truth;
    std::unique_ptr<Model> model;
    const AnalysisContext context{scene, catalogue(), truth, [&](const Resolution& r) -> const Model& {
                                    model = std::make_unique<Model>(make_model(scene, r));
                                    return *model;
                                  }};
    const auto layers = varied_layers(context, ContactVariants(context), "eigenmodes", 6, {1, 0.1});
    own() = layers[0], soft() = layers[1];
  }
  static const Catalogue& catalogue() {
    static const Catalogue all = default_catalogue();
    return all;
  }
  static VariedLayer& own() {
    static VariedLayer layer;
    return layer;
  }
  static VariedLayer& soft() {
    static VariedLayer layer;
    return layer;
  }
  // At the least step of the maps.
  static ContactCell cell(const VariedLayer& layer) {
    return contact_cell(layer, catalogue().integrator("newmark"), contact_step(layer.impact, contact_steps_tried - 1));
  }
};

// Which takes many times as long as the same ball's impact on a hard floor.
TEST_F(ContactCellTest, OfASoftLayerHoldTheWholeImpact) {
  EXPECT_GT(soft().impact.duration, 2 * own().encounter.meeting.size.duration);
  EXPECT_NEAR(soft().reference.duration / soft().impact.duration, 1, 0.1);
  const double m = soft().encounter.mass, v = soft().encounter.meeting.size.speed;
  EXPECT_NEAR(soft().reference.impulse / (2 * m * v), 1, 0.01);
  const ContactCell one = cell(soft());
  EXPECT_EQ(one.found, StepClass::stable);
  EXPECT_LT(one.error() + one.bar(), 0.01);
}

// So fast that no run holds what it does to the layer.
std::shared_ptr<const FloatingBases> lost(FloatingBases bases) {
  bases.front().start.v *= 1e100;
  return std::make_shared<const FloatingBases>(std::move(bases));
}

TEST_F(ContactCellTest, OfARoundBodyInSmallStepsAreStableAndKnownWell) {
  const ContactCell one = cell(own());
  ASSERT_GT(own().reference.duration, 0);  // the run holds the whole impact
  EXPECT_EQ(one.found, StepClass::stable);
  EXPECT_NEAR(one.energy, 1, 1e-3);          // average acceleration gains none but where the layer opens
  EXPECT_LT(one.error() + one.bar(), 0.01);  // a fifth of what "stable" asks for, at 1/1024 of the contact
  EXPECT_GT(one.bar_of_peak, 0);
}

TEST_F(ContactCellTest, WhoseNudgedRunFailsAreKnownByNoBarAndNotStable) {
  VariedLayer layer = own();
  layer.nudged = lost(*layer.nudged);
  const ContactCell one = cell(layer);
  EXPECT_EQ(one.found, StepClass::inaccurate);
  EXPECT_EQ(one.energy, cell(own()).energy);
  EXPECT_TRUE(std::isinf(one.bar()));
  EXPECT_TRUE(std::isinf(one.bar_of_energy));
}

TEST_F(ContactCellTest, WhoseOwnRunFailsAreUnstableWithoutAnError) {
  VariedLayer layer = own();
  layer.bases = lost(*layer.bases);
  const ContactCell one = cell(layer);
  EXPECT_EQ(one.found, StepClass::unstable);
  EXPECT_TRUE(std::isinf(one.energy));
  EXPECT_TRUE(std::isinf(one.error()));
}

}  // namespace
}  // namespace mb
