// Loads that turn with a body of finite deformation (mechanics/system/finite_force.h).
#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/system/newmark.h"
#include "reference/finite_bodies_test.h"
#include "reference/static_answer.h"
#include "reference/sundials/sundials.h"

namespace mb {
namespace {

using testing::FreeBody;
const Shape bar = Box{{0.4, 0.1, 0.06}};
const Material stiff{1e9, 0.3, 1000};
constexpr double force = 2, T = 0.8;  // [N], [s]: half a turn and more

// A thruster along y at one end, switched on at t = 0.
struct Thrust {
  explicit Thrust(bool follows, double modulus = stiff.youngs_modulus) {
    Scene scene = testing::finite_body(bar, {modulus, 0.3, 1000}, {2, {2, 1, 1}}, {0, 1e-6});
    testing::load(scene, "x-max", Vector3d(0, force / (0.1 * 0.06), 0));
    scene.loads[0].follows = follows;
    model = testing::model_of(scene);
  }
  std::shared_ptr<const FullModel> model;
};

// Of a rigid body: theta'' = tau/J, c'' = R(theta) (0, F, 0)/m, by Simpson's rule on a thousand steps.
struct Rigid {
  double angle = 0;
  Vector3d c = Vector3d::Zero();
};
Rigid rigid_motion(double mass, double J, double t_end, bool follows) {
  Rigid now;
  const double alpha = 0.2 * force / J;  // of a dead load only while it hardly turns
  Vector3d v = Vector3d::Zero();
  const int n = 1000;
  const double h = t_end / n;
  const auto a = [&](double t) -> Vector3d {
    const double theta = follows ? alpha * t * t / 2 : 0;
    return force / mass * Vector3d(-std::sin(theta), std::cos(theta), 0);
  };
  for (int i = 0; i < n; ++i) {
    const double t = i * h;
    now.c += h * v + h * h / 6 * (a(t) + 2 * a(t + h / 2));
    v += h / 6 * (a(t) + 4 * a(t + h / 2) + a(t + h));
  }
  now.angle = alpha * t_end * t_end / 2;
  return now;
}

double angle_of(const System& system, const VectorXd& u) {
  const Eigen::Matrix3d Q = rotation(*system.stored_energy, u);
  return std::atan2(Q(1, 0), Q(0, 0));
}

// Nearly rigid: F L^3/(E I), by which it would bend if held, is 3e-5 m.
TEST(FollowingLoads, MoveAStiffBodyAsARigidOne) {
  const Thrust thrust(true);
  const System& system = thrust.model->system();
  const FreeBody body(*thrust.model);
  const double J = body.mass * (0.4 * 0.4 + 0.1 * 0.1) / 12;
  const VectorXd times{{0.2, 0.5, T}};
  const States arkode = sundials(system, 1e-6, T)->run(times), average = newmark(system, 1e-3)->run(times);
  ASSERT_EQ(arkode.status, Status::ok);
  ASSERT_EQ(average.status, Status::ok);
  for (Index k = 0; k < 3; ++k) {
    const Rigid rigid = rigid_motion(body.mass, J, times[k], true);
    const double turned = std::remainder(rigid.angle, 2 * pi);
    EXPECT_NEAR(angle_of(system, arkode.u.col(k)), turned, 2e-3 * rigid.angle) << k;
    EXPECT_NEAR(angle_of(system, average.u.col(k)), turned, 4e-3 * rigid.angle) << k;
    EXPECT_LT((body.centroid(arkode.u.col(k)) - rigid.c).norm(), 2e-3 * rigid.c.norm()) << k;
    EXPECT_LT((body.centroid(average.u.col(k)) - rigid.c).norm(), 4e-3 * rigid.c.norm()) << k;
  }
  EXPECT_GT(rigid_motion(body.mass, J, T, true).angle, pi);
}

// A load that keeps its axes gives the centroid a parabola whatever the body does; one that follows does not.
TEST(FollowingLoads, AreNotDeadOnes) {
  const Thrust dead(false);
  const FreeBody body(*dead.model);
  const VectorXd end = VectorXd::Constant(1, T);
  const States states = sundials(dead.model->system(), 1e-6, T)->run(end);
  const Vector3d fallen(0, force * T * T / (2 * body.mass), 0);
  EXPECT_LT((body.centroid(states.u.col(0)) - fallen).norm(), 1e-9 * fallen.norm());
  const Vector3d turned = rigid_motion(body.mass, body.mass * 0.17 / 12, T, true).c;
  EXPECT_GT((turned - fallen).norm(), 0.1 * fallen.norm());
}

// Average acceleration, of order two, with the load turned in its own stage.
TEST(FollowingLoads, KeepTheOrderOfSteps) {
  System system = Thrust(true, 1e7).model->system();
  system.s = {Pulse{0.3, 20}};  // smooth, a turn
  const VectorXd end = VectorXd::Constant(1, 0.3);
  const VectorXd exact = sundials(system, 1e-9, 0.3)->run(end).u.col(0);
  const auto error = [&](double h) { return (newmark(system, h)->run(end).u.col(0) - exact).norm(); };
  EXPECT_NEAR(std::log2(error(2.5e-4) / error(1.25e-4)), 2, 0.25);  // longer steps make waves grow
}

TEST(FollowingLoads, AreRefusedWhereTheirNumberIsWrong) {
  System system = Thrust(true).model->system();
  system.follows.push_back(false);
  EXPECT_THROW(newmark(system, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace mb
