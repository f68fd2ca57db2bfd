#include "harness/metrics/momentum_audit.h"

#include <gmock/gmock.h>

#include "harness/metrics/one_touch_test.h"

namespace mb {
namespace {

using ::testing::StartsWith;

using namespace one_touch;

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
