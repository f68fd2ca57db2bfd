// The closed forms of thrown rods and spheres as answers to scenes: `rod-on-wall`, `hertz-impact`.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/exact/exact.h"
#include "cases/exact/exact_test_problems.h"
#include "cases/scene/one_body.h"
#include "mechanics/geometry/pose.h"
#include "mechanics/geometry/signed_distance.h"

namespace mb {
namespace {

Scene thrown(const Shape& shape, const Material& material, const Vector3d& position, const Vector3d& velocity) {
  Scene scene = one_body(shape, material, {1, {1}});
  scene.loads.clear();
  scene.bodies[0].pose.position = position;
  scene.bodies[0].twist.velocity = velocity;
  scene.obstacles.push_back({"wall", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({"body", "wall", 0});
  return scene;
}

// c = 50 m/s, 2 L/c = 8 ms; its y axis towards a slanting wall, along which it slides; k_n L/E = 50.
Scene rod() {
  Scene scene = thrown(Box{Vector3d(0.03, 0.2, 0.05)}, {3e6, 0, 1200, {}}, {}, {});
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));
  const Vector3d n = turn * Vector3d::UnitZ(), across = turn * Vector3d::UnitX();
  Body& body = scene.bodies[0];
  scene.obstacles[0].surface.pose = {Vector3d(0.3, 0.1, -0.2), turn};
  body.pose.position = Vector3d(0.3, 0.1, -0.2) + 0.101 * n + 0.3 * across;
  body.pose.orientation = turn * shortest_turn(-Vector3d::UnitY(), Vector3d::UnitZ());
  body.twist.velocity = -0.5 * n + 0.2 * across;
  scene.contacts[0].stiffness = 50 * 3e6 / 0.2;
  scene.duration = 0.02;
  scene.samples_per_second = scene.frame_rate = 2e4;
  return scene;
}

// a/R = 0.02: dropped from 1 mm, at 0.14 m/s.
Scene ball() {
  Scene scene = thrown(Sphere{0.01}, {2.4e10, 0.3, 1000, {}}, {0, 0, 0.011}, {0.05, 0, 0});
  scene.gravity = {0, 0, -9.81};
  scene.duration = 0.0145;
  scene.samples_per_second = scene.frame_rate = 4e6;
  return scene;
}

double mass(const Scene& scene) { return scene.bodies[0].material.density * volume(scene.bodies[0].shape); }

Trajectory answer(const std::string& name, const Scene& scene, const VectorXd& t) {
  return exact_solution(name).at(scene, evaluation_points(scene, scene.bodies[0]), t);
}

// The points of the face that touches are as deep in the wall as the force says, all the same.
TEST(ThrownRod, TouchesWithAWholeFace) {
  Scene scene = rod();
  scene.probes = {{"a", "body", Vector3d(0.01, 0.1, 0.02), Vector3d::UnitX()},
                  {"b", "body", Vector3d(-0.015, 0.1, -0.025), Vector3d::UnitX()}};
  const Trajectory said = answer("rod-on-wall", scene, sample_times(scene));
  const ContactHistory& contact = said.bodies[0].contact;
  const RigidSurface& wall = scene.obstacles[0].surface;
  const Vector3d n = wall.pose.orientation * Vector3d::UnitZ();
  const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  const double area = 0.03 * 0.05, k_n = scene.contacts[0].stiffness;
  for (Index j = 0; j < said.t.size(); ++j) {
    const double force = contact.force.col(j).dot(n);
    EXPECT_NEAR((contact.force.col(j) - force * n).norm(), 0, 1e-12 * area * 3e6);
    EXPECT_NEAR(contact.stored[j], force * force / (2 * k_n * area), 1e-15 + 1e-12 * contact.stored[j]);
    for (Index i = 0; i < 2; ++i) {
      const Vector3d x = points.probes.col(i) + said.bodies[0].displacement.col(j).tail(6).segment<3>(3 * i);
      EXPECT_NEAR(std::max(0.0, -gap_value(wall, x)), force / (area * k_n), 1e-13) << j;
    }
  }
}

// Momentum by the touch, by the force's integral, and by the points' mean; along the wall nothing changes.
TEST(ThrownRod, ReboundsWithWhatTheImpulseGave) {
  const Scene scene = rod();
  const Trajectory said = answer("rod-on-wall", scene, sample_times(scene));
  const ContactHistory& contact = said.bodies[0].contact;
  ASSERT_EQ(contact.touches.size(), 1u);
  const Touch& touch = contact.touches[0];
  EXPECT_NEAR(touch.start, 0.002, 1e-12);
  EXPECT_NEAR(touch.end - touch.start, 0.008 * (1 + 1.678347 / 100), 1e-6 * 0.008);
  const double interval = 1 / scene.samples_per_second;
  const Vector3d sum = interval * contact.force.rowwise().sum();
  EXPECT_LT((sum - touch.impulse).norm(), 1e-3 * touch.impulse.norm());  // sums know the steep ends to a sample
  EXPECT_EQ(contact.impulse.rightCols(1), touch.impulse);
  EXPECT_NEAR(touch.impulse.norm(), mass(scene) * 0.5 * (2 - 0.103423 / 100), 1e-6 * mass(scene));
  const auto& [X, w] = evaluation_points(scene, scene.bodies[0]).volume;
  const auto centre = [&](Index j) {
    return Vector3d(said.bodies[0].displacement.col(j).head(3 * X.cols()).reshaped(3, X.cols()).matrix() * w / w.sum());
  };
  const Index n = said.t.size() - 1;  // the mean of a vibration over one passage vanishes
  const Vector3d v = (centre(n) - centre(n - 160)) / (160 * interval);
  const Vector3d expected = scene.bodies[0].twist.velocity + touch.impulse / mass(scene);
  EXPECT_LT((v - expected).norm(), 1e-9 * expected.norm());
}

// Strain -p/E near the wall, only along the rod; nothing before the touch.
TEST(ThrownRod, IsStrainedAlongItsAxisAlone) {
  Scene scene = rod();
  scene.probes = {{"a", "body", Vector3d(0.01, 0.1, 0.02), Vector3d::UnitX()}};
  const Trajectory said = answer("rod-on-wall", scene, sample_times(scene));
  const MatrixXd& strain = said.bodies[0].strain;
  const Vector3d n = scene.obstacles[0].surface.pose.orientation * Vector3d::UnitZ();
  for (Index j = 0; j < said.t.size(); ++j) {
    EXPECT_NEAR(strain(strain.rows() - 5, j), -said.bodies[0].contact.force.col(j).dot(n) / (0.0015 * 3e6), 1e-14);
    if (said.t[j] < 0.002) {
      EXPECT_EQ(strain.col(j).norm(), 0);
    }
  }
  for (Index row = 0; row < strain.rows(); ++row)
    if (row % 6 != 1) {
      EXPECT_EQ(strain.row(row).norm(), 0);
    }
  EXPECT_GT(strain.norm(), 0);
}

TEST(ThrownSphere, ImpulseIsTheIntegralOfForce) {
  const Scene scene = ball();
  const Trajectory said = answer("hertz-impact", scene, sample_times(scene));
  const ContactHistory& contact = said.bodies[0].contact;
  ASSERT_EQ(contact.touches.size(), 1u);
  const Touch& touch = contact.touches[0];
  const double v = std::sqrt(2 * 9.81 * 1e-3), T = touch.end - touch.start;
  EXPECT_NEAR(touch.start, v / 9.81, 1e-12);
  EXPECT_NEAR(touch.impulse.z(), mass(scene) * (2 * v + 9.81 * T), 1e-12 * mass(scene));
  EXPECT_EQ(touch.impulse.head(2).norm(), 0);  // what slides goes on sliding
  const double interval = 1 / scene.samples_per_second;
  double sum = 0;
  for (Index j = 1; j < said.t.size(); ++j) {  // second order but at the ends, where force is like t^(3/2)
    sum += interval / 2 * (contact.force(2, j - 1) + contact.force(2, j));
    ASSERT_NEAR(contact.impulse(2, j), sum, 1e-5 * touch.impulse.z()) << said.t[j];
  }
  EXPECT_NEAR(contact.force.row(2).maxCoeff(), touch.peak_force, 1e-4 * touch.peak_force);
  EXPECT_EQ(said.bodies[0].displacement.cols(), 0);
  EXPECT_EQ(said.bodies[0].strain.cols(), 0);
}

TEST(ThrownSphere, SaysNothingOfATouchToCome) {
  const Scene scene = ball();
  const Trajectory said = answer("hertz-impact", scene, VectorXd::LinSpaced(5, 0, 0.01));
  EXPECT_TRUE(said.bodies[0].contact.touches.empty());
  EXPECT_EQ(said.bodies[0].contact.force.norm() + said.bodies[0].contact.impulse.norm(), 0);
  const Trajectory none = answer("rod-on-wall", rod(), VectorXd::LinSpaced(3, 0, 0.001));
  EXPECT_TRUE(none.bodies[0].contact.touches.empty());
}

const std::vector<Wrong> common = {
    {[](Scene& s) { s.bodies.push_back(s.bodies[0]); }, "needs one body, there are 2"},
    {[](Scene& s) { s.contacts.clear(); }, "needs one contact, there are 0"},
    {[](Scene& s) { s.contacts[0].obstacle = "floor"; }, "the obstacle is not a half-space"},
    {[](Scene& s) { s.obstacles[0].surface.shape = Sphere{1}; }, "the obstacle is not a half-space"},
    {[](Scene& s) { s.contacts[0].friction = 0.1; }, "has friction"},
    {[](Scene& s) { s.contacts[0].damping = 1e-3; }, "the contact is damped"},
    {[](Scene& s) { s.contacts[0].law = ContactLaw::hertz; }, "not by the penalty law"},
    {[](Scene& s) { s.bodies[0].damping.beta = 1e-9; }, "the body is damped"},
    {[](Scene& s) { s.bodies[0].material.orthotropy = Orthotropy{}; }, "not isotropic"},
    {[](Scene& s) { s.bodies[0].twist.angular_velocity.x() = 1; }, "the body spins"},
    {[](Scene& s) {
       s.bodies[0].supports.push_back({Support::Kind::fixed, {"z-max", {}}, {}});
     },
     "not free"},
    {[](Scene& s) { s.bodies[0].theory = Theory::kirchhoff; }, "theory is kirchhoff"},
    {[](Scene& s) {
       s.loads = {{"pull", Step{1, 0}, {}}};
     },
     "the body is loaded"},
    {[](Scene& s) {
       s.bodies[0].shape = Superquadric{{1, 1, 1}, 1, 1};
     },
     "the body is no"},
    {[](Scene& s) {
       s.bodies[0].pose.position -= 1e-2 * (s.obstacles[0].surface.pose.orientation * Vector3d::UnitZ());
     },
     "within obstacle 'wall'"},
    {[](Scene& s) { s.duration = 1e-4; }, "nothing touches within the duration"},
};

TEST(ExactSolutionTest, NamesWhatDoesNotFitAThrownRod) {
  expect_problems("rod-on-wall", rod(), common);
  expect_problems("rod-on-wall", rod(),
                  {{[](Scene& s) { s.bodies[0].material.poissons_ratio = 0.3; }, "Poisson's ratio is 0.3, not 0"},
                   {[](Scene& s) { s.gravity.x() = 1; }, "there is gravity"},
                   {[](Scene& s) { s.contacts[0].stiffness /= 20; }, "must be at least 5"},
                   {[](Scene& s) { s.bodies[0].shape = Sphere{0.05}; }, "no box or cylinder"},
                   {[](Scene& s) {
                      s.bodies[0].shape = Cylinder{0.05, 0.2};
                    },
                    "no box or cylinder"},  // lies down
                   {[](Scene& s) {
                      s.bodies[0].pose.orientation =
                          Eigen::AngleAxisd(1e-3, Vector3d::UnitX()) * s.bodies[0].pose.orientation;
                    },
                    "no box or cylinder that meets the plane with a whole face"}});
}

TEST(ExactSolutionTest, NamesWhatDoesNotFitAThrownSphere) {
  expect_problems("hertz-impact", ball(), common);
  expect_problems("hertz-impact", ball(),
                  {{[](Scene& s) { s.bodies[0].shape = Box{Vector3d(0.02, 0.02, 0.02)}; }, "the body is not a sphere"},
                   {[](Scene& s) { s.contacts[0].stiffness = 4e15; }, "the layer is soft, k_n a/E* = "},
                   {[](Scene& s) {
                      s.gravity.setZero();
                      s.bodies[0].twist.velocity.z() = -4;
                    },
                    "waves count"},
                   {[](Scene& s) { s.bodies[0].material.youngs_modulus = 2.4e4; }, "Hertz's a/R"},
                   {[](Scene& s) { s.duration = 0.05; }, "comes back within the duration"}});
}

}  // namespace
}  // namespace mb
