// Free bodies of finite kinematics under loads, in their floating frames, against full order.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/system/exact.h"
#include "modal/bases/eigenmodes.h"
#include "modal/contact/floating_answer.h"
#include "reference/finite_bodies_test.h"
#include "reference/full_order.h"
#include "reference/integrators_test.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

constexpr double T = 0.4;  // [s]

// Pushed at one end by a load that turns with it, at the other by one that does not; strains grow with `size`.
std::shared_ptr<const Scene> pushed(double size) {
  Scene scene = testing::finite_body(Box{{0.4, 0.1, 0.06}}, {5e4 / size, 0.3, 1000}, {1, {3, 1, 1}}, {0, 1e-3});
  testing::load(scene, "x-max", {0, 1e3, 0});
  scene.loads[0].history = Pulse{0.3};
  scene.loads[0].follows = true;
  scene.loads.push_back({"dead", Pulse{0.2, 1, 0.1}, {{"body", testing::face("x-min"), {150, 0, 250}, 0}}});
  scene.duration = T;
  return std::make_shared<const Scene>(scene);
}

Integrator closed_form() {
  return {"exact", "", [](const System& s, const Settings& set, double t) { return exact(s, t, set.load_tolerance); },
          Integrator::Knob::none};
}

Trajectory modal(const Model& model, int n, bool corrected, RotationCoupling rotation, const VectorXd& times) {
  const Modes modes = lowest_modes(model.bodies[0].full->system(), n, physical_shift(model.scene->bodies[0]));
  Reduction reduction;
  answer_in_frames(reduction, model, {&modes, 1}, corrected);
  Settings settings;
  settings.rotation = rotation;
  return reduction.in_contact(closed_form(), settings)->simulate({times});
}

double difference(const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() / b.norm(); }

// Every mode of the mesh: what is left apart is the square of the strain.
TEST(TurningBodies, WithAllModesMoveAsInFullOrder) {
  const VectorXd times = VectorXd::LinSpaced(41, 0, T);
  const auto off = [&](double size, RotationCoupling rotation) {
    const Model model = build_model(pushed(size));
    const int all = static_cast<int>(model.bodies[0].full->system().M.rows()) - 6;
    const Trajectory answer = modal(model, all, false, rotation, times);
    const Trajectory full =
        full_order()->prepare(model, {.relative_tolerance = 1e-7}, testing::arkode())->simulate({times});
    EXPECT_EQ(answer.status, Status::ok);
    EXPECT_EQ(full.status, Status::ok);
    EXPECT_EQ(answer.bodies[0].contact.force.size(), 0);
    return difference(answer.bodies[0].displacement, full.bodies[0].displacement);
  };
  const double strong = off(0.3, RotationCoupling::coupled), weak = off(0.1, RotationCoupling::coupled);
  EXPECT_LT(strong, 4e-4);  // 2.0e-4 was seen, 2.1e-5 of a third of the strain, 3.6e-3 without coupling
  EXPECT_LT(weak, strong / 4);
  EXPECT_GT(off(0.3, RotationCoupling::rigid), 2 * strong);
}

// The static response brings a few modes nearer to all.
TEST(TurningBodies, AreCorrectedStatically) {
  const VectorXd times = VectorXd::LinSpaced(41, 0, T);
  const Model model = build_model(pushed(0.3));
  const int all = static_cast<int>(model.bodies[0].full->system().M.rows()) - 6;
  const auto deformed = [&](int n, bool corrected) {
    return modal(model, n, corrected, RotationCoupling::coupled, times).bodies[0].strain;
  };
  const MatrixXd best = deformed(all, false);
  EXPECT_LT(difference(deformed(6, true), best), 0.3 * difference(deformed(6, false), best));
  EXPECT_LT(difference(deformed(all, true), best), 1e-6);  // nothing is left to correct
}

TEST(TurningBodies, TakeTheClosedFormAlone) {
  const Model model = build_model(pushed(1));
  const Modes modes = lowest_modes(model.bodies[0].full->system(), 4, physical_shift(model.scene->bodies[0]));
  Reduction reduction;
  answer_in_frames(reduction, model, {&modes, 1}, false);
  EXPECT_THROW(reduction.in_contact(testing::average_acceleration(), {.time_step = 1e-3}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
