#include "modal/methods/methods.h"

#include <gtest/gtest.h>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/newmark.h"
#include "modal/bases/eigenmodes.h"
#include "modal/methods/projection.h"

namespace mb {
namespace {

const Vector3d size(0.09, 0.1, 0.3);       // [m]
const Material gelatine{2e4, 0.45, 1100};  // [Pa], [-], [kg/m^3]
constexpr double duration = 0.5;           // [s] about five periods of the first mode
constexpr double shift = -0.01 * 2e4 / (1100 * 0.3 * 0.3);

// A box that is pulled at both ends along z and bent, damped, and starts with a deformation and a motion.
System beam(bool clamped) {
  testing::BoxMesh mesh{.cells = {2, 3, 5}, .size = size, .E = 2e4, .nu = 0.45, .rho = 1100};
  if (clamped) mesh.fixed = [](const Vector3d& x, int) { return x[2] == 0; };
  testing::BoxSystem box = testing::box_system(mesh);
  System& system = box.system;
  system.damping = {.alpha = 1.5, .beta = 1e-4};
  system.F = MatrixXd::Zero(system.M.rows(), 2);
  for (size_t i = 0; i < box.dof.size(); ++i) {
    if (box.dof[i] < 0) continue;
    const Vector3d x = box.nodes.col(static_cast<Index>(i / 3));
    if (i % 3 == 2) system.F(box.dof[i], 0) = 1e-3 * (x[2] / size[2] - 0.5);
    if (i % 3 == 0) system.F(box.dof[i], 1) = 1e-3 * x[2] / size[2];
    system.u0(box.dof[i]) = 1e-3 * x[2] * x[1];
    system.v0(box.dof[i]) = i % 3 == 0 ? 0.1 : 0;
  }
  system.s = {Pulse{.duration = 0.2}, Ramp{.duration = 0.1}};
  return system;
}

class WholeBody : public FullModel {  // observed at its degrees of freedom
 public:
  explicit WholeBody(System system) : system_(std::move(system)) {}
  const System& system() const override { return system_; }
  SparseMatrix displacement_at(const Matrix3Xd&) const override { return identity(); }
  SparseMatrix strain_at(const Matrix3Xd&) const override { return 2 * identity(); }
  Index n_cells() const override { return 30; }
  double mesh_volume() const override { return size.prod(); }

