#include "reference/finite_answer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/algebra/worse_test.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/exact.h"
#include "mechanics/system/newmark.h"
#include "reference/above_floor_test.h"
#include "reference/finite_bodies_test.h"
#include "reference/full_order.h"
#include "reference/integrators_test.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

using testing::arkode;
using testing::average_acceleration;
using testing::explicit_steps;

using testing::FreeBody;
constexpr double R = 0.06, g = 9.81;
const Material jelly{1e6, 0.45, 1100};

Scene dropped(const Shape& shape, double height, double drop, double duration, const Resolution& mesh = {2, {1}}) {
  return testing::above_floor(testing::finite_body(shape, jelly, mesh, {0, 1e-4}), {0.3, -0.2, height + drop},
                              duration);
}

struct Answered {
  Answered(const Scene& of, double tolerance, int n = 101, const Integrator& integrator = arkode())
      : scene(std::make_shared<const Scene>(of)), model(build_model(scene)) {
    Settings settings;
    settings.relative_tolerance = settings.time_step = tolerance;
    answer = full_order()->prepare(model, settings, integrator)->simulate({VectorXd::LinSpaced(n, 0, of.duration)});
  }
  const BodyTrajectory& body() const { return answer.bodies[0]; }
  Vector3d centre(Index k) const {
    const auto& [X, w] = model.bodies[0].points.volume;
    return (X + body().displacement.col(k).head(3 * X.cols()).reshaped(3, X.cols()).matrix()) * w / w.sum();
  }
  // [rad] about z, in (-pi, pi], and [kg m^2] of the body where it was at first.
  double angle(Index k) const {
    const auto& [X, w] = model.bodies[0].points.volume;
    const MatrixXd x = X + body().displacement.col(k).head(3 * X.cols()).reshaped(3, X.cols()).matrix();
    const VectorXd turned = X.row(0).cwiseProduct(x.row(1)) - X.row(1).cwiseProduct(x.row(0));
    const VectorXd kept = X.row(0).cwiseProduct(x.row(0)) + X.row(1).cwiseProduct(x.row(1));
    return std::atan2(turned.dot(w), kept.dot(w));
  }
  double inertia() const {
    const auto& [X, w] = model.bodies[0].points.volume;
    return mass() * X.topRows(2).colwise().squaredNorm().dot(w) / w.sum();
  }
  double mass() const { return model.bodies[0].full->system().M.sum() / 3; }
  std::shared_ptr<const Scene> scene;
  Model model;
  Trajectory answer;
};

Scene linear(Scene scene) {
  scene.bodies[0].kinematics = Kinematics::linear;
  return scene;
}

// The weaker the blow the nearer: strains of a contact grow as the speed to the power 4/5.
TEST(FiniteAnswer, WeakBlowsAreLinear) {
  const auto off = [](double drop) {
    const Scene scene = dropped(Sphere{R}, R, drop, std::sqrt(2 * drop / g) + 0.02);
    const Answered finite(scene, 1e-5, 401), straight(linear(scene), 1e-5, 401);
    EXPECT_EQ(finite.answer.status, Status::ok);
    EXPECT_EQ(finite.body().contact.touches.at(0).start, straight.body().contact.touches.at(0).start);
    return finite.body().contact.touches[0].peak_force / straight.body().contact.touches[0].peak_force - 1;
  };
  const double weak = off(1e-4), strong = off(0.1);  // seen 1.0e-3 and 1.3e-2
  EXPECT_LT(std::abs(weak), 3e-3);
  EXPECT_GT(std::abs(strong), 8e-3);
}

