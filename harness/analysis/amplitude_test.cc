#include <gtest/gtest.h>

#include <cmath>

#include "cases/contract/touchdown.h"
#include "cases/scene/one_body.h"
#include "harness/analysis/amplitude_sweep.h"
#include "harness/analysis/contact_variants.h"

namespace mb {
namespace {

Scene falling() {
  Scene scene = one_body(Sphere{0.05}, {1e6, 0.3, 1000}, {1, {1}});
  scene.bodies[0].pose.position = {0, 0, 0.55};
  scene.gravity = {0, 0, -9.81};
  scene.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  scene.contacts.push_back({"body", "floor", 0});
  return scene;
}

TEST(Amplitude, ThrownBodiesMeetAtTheirShareOfTheSpeed) {
  const Scene scene = falling();
  const Meeting own = touchdown(scene, scene.bodies[0]).meetings.at(0);
  for (const double factor : {0.1, 1.0, 2.0}) {
    const Scene changed = thrown(scene, factor, 0.02, 0.03);
    const Meeting met = touchdown(changed, changed.bodies[0]).meetings.at(0);
    EXPECT_NEAR(met.t, 0.02, 1e-8) << factor;  // touches are found to 1e-9 of sizes
    EXPECT_NEAR(met.size.speed, factor * own.size.speed, 1e-8) << factor;
    EXPECT_EQ(changed.contacts[0].stiffness, own.size.stiffness);
    EXPECT_DOUBLE_EQ(changed.duration, 0.05);
    EXPECT_TRUE(changed.gravity.isZero(0));
  }
}

TEST(Amplitude, RefusesBodiesThatSpinOrNeverMeet) {
  Scene spinning = falling(), missing = falling();
  spinning.bodies[0].twist.angular_velocity = {1, 0, 0};
  missing.gravity.setZero();
  EXPECT_THROW(thrown(spinning, 1, 0.1, 0.1), std::invalid_argument);
  EXPECT_THROW(thrown(missing, 1, 0.1, 0.1), std::invalid_argument);
}

TEST(Amplitude, LimitsLieOnLinesInLogarithms) {
  const VectorXd x{{1, 2, 4, 8}}, square = 1e-3 * x.array().square();
  EXPECT_NEAR(where_passed(x, square, 0.01).at, std::sqrt(10), 1e-12);
  EXPECT_EQ(where_passed(x, square, 1e-4).at, 0);
  EXPECT_TRUE(std::isinf(where_passed(x, square, 1).at));
  VectorXd failed = square;
  failed[2] = NAN;  // between its neighbours
  EXPECT_NEAR(where_passed(x, failed, 0.01).at, std::sqrt(10), 1e-12);
  EXPECT_NEAR(where_passed(x, square, 0.01).bar, std::sqrt(10) - 2, 1e-12);
  EXPECT_NEAR(where_passed(x, failed, 0.01).bar, 8 - std::sqrt(10), 1e-12);
}

TEST(Amplitude, PrincipalStrainsKnowNoAxes) {
  MatrixXd strain = MatrixXd::Zero(6, 2);
  strain(3, 0) = 0.2;  // gamma_yz: +-0.1
  strain.col(1) << 0.01, -0.03, 0.02, 0, 0, 0;
  EXPECT_NEAR(largest_principal(strain.leftCols(1)), 0.1, 1e-15);
  EXPECT_NEAR(largest_principal(strain.rightCols(1)), 0.03, 1e-15);
}

}  // namespace
}  // namespace mb