 private:
  SparseMatrix identity() const { return SparseMatrix(VectorXd::Ones(system_.M.rows()).asDiagonal()); }
  System system_;
};

Model model_of(const System& system) {
  auto scene = std::make_shared<Scene>();
  scene->duration = duration;
  scene->bodies.push_back({.name = "beam",
                           .shape = Box{size},
                           .material = gelatine,
                           .damping = system.damping,
                           .resolution = {1, {2, 3, 5}},
                           .supports = {}});
  const auto full = std::make_shared<WholeBody>(system);
  BodyModel body{full, {}, full->displacement_at({}), full->strain_at({})};
  Model model;
  model.scene = scene;
  model.bodies.push_back(std::move(body));
  return model;
}

const Integrator closed_form{"exact", "closed form", [](const System& system, const Settings& settings, double end) {
                               return exact(system, end, settings.load_tolerance);
                             }};

Trajectory simulate(const Method& method, const Model& model, int n_modes, const VectorXd& t) {
  return method.prepare(model, Settings{.modes = n_modes}, closed_form)->simulate({.t = t});
}

VectorXd times() { return VectorXd::LinSpaced(101, 0, duration); }

// Relative M norm over all times.
double error(const System& system, const MatrixXd& u, const MatrixXd& truth) {
  const auto squared = [&](const MatrixXd& x) { return x.cwiseProduct(system.M * x).sum(); };
  return std::sqrt(squared(u - truth) / squared(truth));
}

TEST(ModalProjection, IsASystemInModalCoordinates) {
  const System body = beam(false);
  const Modes modes = lowest_modes(body, 10, shift);
  const System reduced = project(body, modes);
  const MatrixXd& Phi = modes.Phi;
  ASSERT_EQ(reduced.M.rows(), modes.size());
  EXPECT_EQ(MatrixXd(reduced.M), MatrixXd::Identity(modes.size(), modes.size()));
  const MatrixXd K = Phi.transpose() * (body.K * Phi);
  EXPECT_LT((MatrixXd(reduced.K) - K).cwiseAbs().maxCoeff(), 1e-9 * K.maxCoeff());
  EXPECT_LT((reduced.R - Phi.transpose() * (body.M * body.R)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(reduced.K * reduced.R, MatrixXd::Zero(modes.size(), 6));
  // Damping commutes with the projection.
  const VectorXd q = VectorXd::LinSpaced(modes.size(), -1, 2);
  const VectorXd damping = Phi.transpose() * apply_damping(body, Phi * q);
  EXPECT_LT((apply_damping(reduced, q) - damping).norm(), 1e-9 * damping.norm());
  // So does the rigid momentum of the start.
  EXPECT_LT((reduced.v0.head(6) - body.R.transpose() * (body.M * body.v0)).norm(), 1e-12 * reduced.v0.norm());
}

TEST(ResidualFlexibility, OfAllModesIsZero) {
  for (const bool clamped : {false, true}) {
    const System body = beam(clamped);
    const ShiftedFactor shifted = shifted_factor(body, shift);
    const MatrixXd G_F = inertia_relief(body, shifted, body.F);
    const Modes all = lowest_modes(body, static_cast<int>(body.K.rows()), shifted);
    ASSERT_EQ(all.size(), body.K.rows());
    EXPECT_LT(residual_flexibility(body, all, G_F).norm(), 1e-9 * G_F.norm());
    const Modes none = lowest_modes(body, 0, shifted);
    EXPECT_EQ(residual_flexibility(body, none, G_F), G_F);
    // M-orthogonal to the modes kept: what they carry is not counted twice.
    const Modes some = lowest_modes(body, 8, shifted);
    const MatrixXd rest = residual_flexibility(body, some, G_F);
    EXPECT_LT((some.Phi.transpose() * (body.M * rest)).norm(), 1e-9 * (all.Phi.transpose() * (body.M * G_F)).norm());
  }
}

TEST(ModalMethods, WithAllModesAreTheFullSystem) {
  for (const bool clamped : {false, true}) {
    const System body = beam(clamped);
    const Model model = model_of(body);
    const MatrixXd truth = exact(body, duration)->run(times()).u;
    for (const auto& method : {eigenmodes(), static_correction()}) {
      const Trajectory answer = simulate(*method, model, 100000, times());
      ASSERT_EQ(answer.status, Status::ok);
      EXPECT_LT(error(body, answer.bodies.at(0).displacement, truth), 1e-9) << method->name();
      EXPECT_LT((answer.bodies[0].strain - 2 * answer.bodies[0].displacement).norm(),
                1e-12 * answer.bodies[0].strain.norm());
    }
  }
}

TEST(ModalMethods, ConvergeAndTheCorrectionHelps) {
  System body = beam(true);
  body.u0.setZero();  // a deformed start is in no mode of low order; what is asked here is the load
  body.v0.setZero();
  const Model model = model_of(body);
  const MatrixXd truth = exact(body, duration)->run(times()).u;
  double before = 1;
  // From 8 modes on those left out are fast against the load, as the correction assumes (with 2 it does not help).
  for (const int n_modes : {8, 24}) {
    const double plain = error(body, simulate(*eigenmodes(), model, n_modes, times()).bodies[0].displacement, truth);
    const double corrected =
        error(body, simulate(*static_correction(), model, n_modes, times()).bodies[0].displacement, truth);
    EXPECT_LT(plain, before);
    EXPECT_LT(corrected, 0.7 * plain) << n_modes;
    before = plain;
  }
}

TEST(ModalMethods, WithoutElasticModesMoveRigidly) {
  const System body = beam(false);
  const Model model = model_of(body);
  const auto prepared = eigenmodes()->prepare(model, Settings{.modes = 0}, closed_form);
  EXPECT_EQ(prepared->modes_used(), 0);
  EXPECT_EQ(prepared->n_unknowns(), 6);
  const MatrixXd u = prepared->simulate({.t = times()}).bodies.at(0).displacement;
  EXPECT_LT((body.K * u).norm(), 1e-9 * body.K.norm() * u.norm());
  EXPECT_GT(u.norm(), 0);
}

TEST(ModalMethods, ReportTheModesTheyUse) {
  System body = beam(false);
  const Model model = model_of(body);
  const Modes modes = lowest_modes(body, 7, shift);
  const auto prepared = static_correction()->prepare(model, Settings{.modes = 7}, closed_form);
  EXPECT_EQ(prepared->modes_used(), modes.size() - 6);
  EXPECT_EQ(prepared->n_unknowns(), modes.size());
  EXPECT_EQ(eigenmodes()->name(), "eigenmodes");
  EXPECT_EQ(static_correction()->name(), "static-correction");
}

TEST(ModalMethods, RefuseBadInput) {
  System body = beam(false);
  EXPECT_THROW(eigenmodes()->prepare(model_of(body), Settings{.modes = -1}, closed_form), std::invalid_argument);
  body.K *= -1;
  EXPECT_THROW(eigenmodes()->prepare(model_of(body), Settings{.modes = 4}, closed_form), std::runtime_error);
}

}  // namespace
}  // namespace mb