TEST(FiniteAnswer, FlatBlowKeepsMomentumAndEnergy) {
  Scene scene = dropped(Sphere{R}, R, 0.5, 0.36);  // until it has left
  scene.bodies[0].damping = {};
  const Answered run(scene, 1e-5, 361);
  ASSERT_EQ(run.answer.status, Status::ok);
  const ContactHistory& contact = run.body().contact;
  const double t1 = std::sqrt(2 * 0.5 / g), v1 = std::sqrt(2 * 0.5 * g);
  ASSERT_FALSE(contact.touches.empty());
  EXPECT_NEAR(contact.touches[0].start, t1, 1e-14);
  for (Index k = 0; run.answer.t[k] < t1; ++k) {
    const double t = run.answer.t[k];
    EXPECT_LT((run.centre(k) - Vector3d(0.3, -0.2, R + 0.5 - g * t * t / 2)).norm(), 1e-14);
    EXPECT_EQ(run.body().strain.col(k).norm(), 0);
  }
  EXPECT_GE(contact.force.row(2).minCoeff(), 0);
  const double J = contact.impulse(2, 360);
  EXPECT_GT(J, 1.5 * run.mass() * v1);
  EXPECT_GT(run.body().strain.cwiseAbs().maxCoeff(), 0.2);  // squashed: what linear kinematics are not for
  const VectorXd& E = run.body().energy;
  EXPECT_EQ(E[0], 0);
  // The integrator's losses in the highest modes.
  EXPECT_LT(E.cwiseAbs().maxCoeff(), 3e-3 * run.mass() * g * 0.5);
}

// Frictionless on a plane: nothing turns about its normal and nothing moves along it; momentum is the impulse's. A
// tumbling brick meets it corner first.
TEST(FiniteAnswer, ContactHandsOverMomentumAndTorque) {
  Scene scene = dropped(Box{{0.12, 0.08, 0.05}}, 0.07, 0.1, 0.1, {2, {2, 1, 1}});
  const auto model = testing::model_of(scene);
  const FreeBody body(*model);
  System s = model->system();
  s.v0 = body.moving({0.5, 0, -2}, {30, 20, 25});
  const std::vector<Contact> contacts{
      {model->boundary(), {HalfSpace{}, 0, {{0, 0, -0.09}, {1, 0, 0, 0}}}, {1e9, 0, {}}, {1e-3, 1}, false}};
  const VectorXd times = VectorXd::LinSpaced(11, 0, 0.1);
  const auto check = [&](const States& states, double spin) {
    ASSERT_EQ(states.status, Status::ok);
    double blows = 0;
    int n_apart = 0;  // after a blow
    for (Index k = 0; k < times.size(); ++k) {
      const VectorXd u = states.u.col(k), v = states.v.col(k);
      const Vector3d J = states.contact.impulse.col(k), P = body.momentum(v) - body.momentum(s.v0);
      const Vector3d weight(0, 0, -body.mass * g * times[k]);
      // While it presses J is interpolated, between steps at which it is the momentum to rounding.
      if (states.contact.force.col(k).isZero(0)) {
        EXPECT_LT((P - weight - J).norm(), 1e-10 * body.momentum(s.v0).norm()) << k;
        n_apart += J.z() > 0;
      }
      EXPECT_LT(J.head(2).norm(), 1e-12);
      const Vector3d L0 = body.spin(s.u0, s.v0), L = body.spin(u, v);
      EXPECT_LT(std::abs(L.z() - L0.z()), spin * L0.norm()) << k;
      blows = worse(blows, (L - L0).norm() / L0.norm());
    }
    EXPECT_GE(n_apart, 2);
    EXPECT_GT(blows, 0.3);  // the blow does turn it about other axes
  };
  check(sundials(s, contacts, 1e-5, 0.1)->run(times), 2e-3);
  check(newmark(s, contacts, 1e-4)->run(times), 2e-2);
}

