#include "harness/metrics/momentum_audit.h"

#include <gmock/gmock.h>

#include "cases/scene/one_body.h"

namespace mb {
namespace {

using ::testing::StartsWith;

// A block of 0.1 x 0.2 x 0.3 m under a weight, looked at in one point at 0, 0.1, ..., 0.4 s.
struct Setting {
  Scene scene = one_body(Box{{0.1, 0.2, 0.3}}, {1e6, 0.3, 1000, {}}, {1, {1, 1, 1}});
  EvaluationPoints points;
  MetricContext context(bool free = true) const { return {scene, 0, points, free}; }
};
Setting setting() {
  Setting s;
  s.scene.gravity = {0, 0, -10};
  s.points.volume = {Matrix3Xd::Zero(3, 1), VectorXd::Ones(1)};
  s.points.surface = {Matrix3Xd(3, 0), VectorXd(0)};
  s.points.probes = Matrix3Xd(3, 0);
  return s;
}

// One touch from 0.1 to 0.3 s, of 18 N s upwards; no momentum recorded.
Trajectory answer(const Setting& s) {
  Trajectory t{VectorXd::LinSpaced(5, 0, 0.4), {}, {}, Status::ok};
  BodyTrajectory body;
  body.displacement = MatrixXd::Zero(3 * s.points.size(), 5);
  body.strain = MatrixXd(0, 0);
  body.contact.force = body.contact.impulse = Matrix3Xd::Zero(3, 5);
  body.contact.force(2, 2) = 90;
  body.contact.impulse.row(2) << 0, 0, 9, 18, 18;
  body.contact.stored = body.contact.dissipated = VectorXd::Zero(5);
  body.contact.touches = {{0.1, 0.3, 90, 0.2, {0, 0, 18}}};
  t.bodies.push_back(body);
  return t;
}

Mark marked(const std::string& name, const Trajectory& a, const Trajectory& b, const MetricContext& context) {
  return mark(metric(name), a, b, context);
}
double value(const std::string& name, const Trajectory& a, const Trajectory& b, const MetricContext& context) {
  const Mark of = marked(name, a, b, context);
  EXPECT_EQ(of.status, "ok") << name;
  return of.value;
}

TEST(MomentumAudit, MomentumDriftByHand) {
  Setting s = setting();
  Trajectory a = answer(s);
  BodyTrajectory& b = a.bodies[0];
  EXPECT_THAT(marked("momentum-drift", a, a, s.context()).status, StartsWith("undefined"));  // not recorded
  b.momentum = MatrixXd::Zero(6, 5);
  b.momentum.topRows(3) = a.bodies[0].contact.impulse;
  b.momentum.row(2).array() -= 12;  // of the fall
  EXPECT_EQ(value("momentum-drift", a, a, s.context()), 0);
  b.momentum(0, 2) = 5;  // while it presses impulses are interpolated
  EXPECT_EQ(value("momentum-drift", a, a, s.context()), 0);
  b.momentum(0, 4) = 0.18;
  EXPECT_NEAR(value("momentum-drift", a, a, s.context()), 0.01, 1e-15);
  EXPECT_THAT(marked("angular-drift", a, a, s.context()).status, StartsWith("undefined"));  // the weight turns it
  EXPECT_THAT(marked("momentum-drift", a, a, s.context(false)).status, StartsWith("undefined"));
}

TEST(MomentumAudit, TwoFreeBodiesKeepTheirSums) {
  Setting s = setting();
  s.scene.gravity.setZero();
  s.scene.bodies.push_back(s.scene.bodies[0]);
  s.scene.bodies[1].name = "other";
  s.scene.contacts = {{.body = "body", .obstacle = "other", .stiffness = 1e9}};
  Trajectory a = answer(s);
  a.bodies[0].momentum = MatrixXd::Zero(6, 5);
  a.bodies[0].momentum.topRows(3) = a.bodies[0].contact.impulse;
  a.bodies.push_back(a.bodies[0]);
  a.bodies[1].momentum *= -1;
  a.bodies[1].contact.impulse *= -1;
  EXPECT_EQ(value("momentum-drift", a, a, s.context()), 0);
  EXPECT_EQ(value("angular-drift", a, a, s.context()), 0);
  Trajectory lost = a;  // while they touch, too
  lost.bodies[1].momentum(1, 2) += 0.36;
  lost.bodies[1].momentum(5, 3) += 0.054;
  EXPECT_NEAR(value("momentum-drift", lost, a, s.context()), 0.02, 1e-15);
  EXPECT_NEAR(value("angular-drift", lost, a, s.context()), 0.054 / (18 * 0.3), 1e-15);
  Trajectory taken = a;  // by one, not given by the other
  taken.bodies[1].contact.impulse(0, 4) = 0.9;
  taken.bodies[1].momentum(0, 4) = 0.9;
  taken.bodies[0].momentum(0, 4) = -0.9;
  EXPECT_NEAR(value("momentum-drift", taken, a, s.context()), 0.05, 1e-14);
}

}  // namespace
}  // namespace mb
