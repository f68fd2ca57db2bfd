#include "harness/metrics/linearity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/scene/one_body.h"

namespace mb {
namespace {

Scene bar() { return one_body(Box{{0.1, 0.12, 0.4}}, {1e6, 0.3, 1000}, {1, {1, 1, 2}}); }

// u = G X at the points, eps = sym G, at one time, and half of it at another.
Trajectory linear_field(const EvaluationPoints& points, const Eigen::Matrix3d& G) {
  Trajectory answer;
  answer.t = VectorXd{{0, 1}};
  BodyTrajectory body;
  const Matrix3Xd u = G * points.all();
  body.displacement.resize(u.size(), 2);
  body.displacement.col(0) = 0.5 * u.reshaped();
  body.displacement.col(1) = u.reshaped();
  const Eigen::Vector<double, 6> e{G(0, 0), G(1, 1), G(2, 2), G(1, 2) + G(2, 1), G(0, 2) + G(2, 0), G(0, 1) + G(1, 0)};
  body.strain = e.replicate(points.n_strained(), 2);
  body.strain.col(0) *= 0.5;
  answer.bodies.push_back(body);
  return answer;
}

TEST(Linearity, FindsStrainAndRotationOfLinearFields) {
  const Scene scene = bar();
  const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  const MetricContext held{scene, 0, points, false};
  Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
  shear(0, 2) = 0.04;  // eps_xz = 0.02, rotation 0.02 about y
  EXPECT_NEAR(largest_strain(linear_field(points, shear), held), 0.02, 1e-15);
  EXPECT_NEAR(largest_rotation(linear_field(points, shear), held), 0.02, 1e-14);
  const Eigen::Matrix3d squeeze = Vector3d(0.01, 0.01, -0.05).asDiagonal();
  EXPECT_NEAR(largest_strain(linear_field(points, squeeze), held), 0.05, 1e-15);
  EXPECT_NEAR(largest_rotation(linear_field(points, squeeze), held), 0, 1e-14);
}

// A cantilever's linear bending, u_x = a (z^2 (3 l - z)), whose end turns by 3 a l^2; the points end short of it.
TEST(Linearity, FindsTheRotationOfABentBar) {
  const Scene scene = bar();
  const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  const MetricContext held{scene, 0, points, false};
  Trajectory answer = linear_field(points, Eigen::Matrix3d::Zero());
  const Matrix3Xd X = points.all();
  double expected = 0;
  for (Index p = 0; p < X.cols(); ++p) {
    const double z = X(2, p) + 0.2, a = 2, l = 0.4;
    answer.bodies[0].displacement(3 * p, 1) = a * z * z * (3 * l - z);
    answer.bodies[0].displacement(3 * p + 2, 1) = -X(0, p) * a * (6 * l * z - 3 * z * z);
    if (p < points.volume.points.cols()) expected = std::max(expected, a * (6 * l * z - 3 * z * z));
  }
  EXPECT_NEAR(largest_rotation(answer, held), expected, 1e-12);
  EXPECT_GT(expected, 0.9 * 3 * 2 * 0.16);
}

// A plate 200 times as wide as thick, bent by u_z = a x^2, u_x = -2 a x z: it turns by 2 a x.
TEST(Linearity, FindsTheRotationOfAThinPlate) {
  const Scene scene = one_body(Box{{1, 1, 0.005}}, {7e10, 0.22, 2500}, {1, {1, 1, 1}});
  const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  Trajectory answer = linear_field(points, Eigen::Matrix3d::Zero());
  const Matrix3Xd X = points.all();
  double expected = 0;
  for (Index p = 0; p < X.cols(); ++p) {
    answer.bodies[0].displacement(3 * p, 1) = -2 * 0.03 * X(0, p) * X(2, p);
    answer.bodies[0].displacement(3 * p + 2, 1) = 0.03 * X(0, p) * X(0, p);
    if (p < points.volume.points.cols()) expected = std::max(expected, std::abs(2 * 0.03 * X(0, p)));
  }
  EXPECT_NEAR(largest_rotation(answer, {scene, 0, points, false}), expected, 1e-9);
}

TEST(Linearity, TakesRigidMotionOutOfFreeBodies) {
  const Scene scene = bar();
  const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  const MetricContext free{scene, 0, points, true};
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Trajectory only = linear_field(points, turned - Eigen::Matrix3d::Identity());
  only.bodies[0].displacement.col(0).setZero();
  EXPECT_NEAR(largest_rotation(only, free), 0, 1e-14);
}

TEST(Linearity, HasNoStrainWhereNoneWasAskedFor) {
  const Scene scene = bar();
  const EvaluationPoints points = evaluation_points(scene, scene.bodies[0]);
  Trajectory answer = linear_field(points, Eigen::Matrix3d::Identity());
  answer.bodies[0].strain.resize(0, 0);
  EXPECT_TRUE(std::isnan(largest_strain(answer, {scene, 0, points, false})));
}

}  // namespace
}  // namespace mb
