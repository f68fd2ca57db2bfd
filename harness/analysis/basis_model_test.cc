#include "harness/analysis/basis_model.h"

#include <gtest/gtest.h>

#include "cases/scene/one_body.h"
#include "harness/analysis/contact_variants.h"
#include "harness/catalogue.h"
#include "harness/study/truth.h"
#include "modal/bases/eigenmodes.h"
#include "modal/contact/contact_shapes.h"

namespace mb {
namespace {

constexpr double tolerance = 1e-7;

// A soft ball just above a floor, or above a board whose ends lie on supports.
Scene falling(bool on_board) {
  Scene scene = one_body(Sphere{0.05}, {1e6, 0.3, 1000}, {2, {1}});
  scene.bodies[0].damping = {0, 1e-4};
  scene.bodies[0].pose.position = {0, 0, 0.0501};
  scene.bodies[0].twist.velocity = {0, 0, -1};
  scene.gravity = {0, 0, -9.81};
  if (on_board) {
    Body board{"board", Box{{0.3, 0.1, 0.02}}, {1e7, 0.3, 500}, {2, 1e-5}, {}, {1, {3, 1, 1}}, {}};
    board.pose.position = {0, 0, -0.01};
    for (const char* face : {"x-min", "x-max"}) board.supports.push_back({Support::Kind::fixed, {face, {}}});
    board.settled = true;
    scene.bodies.push_back(board);
  } else {
    scene.obstacles.push_back({"board", {HalfSpace{}, 0, {}}});
  }
  scene.contacts.push_back({"body", "board", 1e8});
  scene.duration = 0.01;
  scene.samples_per_second = 4000;
  scene.truth.relative_tolerance = tolerance;
  return scene;
}

Model model_of(const Scene& scene) { return make_model(std::make_shared<const Scene>(scene), own_meshes(scene)); }

Trajectory answer_of(const Model& model) {
  const Catalogue catalogue = default_catalogue();
  Settings settings;
  settings.relative_tolerance = tolerance;
  return catalogue.method("full-order")
      .prepare(model, settings, catalogue.integrator("sundials"))
      ->simulate({.t = sample_times(*model.scene)});
}

std::vector<Basis> modes_of(const Model& model, int n_elastic) {
  std::vector<Basis> all;
  for (size_t i = 0; i < model.bodies.size(); ++i)
    all.push_back({lowest_modes(model.bodies[i].full->system(), n_elastic, physical_shift(model.scene->bodies[i]))});
  return all;
}

// Nothing is left out then: both are the same body in other unknowns, of other tolerances.
TEST(BasisModel, OfAllModesIsFullOrder) {
  for (const bool on_board : {false, true}) {
    const Model model = model_of(falling(on_board));
    const Trajectory full = answer_of(model), same = answer_of(in_bases(model, modes_of(model, 1000)));
    ASSERT_EQ(same.status, Status::ok);
    const double pressed = full.bodies[0].contact.touches.at(0).peak_force;
    EXPECT_NEAR(same.bodies[0].contact.touches.at(0).peak_force, pressed, 1e-4 * pressed) << on_board;
    for (size_t b = 0; b < full.bodies.size(); ++b) {
      const MatrixXd &u = full.bodies[b].displacement, &eps = full.bodies[b].strain;
      EXPECT_LT((same.bodies[b].displacement - u).norm(), 1e-4 * u.norm()) << on_board << b;
      EXPECT_LT((same.bodies[b].strain - eps).norm(), 1e-3 * eps.norm()) << on_board << b;  // stiff modes at tolerances
    }
  }
}

TEST(BasisModel, OfFewModesIsAnother) {
  const Model model = model_of(falling(false));
  const Trajectory full = answer_of(model), few = answer_of(in_bases(model, modes_of(model, 5)));
  const double pressed = full.bodies[0].contact.touches.at(0).peak_force;
  EXPECT_GT(std::abs(few.bodies[0].contact.touches.at(0).peak_force / pressed - 1), 0.01);
}

TEST(BasisModel, StaticShapesBecomeModesOfTheSpan) {
  const Scene scene = falling(false);
  const Model model = model_of(scene);
  const System& system = model.bodies[0].full->system();
  const Modes modes = modes_of(model, 8)[0].modes;
  const MatrixXd Psi = contact_shapes(scene, scene.bodies[0], model.bodies[0], modes, physical_shift(scene.bodies[0]));
  ASSERT_GT(Psi.cols(), 1);
  const Modes all = with_shapes(modes, Psi, system).modes;
  ASSERT_EQ(all.size(), modes.size() + Psi.cols());
  const Index n = all.size();
  const MatrixXd K = all.Phi.transpose() * (system.K * all.Phi);
  EXPECT_LT((all.Phi.transpose() * (system.M * all.Phi) - MatrixXd::Identity(n, n)).norm(), 1e-7);  // of eigensolves
  EXPECT_LT((K - MatrixXd(all.omega.array().square().matrix().asDiagonal())).norm(), 1e-7 * K.norm());
  for (Index i = modes.size(); i + 1 < n; ++i) EXPECT_LE(all.omega[i], all.omega[i + 1]);
  EXPECT_EQ(with_shapes(modes, MatrixXd(Psi.rows(), 0), system).modes.size(), modes.size());
  EXPECT_THROW(with_shapes(modes, MatrixXd::Zero(Psi.rows(), 1), system), std::invalid_argument);
}

// What the floating frame takes them for: the limit of no mass is there long before rounding is.
TEST(BasisModel, StaticShapesOfHardlyAnyMassFollowTheirLoad) {
  const Scene scene = falling(false);
  const Model model = model_of(scene);
  const Modes modes = modes_of(model, 5)[0].modes;
  const MatrixXd Psi = contact_shapes(scene, scene.bodies[0], model.bodies[0], modes, physical_shift(scene.bodies[0]));
  const auto with_mass = [&](double mass) {
    const std::vector<Basis> basis{with_shapes(modes, Psi, model.bodies[0].full->system(), mass)};
    return answer_of(in_bases(model, basis)).bodies[0].displacement;
  };
  const MatrixXd light = with_mass(1e-4), lighter = with_mass(1e-5), heavy = with_mass(1);
  EXPECT_LT((light - lighter).norm(), 0.01 * (heavy - lighter).norm());
  EXPECT_THROW(with_mass(0), std::invalid_argument);
}

TEST(BasisModel, NeedsABasisOfEveryBody) {
  const Model model = model_of(falling(true));
  const std::vector<Basis> modes = modes_of(model, 3);
  EXPECT_THROW(in_bases(model, std::span(modes).first(1)), std::invalid_argument);
}

}  // namespace
}  // namespace mb
