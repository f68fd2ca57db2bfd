#include "reference/impact_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "mechanics/contact/contact_steppers.h"
#include "reference/full_model.h"
#include "reference/full_order.h"
#include "reference/impact.h"
#include "reference/integrators_test.h"

namespace mb {
namespace {

using testing::arkode;
using testing::explicit_steps;

Eigen::Quaterniond turned(double angle, const Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

void add(Scene& scene, const std::string& name, const RigidSurface& surface) {
  scene.obstacles.push_back({name, surface, {}});
  scene.contacts.push_back({.body = scene.bodies[0].name, .obstacle = name, .stiffness = 0});
}
const RigidSurface ground{HalfSpace{}, 0, {}};

struct Fall {
  explicit Fall(const Scene& of) : scene(std::make_shared<const Scene>(of)), model(build_model(scene)) {}
  Trajectory run(double tolerance = 1e-4, Index n_t = 161) const {
    return run(arkode(), {.relative_tolerance = tolerance}, n_t);
  }
  Trajectory run(const Integrator& integrator, const Settings& settings, Index n_t = 161) const {
    return full_order()->prepare(model, settings, integrator)->simulate({VectorXd::LinSpaced(n_t, 0, scene->duration)});
  }
  const FullModel& full() const { return *model.bodies[0].full; }
  double mass() const {
    const VectorXd e = full().translation({0, 0, 1});
    return e.dot(full().system().M * e);
  }
  std::shared_ptr<const Scene> scene;
  Model model;
};

std::string what_fails(const Fall& fall) {
  try {
    fall.run();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

// By the quadrature of the volume points.
Vector3d centre(const Fall& fall, const Trajectory& answer, Index k) {
  const auto& [X, w] = fall.model.bodies[0].points.volume;
  const auto u = answer.bodies[0].displacement.col(k).head(3 * X.cols()).reshaped(3, X.cols());
  return (X + u.matrix()) * w / w.sum();
}
// sum w X x x / sum w |X|^2 across: of a body that turns about y by a little, out of the pose in its scene.
double turn_about_y(const Fall& fall, const Trajectory& answer, Index k) {
  const auto& [X, w] = fall.model.bodies[0].points.volume;
  const Body& body = fall.scene->bodies[0];
  const auto u = answer.bodies[0].displacement.col(k).head(3 * X.cols()).reshaped(3, X.cols());
  double moment = 0, inertia = 0;
  for (Index i = 0; i < X.cols(); ++i) {
    const Vector3d x = body.pose.orientation.conjugate() * Vector3d(X.col(i) + u.col(i) - body.pose.position);
    moment += w[i] * (X(2, i) * x.x() - X(0, i) * x.z());
    inertia += w[i] * (X(2, i) * X(2, i) + X(0, i) * X(0, i));
  }
  return moment / inertia;
}

TEST(ImpactRotation, RowsReadARotationAndNothingElse) {
  Scene scene = one_body(Box{{0.06, 0.08, 0.2}}, {1e6, 0.3, 1100, {}}, {2, {1, 1, 2}});
  scene.loads.clear();
  const Fall box(scene);
  const System& system = box.full().system();
  const MatrixXd rows =
      rotation_rows(system, box.model.bodies[0].points.all(), box.model.bodies[0].displacement * system.R);
  const MatrixXd linear = box.full().polynomials(1);
  // Of every linear field A X the antisymmetric part about principal axes; J is that of the points for all of them.
  const Matrix3Xd corners = (Matrix3Xd(3, 4) << 0, 0.03, 0, 0, 0, 0, 0.04, 0, 0, 0, 0, 0.1).finished();
  const SparseMatrix at_corners = box.full().displacement_at(corners);
  for (Index k = 0; k < linear.cols(); ++k) {
    const auto d = (at_corners * linear.col(k)).reshaped(3, 4).eval();
    Eigen::Matrix3d A;
    for (Index i = 0; i < 3; ++i) A.col(i) = (d.col(i + 1) - d.col(0)) / corners(i, i + 1);
    // M-projection: theta_x = (J_zz A_zy - J_yy A_yz) / (J_yy + J_zz) with J_ii the second moments of the mass.
    const Vector3d J = Vector3d(0.06, 0.08, 0.2).cwiseAbs2();
    const Vector3d expected((J.y() * A(2, 1) - J.z() * A(1, 2)) / (J.y() + J.z()),
                            (J.z() * A(0, 2) - J.x() * A(2, 0)) / (J.z() + J.x()),
                            (J.x() * A(1, 0) - J.y() * A(0, 1)) / (J.x() + J.y()));
    EXPECT_LT((rows * linear.col(k) - expected).norm(), 1e-10 * A.norm() + 1e-12) << k;
  }
  EXPECT_THROW(rotation_rows(system, corners, MatrixXd::Zero(3, 6)), std::invalid_argument);
}

TEST(ImpactRotation, NotANumberIsNoSmallAngle) {
  const Body body = one_body(Box{{1, 1, 1}}, {1e6, 0.3, 1000, {}}, {1, {1, 1, 1}}).bodies[0];
  const MatrixXd rows = MatrixXd::Identity(3, 3);
  const VectorXd t = VectorXd::LinSpaced(2, 0, 1);
  MatrixXd u = MatrixXd::Constant(3, 2, 0.05);  // 0.087 rad
  EXPECT_FALSE(large_rotation(body, rows * u, t));
  u(1, 1) = std::nan("");
  ASSERT_TRUE(large_rotation(body, rows * u, t));
  EXPECT_EQ(large_rotation(body, rows * u, t)->t, 1);
  u.setConstant(0.06);
  ASSERT_TRUE(large_rotation(body, rows * u, t));
  EXPECT_EQ(large_rotation(body, rows * u, t)->t, 0);
}

// An edge first, so that it tumbles.
Scene tilted_box(double duration) {
  Scene scene = one_body(Box{{0.06, 0.06, 0.2}}, {1e8, 0.3, 1000, {}}, {1, {1, 1, 3}});
  scene.bodies[0].name = "box";
  scene.bodies[0].pose = {{0, 0, 0.03 * std::sin(0.6) + 0.1 * std::cos(0.6) + 0.01}, turned(0.6, Vector3d::UnitY())};
  scene.gravity = {0, 0, -9.81};
  scene.duration = duration;
  scene.loads.clear();
  add(scene, "floor", ground);
  return scene;
}

// Once it has bounced it turns at a steady rate: the limit is met where that says.
TEST(ImpactRotation, ABoxThatTumblesIsNoAnswer) {
  const double duration = 0.06;
  const Fall early(tilted_box(duration));
  const Trajectory answer = early.run();
  ASSERT_EQ(answer.status, Status::ok);
  ASSERT_EQ(answer.bodies[0].contact.touches.size(), 1u);
  ASSERT_EQ(answer.bodies[0].contact.force.rightCols(21).norm(), 0);  // in flight
  const double before = turn_about_y(early, answer, 140), now = turn_about_y(early, answer, 160);
  const double rate = (now - before) / (duration / 8),
               limit = duration + (std::copysign(most_rotation, rate) - now) / rate;
  ASSERT_GT(limit, duration);
  EXPECT_EQ(what_fails(Fall(tilted_box(limit - 0.02 * most_rotation / std::abs(rate)))), "");
  const std::string said = what_fails(Fall(tilted_box(limit + 0.02 * most_rotation / std::abs(rate))));
  EXPECT_NE(said.find("body 'box' turns by 0.1 rad"), std::string::npos) << said;
  EXPECT_NE(what_fails(Fall(tilted_box(0.15))), "");
}

TEST(ImpactRotation, OnItsBaseItStaysUpright) {
  Scene scene = tilted_box(0.12);
  scene.bodies[0].pose = {{0, 0, 0.11}, Eigen::Quaterniond::Identity()};
  const Fall box(scene);
  EXPECT_EQ(what_fails(box), "");
}

constexpr double R = 0.06;
Scene ball(const Vector3d& place, const Vector3d& velocity, double duration) {
  Scene scene = one_body(Sphere{R}, {1e7, 0.3, 1100, {}}, {2, {1}});
  scene.bodies[0].name = "ball";
  scene.bodies[0].pose.position = place;
  scene.bodies[0].twist.velocity = velocity;
  scene.bodies[0].damping = {0, 1e-4};  // a quarter of the critical for the slowest mode
  scene.duration = duration;
  scene.loads.clear();
  return scene;
}

TEST(ImpactObstacles, FarAwayAndNeverTouchedChangeNothing) {
  // So slow that the size of what presses nowhere is larger: it must not rule the tolerances.
  Scene scene = ball({0, 0, R + 1e-5}, {0, 0, -0.005}, 0.06);
  add(scene, "floor", ground);
  const Trajectory alone = Fall(scene).run(1e-5);
  add(scene, "wall", {HalfSpace{}, 0, {{2, 0, 0}, turned(-pi / 2, Vector3d::UnitY())}});
  add(scene, "post", {Sphere{0.1}, 0, {{0, 0, 3}, Eigen::Quaterniond::Identity()}});
  const Trajectory beside = Fall(scene).run(1e-5);
  ASSERT_EQ(beside.status, Status::ok);
  ASSERT_EQ(beside.bodies[0].contact.touches.size(), alone.bodies[0].contact.touches.size());
  const auto &a = alone.bodies[0], &b = beside.bodies[0];
  // The same steps to the end of rounding: points elsewhere bear no force.
  EXPECT_LT((a.displacement - b.displacement).norm(), 1e-9 * a.displacement.norm());
  EXPECT_LT((a.contact.impulse - b.contact.impulse).norm(), 1e-9 * a.contact.impulse.norm());
}

// Thrown down, to the ceiling and down again: impulses are changes of momentum, and either ceiling is the same plane.
TEST(ImpactObstacles, CeilingIsMetAfterTheFloor) {
  const double height = 0.3, speed = 1;
  const auto thrown = [&](const RigidSurface& ceiling) {
    Scene scene = ball({0, 0, R + 0.01}, {0, 0, -speed}, 0.35);
    add(scene, "floor", ground);
    add(scene, "ceiling", ceiling);
    return scene;
  };
  const Fall plane(thrown({HalfSpace{}, 0, {{0, 0, height}, turned(pi, Vector3d::UnitX())}}));
  const Fall plate(thrown({Box{{1, 1, 0.1}}, 0, {{0, 0, height + 0.05}, Eigen::Quaterniond::Identity()}}));
  const Trajectory answer = plane.run(), other = plate.run();
  for (const auto& [fall, of] : {std::pair{&plane, &answer}, std::pair{&plate, &other}}) {
    ASSERT_EQ(of->status, Status::ok);
    const ContactHistory& contact = of->bodies[0].contact;
    // Between the two, and after both; a coarse ball lets go and comes back while it touches either.
    const double m = fall->mass(), up = contact.impulse(2, 80), down = contact.impulse(2, 160) - up;
    ASSERT_EQ(contact.force.col(80).norm() + contact.force.rightCols(11).norm(), 0);
    EXPECT_GT(up, 1.3 * m * speed);
    EXPECT_LT(up, 2 * m * speed);  // damped
    EXPECT_LT(down, -0.8 * m * speed);
    const double T = of->t[160] - of->t[150];
    const double v = (centre(*fall, *of, 160) - centre(*fall, *of, 150)).z() / T;
    // The points' centroid is the mass' to 1e-3 of the vibration.
    EXPECT_NEAR(m * v, -m * speed + up + down, 2e-3 * m * speed);
    // Nothing comes nearer to the ceiling than the layer gives way.
    double top = 0;
    for (Index k = 0; k < 161; ++k) top = std::max(top, centre(*fall, *of, k).z() + R);
    EXPECT_LT(top, height + 0.1 * R);
  }
  // The same plane, by normal rows alone and by points in space; vibrations of the first impact decide on the second.
  const MatrixXd J = answer.bodies[0].contact.impulse, J_other = other.bodies[0].contact.impulse;
  EXPECT_LT((J - J_other).norm(), 1e-3 * J.norm());
}

// A cube bounces on a step, comes back from a wall lower down and runs into the step with its side, which nobody
// watches: it looked along the step at the first touch. No force turns it.
TEST(ImpactObstacles, TouchElsewhereIsNamed) {
  const auto thrown = [](double duration) {
    Scene scene = one_body(Box{{0.06, 0.06, 0.06}}, {1e7, 0.3, 1000, {}}, {1, {2, 2, 2}});
    scene.bodies[0].name = "cube";
    scene.bodies[0].damping = {0, 2e-5};
    scene.bodies[0].pose.position = {-0.07, 0, 0.032};
    scene.bodies[0].twist.velocity = {2, 0, -0.2};
    scene.gravity = {0, 0, -3};
    scene.duration = duration;
    scene.loads.clear();
    add(scene, "step", {Box{{0.2, 0.2, 0.2}}, 0, {{-0.1, 0, -0.1}, Eigen::Quaterniond::Identity()}});
    add(scene, "wall", {HalfSpace{}, 0, {{0.35, 0, 0}, turned(-pi / 2, Vector3d::UnitY())}});
    return scene;
  };
  EXPECT_EQ(what_fails(Fall(thrown(0.25))), "");  // off the wall, not yet back
  const std::string said = what_fails(Fall(thrown(0.45)));
  EXPECT_NE(said.find("body 'cube' is"), std::string::npos) << said;
  EXPECT_NE(said.find("within obstacle 'step'"), std::string::npos) << said;
}

// The same without steps: carried over an obstacle, a ball enters it with its side; what touched may.
TEST(ImpactObstacles, OnlyWhatIsWatchedMayEnter) {
  const Scene scene = ball({0, 0, R}, {0, 0, 0}, 1);
  const Fall fall(scene);
  const RigidSurface post{Sphere{0.02}, 0, {{0, 0, -R - 0.02}, Eigen::Quaterniond::Identity()}};
  const Contact contact{fall.full().contact_points(post, 0.3 * R), post, {1e9, 0, {}}, {1e-3, 1}};
  const ContactPoints boundary = fall.full().contact_points(post, std::numeric_limits<double>::infinity());
  const VectorXd t = VectorXd::LinSpaced(3, 0, 1);
  const auto carried = [&](const Vector3d& by) { return MatrixXd(fall.full().translation(by) * t.transpose()); };
  const auto fails = [&](const Contact& watched, const MatrixXd& u) {
    const auto fault = unwatched_overlap(scene.bodies[0], {boundary, {}}, watched, "post", {t, u});
    return fault ? fault->what : std::string();
  };
  EXPECT_EQ(fails(contact, carried({0, 0, -2e-3})), "");
  const MatrixXd u = carried({R, 0, -R});
  const std::string said = fails(contact, u);
  EXPECT_NE(said.find("body 'ball'"), std::string::npos) << said;
  EXPECT_NE(said.find("obstacle 'post' at t = 1 s"), std::string::npos) << said;
  Contact all = contact;
  all.points = fall.full().contact_points(post, std::numeric_limits<double>::infinity());
  EXPECT_EQ(fails(all, u), "");
  // Points of another mesh are no part of this boundary.
  all.points.X *= 1.01;
  EXPECT_THROW(fails(all, u), std::logic_error);
}

// What an explicit scheme has blown up turns and enters anything: it has a status, not a fault of the scene. One that
// keeps its energy is not excused.
TEST(ImpactObstacles, BlownUpIsUnstable) {
  const Fall early(tilted_box(0.06));
  EXPECT_EQ(early.run(explicit_steps(), {.time_step = 2e-6}).status, Status::ok);
  EXPECT_EQ(early.run(explicit_steps(), {.time_step = 2e-4}).status, Status::unstable);
  EXPECT_THROW(Fall(tilted_box(0.15)).run(explicit_steps(), {.time_step = 2e-6}), std::runtime_error);
}

}  // namespace
}  // namespace mb
