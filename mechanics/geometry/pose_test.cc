#include "mechanics/geometry/pose.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

TEST(Pose, FrameAndWorldAreInverse) {
  const Pose pose{{1, -2, 3}, Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()))};
  const Vector3d X(0.3, 0.4, -5);
  EXPECT_LT((pose.to_frame(pose.to_world(X)) - X).norm(), 1e-14);
}

TEST(NearestRotation, OfAStretchedTurnIsTheTurn) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.1, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Eigen::Matrix3d stretch = Vector3d(3, 1, 0.2).asDiagonal();
  EXPECT_LT((nearest_rotation(turn * stretch) - turn).norm(), 1e-14);
}

TEST(NearestRotation, OfAMirrorIsARotation) {
  const Eigen::Matrix3d R = nearest_rotation(Vector3d(3, 2, -1).asDiagonal());
  EXPECT_LT((R - Eigen::Matrix3d::Identity()).norm(), 1e-14);  // the least singular value changes its sign
}

TEST(ShortestTurn, TakesOneDirectionToTheOther) {
  const Vector3d a = Vector3d(1, 2, -1).normalized(), b = Vector3d(-2, 0.3, 1).normalized();
  const Eigen::Quaterniond turn = shortest_turn(a, 2 * b);
  EXPECT_LT((turn * a - b).norm(), 1e-14);
  EXPECT_NEAR(turn.vec().dot(a), 0, 1e-14);  // about what stands across both
  EXPECT_LT((shortest_turn(a, -a) * a + a).norm(), 1e-14);
}

}  // namespace
}  // namespace mb
