// Two deformable bodies in full order.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"
#include "mechanics/contact/contact_steppers.h"
#include "mechanics/system/newmark.h"
#include "mechanics/verified_test.h"
#include "reference/full_model.h"
#include "reference/full_order.h"
#include "reference/integrators_test.h"

namespace mb {
namespace {

using testing::arkode;

constexpr double R = 0.05, speed = 1.5, layer = 5e10;  // [m], [m/s], [Pa/m]
const Material rubber{5e6, 0.45, 1100};

Body ball(const std::string& name, Kinematics kinematics, const Vector3d& place, const Vector3d& velocity) {
  Body body = one_body(Sphere{R}, rubber, {2, {1}, 1}).bodies[0];
  body.name = name;
  body.kinematics = kinematics;
  body.damping.beta = 2e-5;
  body.pose.position = place;
  body.twist.velocity = velocity;
  return body;
}

struct Answered {
  // fineness: the relative tolerance or the time step [s], whichever the integrator looks at.
  explicit Answered(const Scene& of, double fineness = 1e-4, const Integrator& integrator = arkode())
      : scene(std::make_shared<const Scene>(of)), model(build_model(scene)) {
    Settings settings;
    settings.relative_tolerance = settings.time_step = fineness;
    answer = full_order()->prepare(model, settings, integrator)->simulate({VectorXd::LinSpaced(81, 0, of.duration)});
  }
  const BodyTrajectory& body(size_t b) const { return answer.bodies.at(b); }
  Vector3d centre(size_t b, Index k) const {  // [m] world
    const auto& [X, w] = model.bodies[b].points.volume;
    return (X + body(b).displacement.col(k).head(3 * X.cols()).reshaped(3, X.cols()).matrix()) * w / w.sum();
  }
  double mass(size_t b) const { return model.bodies[b].full->system().M.sum() / 3; }
  std::shared_ptr<const Scene> scene;
  Model model;
  Trajectory answer;
};

Scene empty(double duration) {
  Scene scene = one_body(Sphere{R}, rubber, {2, {1}});
  scene.bodies.clear();
  scene.duration = duration;
  return scene;
}

// The plane of symmetry between two like balls is a rigid floor to either, whose layer half as deep is twice as stiff.
class TwoLikeBallsVerification : public ::testing::TestWithParam<Kinematics> {};

TEST_P(TwoLikeBallsVerification, MeetAsOneMeetsItsMirror) {
  Scene both = empty(0.008);
  both.bodies = {ball("upper", GetParam(), {0, 0, R + 1e-3}, {0, 0, -speed}),
                 ball("lower", GetParam(), {0, 0, -R - 1e-3}, {0, 0, speed})};
  both.contacts.push_back({.body = "upper", .obstacle = "lower", .stiffness = layer});
  Scene one = empty(0.008);
  one.bodies = {both.bodies[0]};
  one.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  one.contacts.push_back({.body = "upper", .obstacle = "floor", .stiffness = 2 * layer});
  const Answered pair(both), single(one);
  ASSERT_EQ(pair.answer.status, Status::ok);
  const Touch &met = pair.body(0).contact.touches.at(0), &mirrored = single.body(0).contact.touches.at(0);
  EXPECT_NEAR(met.start, mirrored.start, 1e-9);
  // Feet on the other's facets are off the mirrored points by the meshes' own error; the last of them part slowly.
  EXPECT_NEAR(met.end, mirrored.end, 0.04 * (mirrored.end - mirrored.start));
  const Eigen::Vector2d off(met.peak_force / mirrored.peak_force - 1, met.impulse[2] / mirrored.impulse[2] - 1);
  testing::expect_verified(
      {.quantity = "largest force and impulse of two like balls that meet",
       .reference = "property",
       .source = "symmetry: either meets a rigid floor through a layer half as deep and twice as stiff",
       .uncertainty = "1e-4, the tolerance of a step of either run",
       .tolerance = 3e-3,
       .why = "Contact points lie on facets of the other's surface, off the mirrored ones by the mesh's own error."},
      off.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
}

TEST_P(TwoLikeBallsVerification, HandOverMomentumAndKeepEnergy) {
  Scene scene = empty(0.02);
  scene.bodies = {ball("small", GetParam(), {0, 0, R + 1e-3}, {0.2, 0, -speed}),
                  ball("big", GetParam(), {0.01, 0, -R - 1e-3}, {0, 0, 0})};
  scene.bodies[1].material.density *= 3;
  scene.contacts.push_back({.body = "small", .obstacle = "big", .stiffness = layer});
  const Answered run(scene, 1e-3);
  ASSERT_EQ(run.answer.status, Status::ok);
  const Index end = run.answer.t.size() - 1;
  const double angular = GetParam() == Kinematics::finite ? 1e-3 : 0.1;
  const ContactHistory &on_small = run.body(0).contact, &on_big = run.body(1).contact;
  EXPECT_LT((on_small.impulse + on_big.impulse).norm(), 1e-14 * on_small.impulse.norm());
  EXPECT_GT(on_small.impulse(2, end), run.mass(0) * speed);
  // Velocities from two samples of free flight after it.
  const double dt = run.answer.t[end] - run.answer.t[end - 40];
  for (const size_t b : {0, 1}) {
    const Vector3d v = (run.centre(b, end) - run.centre(b, end - 40)) / dt;
    const Vector3d gained = run.mass(b) * (v - scene.bodies[b].twist.velocity);
    // Centroids are the evaluation points', which see a little of the vibrations.
    EXPECT_LT((gained - run.body(b).contact.impulse.col(end)).norm(), 1e-3 * on_small.impulse.col(end).norm()) << b;
  }
  // By the meshes' own mass: linear momentum to rounding at every time, while they touch, too. Angular momentum about
  // the origin: forces act at feet on the other's facets; linear kinematics turn forces by the places at rest, off by
  // the deflection over the size.
  const MatrixXd P = run.body(0).momentum + run.body(1).momentum;
  ASSERT_EQ(P.cols(), end + 1);
  const double J = on_small.impulse.col(end).norm();
  EXPECT_NEAR(run.body(0).momentum(2, 0), -run.mass(0) * speed, 1e-12 * J);
  EXPECT_LT((P.topRows(3).colwise() - P.col(0).head(3)).colwise().norm().maxCoeff(), 1e-10 * J);
  // The impulse on one is the sum of its stages' forces.
  const Vector3d gained = run.body(0).momentum.col(end).head(3) - run.body(0).momentum.col(0).head(3);
  EXPECT_LT((gained - on_small.impulse.col(end)).norm(), 1e-10 * J);
  const double spin = 0.2 * run.mass(0) * (R + 1e-3);  // z p_x - x p_z
  EXPECT_NEAR(P(4, 0), spin, 1e-2 * spin);             // a mesh graded towards the touch has its centroid off by 4e-3
  EXPECT_LT((P.bottomRows(3).colwise() - P.col(0).tail(3)).colwise().norm().maxCoeff(), angular * J * R);
  const VectorXd E = run.body(0).energy + run.body(1).energy;
  const double brought = run.mass(0) * (speed * speed + 0.04) / 2;
  EXPECT_NEAR(E[0], brought, 1e-12 * brought);
  EXPECT_LT(E.maxCoeff(), (1 + 0.02) * brought);  // the integrator's tolerance, and what it takes of the layer
  EXPECT_GT(E[end], 0.5 * brought);
  EXPECT_LT(E[end], 0.999 * brought);  // Rayleigh's damping
}

INSTANTIATE_TEST_SUITE_P(Kinematics, TwoLikeBallsVerification,
                         ::testing::Values(Kinematics::linear, Kinematics::finite),
                         [](const auto& of) { return std::string(to_string(of.param)); });

// Forces act at one point, friction is none: what steps leave is left.
TEST(TwoBodiesVerification, OfFiniteStrainKeepAngularMomentumToTheTolerance) {
  Scene scene = empty(0.008);
  scene.bodies = {ball("small", Kinematics::finite, {0, 0, R + 1e-3}, {0.2, 0, -speed}),
                  ball("big", Kinematics::finite, {0.01, 0, -R - 1e-3}, {0, 0, 0})};
  scene.contacts.push_back({.body = "small", .obstacle = "big", .stiffness = layer});
  const auto drift = [&](double tolerance) {  // over the momentum of the blow at the radius
    const Answered run(scene, tolerance);
    EXPECT_EQ(run.answer.status, Status::ok);
    const MatrixXd L = (run.body(0).momentum + run.body(1).momentum).bottomRows(3);
    return (L.colwise() - L.col(0)).colwise().norm().maxCoeff() / (run.mass(0) * speed * R);
  };
  for (const double tolerance : {1e-2, 1e-3})  // 9e-4 and 1.5e-7 were seen
    EXPECT_LT(drift(tolerance), tolerance / 5) << tolerance;
}

// Explicit steps keep the momentum of the lumped mass that they accelerate, which is not the consistent one's.
TEST(TwoBodies, ByTheMassThatIsSteppedMomentumIsKeptToRounding) {
  Scene scene = empty(0.012);
  scene.bodies = {ball("small", Kinematics::linear, {0, 0, R + 1e-3}, {0.2, 0, -speed}),
                  ball("big", Kinematics::linear, {0.01, 0, -R - 1e-3}, {0, 0, 0})};
  scene.contacts.push_back({.body = "small", .obstacle = "big", .stiffness = layer});
  const Answered run(scene, 1e-6, testing::explicit_steps());
  ASSERT_EQ(run.answer.status, Status::ok);
  const Index end = run.answer.t.size() - 1;
  const double J = run.body(0).contact.impulse.col(end).norm();
  ASSERT_GT(J, 0.5 * run.mass(0) * speed);
  const MatrixXd P = (run.body(0).momentum + run.body(1).momentum).topRows(3);
  EXPECT_LT((P.colwise() - P.col(0)).colwise().norm().maxCoeff(), 1e-10 * J);
  const Vector3d gained = (run.body(0).momentum.col(end) - run.body(0).momentum.col(0)).head(3);
  EXPECT_LT((gained - run.body(0).contact.impulse.col(end)).norm(), 1e-10 * J);
  const double lumped = run.model.bodies[0].full->system().lumped_mass.sum() / 3;
  EXPECT_GT(std::abs(lumped / run.mass(0) - 1), 2e-5);  // else the test would see no difference
  EXPECT_NEAR(run.body(0).momentum(2, 0), -lumped * speed, 1e-12 * J);
}

// Of bodies of different kinematics each keeps its own.
TEST(TwoBodies, AFiniteBallMeetsALinearOne) {
  Scene scene = empty(0.008);
  scene.bodies = {ball("soft", Kinematics::finite, {0, 0, R + 1e-3}, {0, 0, -speed}),
                  ball("hard", Kinematics::linear, {0, 0, -R - 1e-3}, {0, 0, 0})};
  scene.bodies[1].material.youngs_modulus *= 100;
  scene.contacts.push_back({.body = "soft", .obstacle = "hard", .stiffness = layer});
  const Answered run(scene);
  ASSERT_EQ(run.answer.status, Status::ok);
  const double J = run.body(0).contact.impulse(2, run.answer.t.size() - 1), m = run.mass(0) / 2;  // reduced mass
  EXPECT_GT(J, 1.5 * m * speed);
  EXPECT_LT(J, 2 * m * speed);
  scene.bodies[0].damping.alpha = 1;  // not the other's
  EXPECT_THROW(Answered{scene}, std::invalid_argument);
}

}  // namespace
}  // namespace mb
