#include "modal/methods/methods.h"

#include <gtest/gtest.h>

#include "mechanics/system/newmark.h"
#include "modal/bases/eigenmodes.h"
#include "modal/methods/projection.h"
#include "modal/methods/whole_body_test.h"

namespace mb {
namespace {

using testing::beam;
using testing::beam_duration;
using testing::beam_model;
using testing::beam_shift;
using testing::beam_times;
using testing::closed_form;
using testing::error;
using testing::model_of;
using testing::simulate;

TEST(ModalProjection, IsASystemInModalCoordinates) {
  const System body = beam(false).system;
  const Modes modes = lowest_modes(body, 10, beam_shift);
  const System reduced = project(body, modes);
  const MatrixXd& Phi = modes.Phi;
  ASSERT_EQ(reduced.M.rows(), modes.size());
  EXPECT_EQ(MatrixXd(reduced.M), MatrixXd::Identity(modes.size(), modes.size()));
  EXPECT_EQ(reduced.lumped_mass.rows(), 0);
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

// Damping mode by mode on top of Rayleigh's, in the modes of an eigensolve of its own.
System with_ratios(System body, int n_modes) {
  const Modes modes = lowest_modes(body, n_modes, beam_shift);
  const Index n = modes.size() - modes.n_rigid;
  body.modal_damping = {body.M * modes.Phi.rightCols(n), VectorXd::LinSpaced(n, 3, 20)};
  return body;
}

TEST(ModalProjection, KeepsTheDampingOfSingleModesApart) {
  const System body = with_ratios(beam(false).system, 12);
  for (const int n_modes : {3, 12, 30}) {
    const System reduced = project(body, lowest_modes(body, n_modes, beam_shift));
    const auto& [W, d] = reduced.modal_damping;
    const Index n_damped = std::min<Index>(reduced.M.rows() - 6, body.modal_damping.d.size());
    ASSERT_EQ(d.size(), n_damped) << n_modes;
    for (Index k = 0; k < d.size(); ++k) {
      EXPECT_EQ(W.col(k), VectorXd::Unit(W.rows(), 6 + k));
      EXPECT_NEAR(d(k), body.modal_damping.d(k), 1e-9 * d(k));
    }
    EXPECT_NO_THROW(exact(reduced, beam_duration));
  }
  // Of modes that the basis does not hold nothing is left.
  EXPECT_EQ(project(body, lowest_modes(body, 0, beam_shift)).modal_damping.d.size(), 0);
}

// A mode that creeps, damped 10^8 times over, leaves the damping of the others alone.
TEST(ModalProjection, KeepsWeakDampingBesideStrong) {
  System body = with_ratios(beam(false).system, 6);
  body.modal_damping.d(4) = 1e10;
  const System reduced = project(body, lowest_modes(body, 12, beam_shift));
  const auto& [W, d] = reduced.modal_damping;
  ASSERT_EQ(d.size(), body.modal_damping.d.size());
  for (Index k = 0; k < d.size(); ++k) {
    EXPECT_EQ(W.col(k), VectorXd::Unit(W.rows(), 6 + k));
    EXPECT_NEAR(d(k), body.modal_damping.d(k), 1e-6 * d(k));  // 1e10 of an angle of 1e-8 squared
  }
}

TEST(ModalProjection, KeepsTheDampingOfSingleModesInAnyBasis) {
  const System body = with_ratios(beam(false).system, 12);
  Modes modes = lowest_modes(body, 12, beam_shift);
  const Index n = modes.size();
  const MatrixXd turn = MatrixXd::Identity(n, n) + 0.3 * MatrixXd::Ones(n, n);
  modes.Phi *= Eigen::HouseholderQR<MatrixXd>(turn).householderQ() * MatrixXd::Identity(n, n);
  const System reduced = project(body, modes);
  const VectorXd q = VectorXd::LinSpaced(n, -1, 2);
  const auto& [W, d] = reduced.modal_damping;
  const VectorXd damping = body.modal_damping.d.cwiseProduct(body.modal_damping.W.transpose() * (modes.Phi * q));
  const VectorXd expected = modes.Phi.transpose() * (body.modal_damping.W * damping);
  EXPECT_LT((W * d.cwiseProduct(W.transpose() * q) - expected).norm(), 1e-12 * expected.norm());
}

TEST(ResidualFlexibility, OfAllModesIsZero) {
  for (const bool clamped : {false, true}) {
    const System body = beam(clamped).system;
    const ShiftedFactor shifted = shifted_factor(body, beam_shift);
    const MatrixXd G_F = inertia_relief(body, shifted, body.F);
    const Modes all = lowest_modes(body, static_cast<int>(body.K.rows()), shifted);
    ASSERT_EQ(all.size(), body.K.rows());
    EXPECT_LT(residual_flexibility(all, body.F, G_F).norm(), 1e-9 * G_F.norm());
    const Modes none = lowest_modes(body, 0, shifted);
    EXPECT_EQ(residual_flexibility(none, body.F, G_F), G_F);
    // M-orthogonal to the modes kept: what they carry is not counted twice.
    const Modes some = lowest_modes(body, 8, shifted);
    const MatrixXd rest = residual_flexibility(some, body.F, G_F);
    EXPECT_LT((some.Phi.transpose() * (body.M * rest)).norm(), 1e-9 * (all.Phi.transpose() * (body.M * G_F)).norm());
  }
}

TEST(ModalMethods, WithAllModesAreTheFullSystem) {
  for (const bool clamped : {false, true}) {
    const System body = beam(clamped).system;
    const Model model = beam_model(clamped);
    const MatrixXd truth = exact(body, beam_duration)->run(beam_times()).u;
    for (const auto& method : {eigenmodes(), static_correction(), full_basis()}) {
      const Trajectory answer = simulate(*method, model, 100000, {.t = beam_times()});
      ASSERT_EQ(answer.status, Status::ok);
      EXPECT_LT(error(body, answer.bodies.at(0).displacement, truth), 1e-9) << method->name();
      EXPECT_LT((answer.bodies[0].strain - 2 * answer.bodies[0].displacement).norm(),
                1e-12 * answer.bodies[0].strain.norm());
    }
  }
}

TEST(ModalMethods, DampSingleModesLikeTheFullSystem) {
  testing::BoxSystem box = beam(false);
  box.system = with_ratios(box.system, 12);
  const MatrixXd truth = exact(box.system, beam_duration)->run(beam_times()).u;
  const Trajectory answer = simulate(*eigenmodes(), model_of(box, false), 100000, {.t = beam_times()});
  EXPECT_LT(error(box.system, answer.bodies.at(0).displacement, truth), 1e-9);
}

TEST(ModalMethods, ConvergeAndTheCorrectionHelps) {
  testing::BoxSystem box = beam(true);
  const System& body = box.system;
  box.system.u0.setZero();  // a deformed start is in no mode of low order; what is asked here is the load
  box.system.v0.setZero();
  const Model model = model_of(box, true);
  const Sampling sampling{.t = beam_times()};
  const MatrixXd truth = exact(body, beam_duration)->run(sampling.t).u;
  double before = 1;
  // From 8 modes on those left out are fast against the load, as the correction assumes (with 2 it does not help).
  for (const int n_modes : {8, 24}) {
    const double plain = error(body, simulate(*eigenmodes(), model, n_modes, sampling).bodies[0].displacement, truth);
    const double corrected =
        error(body, simulate(*static_correction(), model, n_modes, sampling).bodies[0].displacement, truth);
    EXPECT_LT(plain, before);
    EXPECT_LT(corrected, 0.7 * plain) << n_modes;
    before = plain;
  }
}

TEST(ModalMethods, WithoutElasticModesMoveRigidly) {
  const System body = beam(false).system;
  const Model model = beam_model(false);
  const auto prepared = eigenmodes()->prepare(model, Settings{.modes = 0}, closed_form);
  EXPECT_EQ(prepared->modes_used(), 0);
  EXPECT_EQ(prepared->n_unknowns(), 6);
  const MatrixXd u = prepared->simulate({.t = beam_times()}).bodies.at(0).displacement;
  EXPECT_LT((body.K * u).norm(), 1e-9 * body.K.norm() * u.norm());
  EXPECT_GT(u.norm(), 0);
}

TEST(ModalMethods, ReportTheModesTheyUse) {
  const System body = beam(false).system;
  const Model model = beam_model(false);
  const Modes modes = lowest_modes(body, 7, beam_shift);
  const auto prepared = static_correction()->prepare(model, Settings{.modes = 7}, closed_form);
  EXPECT_EQ(prepared->modes_used(), modes.size() - 6);
  EXPECT_EQ(prepared->n_unknowns(), modes.size());
  EXPECT_EQ(eigenmodes()->name(), "eigenmodes");
  EXPECT_EQ(static_correction()->name(), "static-correction");
  EXPECT_TRUE(eigenmodes()->takes_modes());
  const auto full = full_basis()->prepare(model, {}, closed_form);
  EXPECT_EQ(full_basis()->name(), "full");
  EXPECT_FALSE(full_basis()->takes_modes());
  EXPECT_EQ(full->modes_used(), -1);
  EXPECT_EQ(full->n_unknowns(), body.M.rows());
}

// Gauss's rule of three points on each of 60 parts of the window, from states at single times.
MatrixXd mean_displacement(const Prepared& prepared, double t, double width) {
  constexpr int n_parts = 60;
  VectorXd times(3 * n_parts), weights(3 * n_parts);
  const double h = width / n_parts, offset = std::sqrt(0.6) / 2;
  for (int part = 0; part < n_parts; ++part) {
    const double middle = t - width / 2 + (part + 0.5) * h;
    times.segment<3>(3 * part) << middle - offset * h, middle, middle + offset * h;
    weights.segment<3>(3 * part) << 5. / 18, 8. / 18, 5. / 18;
  }
  return prepared.simulate({.t = times}).bodies.at(0).displacement * weights / n_parts;
}

TEST(ModalMethods, AverageOverTheShutter) {
  const Model model = beam_model(true);
  constexpr double width = 1. / 30;
  const Vector3d times(0.1 + width / 2, 0.31, 0.4);
  for (const auto& method : {eigenmodes(), static_correction(), quadratic_strain()}) {
    const auto prepared = method->prepare(model, Settings{.modes = 8}, closed_form);
    const MatrixXd u = prepared->simulate({.t = times, .shutter = width}).bodies.at(0).displacement;
    for (Index k = 0; k < times.size(); ++k) {
      const VectorXd expected = mean_displacement(*prepared, times[k], width);
      EXPECT_LT((u.col(k) - expected).norm(), 1e-7 * expected.norm()) << method->name() << " " << times[k];
    }
  }
  const Integrator stepping{"newmark", "",
                            [](const System& system, const Settings&, double) { return newmark(system, 1e-3); }};
  const auto stepped = eigenmodes()->prepare(model, Settings{.modes = 8}, stepping);
  EXPECT_THROW(stepped->simulate({.t = times, .shutter = width}), std::invalid_argument);
  EXPECT_THROW(stepped->simulate({.t = times, .shutter = -width}), std::invalid_argument);
}

TEST(ModalMethods, StepWithoutReconstruction) {
  const auto prepared = eigenmodes()->prepare(beam_model(false), Settings{.modes = 8}, closed_form);
  const Trajectory answer = prepared->simulate({.t = beam_times(), .reconstruct = false});
  EXPECT_TRUE(answer.bodies.empty());
  EXPECT_GT(answer.work.steps, 0);
}

TEST(ModalMethods, RefuseBadInput) {
  testing::BoxSystem box = beam(false);
  EXPECT_THROW(eigenmodes()->prepare(beam_model(false), Settings{.modes = -1}, closed_form), std::invalid_argument);
  box.system.K *= -1;
  EXPECT_THROW(eigenmodes()->prepare(model_of(box, false), Settings{.modes = 4}, closed_form), std::runtime_error);
}

}  // namespace
}  // namespace mb
