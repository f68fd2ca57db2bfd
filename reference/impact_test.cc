#include "reference/impact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "mechanics/contact/contact_steppers.h"
#include "reference/above_floor_test.h"
#include "reference/full_model.h"
#include "reference/full_order.h"
#include "reference/integrators_test.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using testing::arkode;
using testing::average_acceleration;
using testing::explicit_steps;

constexpr double R = 0.06, drop = 0.05, g = 9.81;

Scene dropped_ball() {
  return testing::above_floor(one_body(Sphere{R}, {1e6, 0.3, 1100, {}}, {2, {1}}), {0.3, -0.2, R + drop}, 0.16);
}

struct Drop {
  explicit Drop(const Scene& of) : scene(std::make_shared<const Scene>(of)), model(build_model(scene)) {}
  Trajectory run(const Integrator& integrator, const Settings& settings) const {
    return full_order()->prepare(model, settings, integrator)->simulate({VectorXd::LinSpaced(161, 0, scene->duration)});
  }
  double mass() const {
    const VectorXd e = model.bodies[0].full->translation({0, 0, 1});
    return e.dot(model.bodies[0].full->system().M * e);
  }
  std::shared_ptr<const Scene> scene;
  Model model;
};

// Centroid of the evaluation points at sample k.
Vector3d centre(const Drop& drop_, const Trajectory& answer, Index k) {
  const auto& [X, w] = drop_.model.bodies[0].points.volume;
  const auto u = answer.bodies[0].displacement.col(k).head(3 * X.cols()).reshaped(3, X.cols());
  return (X + u.matrix()) * w / w.sum();
}

TEST(Impact, FallsFreelyToTheFirstTouchOfSurfaces) {
  const Drop ball(dropped_ball());
  const Trajectory answer = ball.run(arkode(), {.relative_tolerance = 1e-4});
  ASSERT_EQ(answer.status, Status::ok);
  ASSERT_GE(answer.bodies[0].contact.touches.size(), 1u);
  const double t1 = std::sqrt(2 * drop / g);
  EXPECT_NEAR(answer.bodies[0].contact.touches[0].start, t1, 1e-14);
  for (Index k = 0; answer.t[k] < t1; ++k) {
    const double t = answer.t[k];
    EXPECT_LT((centre(ball, answer, k) - Vector3d(0.3, -0.2, R + drop - g * t * t / 2)).norm(), 1e-14);
    EXPECT_EQ(answer.bodies[0].strain.col(k).norm(), 0);
  }
}

TEST(Impact, KeepsMomentumAndEnergy) {
  const Drop ball(dropped_ball());
  const Trajectory answer = ball.run(arkode(), {.relative_tolerance = 1e-5});
  const ContactHistory& contact = answer.bodies[0].contact;
  ASSERT_GE(contact.touches.size(), 1u);  // a coarse ball lets go and comes back
  // Afterwards the centroid flies with -g t + J/m: by two samples. The points' centroid is the mass' to 1e-3 of the
  // deformation (their quadrature is not the mesh's), which vibrates.
  const Index a = 140, b = 160;
  ASSERT_EQ(contact.force.rightCols(b - a + 1).norm(), 0);
  const Vector3d J = contact.impulse.col(a);
  const double T = answer.t[b] - answer.t[a], after = J.z() / ball.mass() - g * (answer.t[a] + answer.t[b]) / 2;
  const double speed = (centre(ball, answer, b) - centre(ball, answer, a)).z() / T;
  EXPECT_NEAR(speed, after, 2e-3 * J.z() / ball.mass());
  EXPECT_LT(J.head(2).norm(), 1e-6 * J.norm());
  // Undamped: what is lost is the integration's error, most of it in the highest modes, which it damps.
  const VectorXd& E = answer.bodies[0].energy;
  EXPECT_LT((E.array() - E[0]).abs().maxCoeff(), 3e-3 * ball.mass() * g * drop);
  EXPECT_GT(contact.stored.maxCoeff(), 0);
  // The floor never pulls.
  EXPECT_GE(contact.force.row(2).minCoeff(), 0);
  EXPECT_GT(J.z(), ball.mass() * std::sqrt(2 * g * drop));  // it bounces
}