// Slow enough to stay stiff, through 2 rad: it moves as a rigid body, and its strains are those of the turning frame.
TEST(FiniteAnswer, StrainsAreSeenFromTheTurningFrame) {
  Scene scene = dropped(Box{{0.12, 0.08, 0.05}}, 5, 1, 0.2, {2, {1, 1, 1}});
  scene.bodies[0].twist.angular_velocity = {0, 0, 10};
  scene.bodies[0].pose.orientation = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());
  const Answered run(scene, 1e-6, 3);
  ASSERT_EQ(run.answer.status, Status::ok);
  const Matrix3Xd X = run.model.bodies[0].points.all();
  const Pose& pose = scene.bodies[0].pose;
  for (Index k = 0; k < 3; ++k) {
    const double t = run.answer.t[k];
    const Eigen::Matrix3d Q = (Eigen::AngleAxisd(10 * t, Vector3d::UnitZ()) * pose.orientation).toRotationMatrix();
    const Matrix3Xd d = run.body().displacement.col(k).reshaped(3, X.cols());
    const Vector3d fallen(0, 0, -g * t * t / 2);
    const Matrix3Xd rigid = (Q * X).colwise() + (pose.position + fallen) - X;
    if (k == 0) {
      EXPECT_LT((d - rigid).norm(), 1e-12 * d.norm());
    }
    EXPECT_LT((run.centre(k) - pose.position - fallen).norm(), 1e-8);
    // rho omega^2 l^2/(8 E) = 2e-4 of centrifugal strain, twice that at first
    EXPECT_LT(run.body().strain.col(k).cwiseAbs().maxCoeff(), 2e-3);
    EXPECT_NEAR(run.body().energy[k], run.body().energy[0], 1e-4 * run.mass() * g * 0.2);  // of what gravity does
  }
}

// The same scene seen from other axes: a ball with a spin. (What comes down on a corner chatters, and soon no two runs
// agree.)
TEST(FiniteAnswer, AxesOfTheWorldDoNotMatter) {
  Scene scene = dropped(Sphere{R}, R, 0.01, 0.04);
  scene.bodies[0].twist = {{0.1, 0, -1}, {20, 5, 3}};
  const Answered here(scene, 1e-5, 4);
  const Eigen::Quaterniond Q(Eigen::AngleAxisd(1.1, Vector3d(2, -1, 1).normalized()));
  const auto turn = [&](Pose& pose) { pose = {Q * pose.position, Q * pose.orientation}; };
  turn(scene.bodies[0].pose);
  turn(scene.obstacles[0].surface.pose);
  scene.bodies[0].twist = {Q * scene.bodies[0].twist.velocity, Q * scene.bodies[0].twist.angular_velocity};
  scene.gravity = Q * scene.gravity;
  const Answered there(scene, 1e-5, 4);
  ASSERT_EQ(there.answer.status, Status::ok);
  EXPECT_GT(here.body().contact.impulse.norm(), 0);
  EXPECT_LT((there.body().contact.impulse - Q.toRotationMatrix() * here.body().contact.impulse).norm(),
            1e-4 * here.body().contact.impulse.norm());  // steps are not the same: their tolerance, 1e-5
  EXPECT_LT((there.body().strain - here.body().strain).norm(), 1e-3 * here.body().strain.norm());
}

TEST(FiniteAnswer, MeetsObstaclesOfEveryKind) {
  const auto shape = [](const Shape& of, double top) { return RigidSurface{of, 0, {{0.3, -0.2, -top}, {1, 0, 0, 0}}}; };
  for (const RigidSurface& surface :
       {RigidSurface{}, shape(Box{{0.2, 0.2, 0.1}}, 0.05), shape(Cylinder{0.1, 0.08}, 0.04), shape(Sphere{0.1}, 0.1),
        shape(Superquadric{{0.1, 0.1, 0.05}, 0.6, 0.8}, 0.05)}) {
    Scene scene = dropped(Sphere{R}, R, 0.02, 0.09);
    scene.obstacles[0].surface = surface;
    const Answered run(scene, 1e-4, 10);
    ASSERT_EQ(run.answer.status, Status::ok) << surface.shape.index();
    const ContactHistory& contact = run.body().contact;
    ASSERT_FALSE(contact.touches.empty());
    EXPECT_NEAR(contact.touches[0].start, std::sqrt(2 * 0.02 / g), 1e-9);
    // It has left: momentum by two samples of the points' centroid, which vibrates by 1e-3 of the deformation.
    const double T = run.answer.t[9] - run.answer.t[8];
    const double after = contact.impulse(2, 9) / run.mass() - g * (run.answer.t[9] + run.answer.t[8]) / 2;
    EXPECT_NEAR((run.centre(9) - run.centre(8)).z() / T, after, 5e-3 * contact.impulse(2, 9) / run.mass());
  }
}

TEST(FiniteAnswer, FixedStepsTendToTheAdaptiveAnswer) {
  const Scene scene = dropped(Sphere{R}, R, 0.1, 0.17);
  const Answered truth(scene, 1e-6);
  const auto error = [&](double h) {
    const Answered run(scene, h, 101, average_acceleration());
    EXPECT_EQ(run.answer.status, Status::ok);
    return (run.body().strain - truth.body().strain).norm() / truth.body().strain.norm();
  };
  const double coarse = error(4e-4), fine = error(1e-4);
  EXPECT_LT(fine, coarse / 5);
  EXPECT_LT(fine, 0.02);
}

// With the lumped mass: they tend to an answer of their own, which rebounds as the adaptive one does.
TEST(FiniteAnswer, ExplicitStepsRebound) {
  const Scene scene = dropped(Sphere{R}, R, 0.1, 0.17);
  const Answered truth(scene, 1e-6), finest(scene, 2.5e-6, 101, explicit_steps());
  const auto error = [&](double h) {
    const Answered run(scene, h, 101, explicit_steps());
    EXPECT_EQ(run.answer.status, Status::ok);
    return (run.body().strain - finest.body().strain).norm() / finest.body().strain.norm();
  };
  const double coarse = error(4e-5), fine = error(1e-5);
  EXPECT_LT(fine, coarse / 3);  // of first order where damping lags
  EXPECT_LT(fine, 0.01);
  const auto impulse = [](const Answered& run) { return run.body().contact.impulse(2, 100); };
  EXPECT_NEAR(impulse(finest), impulse(truth), 0.02 * impulse(truth));
  EXPECT_EQ(Answered(scene, 1e-3, 101, explicit_steps()).answer.status, Status::not_finite);
}

TEST(FiniteAnswer, WithoutContactLoadsActAndStrainsAreThoseOfTheFrame) {
  Scene scene = testing::finite_body(Box{{0.3, 0.1, 0.06}}, jelly, {2, {2, 1, 1}}, {0, 1e-4});
  // a couple that turns it by some rad
  scene.loads.push_back(
      {"couple", Pulse{0.1}, {{"body", {"x-min", {}}, {0, -900, 0}}, {"body", {"x-max", {}}, {0, 900, 0}}}});
  scene.duration = 0.4;
  const Answered run(scene, 1e-5, 5);
  ASSERT_EQ(run.answer.status, Status::ok);
  EXPECT_GT(run.body().displacement.col(4).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_LT(run.body().strain.col(4).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_LT(run.centre(4).norm(), 1e-6);
  // It spins on, but for 5e-4 of what swings and of adaptive steps, with the energy of a rigid body.
  const double spin = (run.angle(4) - run.angle(3)) / 0.1;
  EXPECT_EQ(run.body().energy[0], 0);
  EXPECT_NEAR(run.body().energy[4] / (run.inertia() * spin * spin / 2), 1, 2e-3);
  EXPECT_THROW(Answered(scene, 1e-5, 5,
                        {"exact", "", [](const System& s, const Settings&, double T) { return exact(s, T); },
                         Integrator::Knob::none}),
               std::invalid_argument);
}

TEST(FiniteAnswer, NothingIsTouchedWithinTheDuration) {
  const Answered run(dropped(Sphere{R}, R, 5, 0.16), 1e-4, 11);
  EXPECT_EQ(run.answer.work.steps, 0);
  EXPECT_TRUE(run.body().contact.touches.empty());
  EXPECT_NEAR(run.centre(10).z(), R + 5 - g * 0.16 * 0.16 / 2, 1e-14);
  EXPECT_THROW(Answered(dropped(Sphere{R}, R, 0.01, 0.1), 1e-4, 11,
                        {"exact", "", [](const System& s, const Settings&, double T) { return exact(s, T); },
                         Integrator::Knob::none}),
               std::invalid_argument);
}

}  // namespace
}  // namespace mb