TEST(Impact, FixedStepsTendToTheAdaptiveAnswer) {
  const Drop ball(dropped_ball());
  const Trajectory truth = ball.run(arkode(), {.relative_tolerance = 1e-6});
  const auto error = [&](const Integrator& integrator, double h) {
    const Trajectory answer = ball.run(integrator, {.time_step = h});
    EXPECT_EQ(answer.status, Status::ok);
    return (answer.bodies[0].displacement - truth.bodies[0].displacement).norm() / truth.bodies[0].displacement.norm();
  };
  const double coarse = error(average_acceleration(), 4e-4), fine = error(average_acceleration(), 1e-4);
  EXPECT_LT(fine, coarse / 5);
  EXPECT_LT(fine, 1e-3);
  // Another mass matrix: it agrees as well as lumping does.
  EXPECT_LT(error(explicit_steps(), 1e-5), 0.02);
}

TEST(Impact, HeldBackFromWhatItCannotDo) {
  Scene spinning = dropped_ball();
  spinning.bodies[0].twist.angular_velocity = {0, 1, 0};
  EXPECT_THROW(Drop(spinning).run(arkode(), {.relative_tolerance = 1e-4}), std::invalid_argument);
  Scene within = dropped_ball();
  within.bodies[0].pose.position.z() = R - 1e-3;
  try {
    Drop(within).run(arkode(), {.relative_tolerance = 1e-4});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("starts 0.001 m within obstacle 'floor'"), std::string::npos)
        << error.what();
  }
}

// It does not fly: its weight bends it until it lies on what is below.
TEST(Impact, WhatIsHeldSagsOntoAnObstacle) {
  const double gap = 1e-3, L = 0.4, b = 0.04;
  Scene scene = one_body(Box{{L, b, b}}, {1e8, 0.3, 1100, {}}, {2, {4, 1, 1}});
  scene.bodies[0].supports = {testing::support(Support::Kind::fixed, testing::face("x-min"))};
  scene.bodies[0].damping = {0, 2e-4};
  scene.bodies[0].pose.position = {0, 0, b / 2 + gap};
  scene.gravity = {0, 0, -g};
  scene.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({.body = scene.bodies[0].name, .obstacle = "floor", .stiffness = 0});
  scene.duration = 0.08;
  scene.loads.clear();
  const Drop held(scene);
  Settings settings;
  settings.relative_tolerance = 1e-4;
  const Trajectory answer = held.run(arkode(), settings);
  ASSERT_EQ(answer.status, Status::ok);
  const BodyTrajectory& body = answer.bodies[0];
  ASSERT_FALSE(body.contact.touches.empty());
  // Euler and Bernoulli's first mode: u = 1.566 g (1 - cos(omega t))/omega^2 at the tip, of the second mode 3 % of it.
  const double omega = 3.516 / (L * L) * std::sqrt(1e8 * b * b / (12 * 1100));
  const double t_first = std::acos(1 - gap * omega * omega / (1.566 * g)) / omega;
  EXPECT_NEAR(body.contact.touches[0].start, t_first, 0.04 * t_first);
  // Alone it sags by rho g A L^4/(8 E I), 2.6 mm, and twice that at first; the floor holds it within its layer.
  const double lowest = body.displacement.minCoeff();
  EXPECT_LT(lowest, -0.95 * gap);
  EXPECT_GT(lowest, -1.05 * gap);
}

TEST(Impact, NothingIsTouchedWithinTheDuration) {
  Scene high = dropped_ball();
  high.bodies[0].pose.position.z() = 5;
  const Drop ball(high);
  const Trajectory answer = ball.run(arkode(), {.relative_tolerance = 1e-4});
  EXPECT_EQ(answer.work.steps, 0);
  EXPECT_TRUE(answer.bodies[0].contact.touches.empty());
  EXPECT_NEAR(centre(ball, answer, 160).z(), 5 - g * 0.16 * 0.16 / 2, 1e-14);
}

}  // namespace
}  // namespace mb
