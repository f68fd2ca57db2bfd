#include "reference/fem/finite_strain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "cases/scene/one_body.h"
#include "reference/full_model.h"
#include "reference/static_answer.h"

namespace mb {
namespace {

using Eigen::Matrix3d;

const Material rubber{2.3e4, 0.41, 1100};
constexpr double E = 2.3e4, beta = 3e-4;  // [Pa], [s]

Scene finite(const Shape& shape, const Resolution& mesh, const std::vector<Support>& supports = {}) {
  Scene scene = one_body(shape, rubber, mesh);
  scene.bodies[0].kinematics = Kinematics::finite;
  scene.bodies[0].damping = {0, beta};
  scene.bodies[0].supports = supports;
  return scene;
}
std::shared_ptr<const FullModel> model_of(const Scene& scene) {
  return full_model(scene, scene.bodies[0], scene.bodies[0].resolution);
}

VectorXd random_vector(Index n, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return VectorXd::NullaryExpr(n, [&] { return size * normal(random); });
}

// Supports that drop unknowns, one that is a mean, and a graded mesh with hanging nodes.
std::vector<Scene> bodies() {
  const Shape box = Box{{0.3, 0.2, 0.4}};
  std::vector<Scene> all{finite(box, {1, {2, 2, 3}}),
                         finite(box, {2, {1, 2, 2}}),
                         finite(Cylinder{0.05, 0.2}, {3, {0, 1}}),
                         finite(Sphere{0.07}, {4, {1}}),
                         finite(Sphere{0.07}, {2, {1}}),
                         finite(box, {2, {1, 1, 2}}, {testing::support(Support::Kind::fixed, testing::face("z-min"))}),
                         finite(box, {2, {1, 1, 2}},
                                {testing::support(Support::Kind::mean, testing::face("z-min")),
                                 testing::support(Support::Kind::sliding, testing::face("x-max"))})};
  Scene graded = finite(Sphere{0.07}, {2, {1}, 1});
  graded.bodies[0].pose.position.z() = 0.1;
  graded.gravity = {0, 0, -9.81};
  graded.obstacles.push_back({"floor", {HalfSpace{}, 0, {}}});
  graded.contacts.push_back({.body = graded.bodies[0].name, .obstacle = "floor", .stiffness = 0});
  all.push_back(graded);
  return all;
}

// Nodes are off their places by 4 % of what they are apart: strains of some ten per cent.
VectorXd deformed(const System& s, unsigned seed = 5) {
  const double apart = std::cbrt(s.M.sum() / rubber.density / static_cast<double>(s.u0.size()));
  return random_vector(s.u0.size(), 0.04 * apart, seed);
}

VectorXd force(const System& s, const VectorXd& u, const VectorXd& v) {
  VectorXd f;
  EXPECT_TRUE(s.stored_energy->force(u, v, f));
  return f;
}
VectorXd force(const System& s, const VectorXd& u) { return force(s, u, VectorXd::Zero(u.size())); }
SparseMatrix tangent(const System& s, const VectorXd& u, double by_u, double by_v) {
  SparseMatrix A = 0 * s.K;
  EXPECT_TRUE(s.stored_energy->add_tangent(u, by_u, by_v, A));
  return A;
}

TEST(FiniteStrain, TangentAtRestIsLinearElasticity) {
  for (const Scene& scene : bodies()) {
    const auto model = model_of(scene);
    const System& s = model->system();
    const VectorXd rest = VectorXd::Zero(s.u0.size());
    EXPECT_LT((tangent(s, rest, 1, 0) - s.K).norm(), 1e-13 * s.K.norm());  // rounding
    EXPECT_LT((tangent(s, rest, 0, 1) - beta * s.K).norm(), 1e-13 * beta * s.K.norm());
    EXPECT_LT(force(s, rest).norm(), 1e-13 * E * 0.01);  // [N] E times a face
    EXPECT_EQ(s.stored_energy->energy(rest), 0);
  }
}

// Central differences with step h: h^2 of truncation, 1e-16/h of rounding.
TEST(FiniteStrain, ForceAndTangentAreDerivatives) {
  for (const Scene& scene : bodies()) {
    const auto model = model_of(scene);
    const System& s = model->system();
    const VectorXd u = deformed(s), du = random_vector(u.size(), 1, 6), v = random_vector(u.size(), 1, 7);
    const double h = 1e-7;
    const VectorXd f = force(s, u);
    const double slope = (s.stored_energy->energy(u + h * du) - s.stored_energy->energy(u - h * du)) / (2 * h);
    EXPECT_NEAR(slope, f.dot(du), 1e-6 * f.norm() * du.norm());
    const SparseMatrix K = tangent(s, u, 1, 0), D = tangent(s, u, 0, 1);
    EXPECT_LT((K - SparseMatrix(K.transpose())).norm(), 1e-14 * K.norm());  // to the last digits: it is filled so
    const VectorXd change = (force(s, u + h * du) - force(s, u - h * du)) / (2 * h);
    EXPECT_LT((K * du - change).norm(), 1e-6 * change.norm());
    const VectorXd viscous = force(s, u, v) - f;
    EXPECT_LT((D * v - viscous).norm(), 1e-11 * viscous.norm());  // linear in v: rounding of f
    EXPECT_GT(v.dot(viscous), 0);
  }
}

TEST(FiniteStrain, RigidMotionsCostNothing) {
  const auto model = model_of(finite(Cylinder{0.05, 0.2}, {2, {1, 2}}));
  const System& s = model->system();
  const Matrix3d Q = Eigen::AngleAxisd(2.4, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Vector3d c(0.3, 5, -2), omega(40, -30, 70);
  const Matrix3Xd X = model->places().reshaped(3, s.u0.size() / 3);
  const auto moved = [&](const VectorXd& u) {
    const Matrix3Xd x = X + u.reshaped(3, X.cols()).matrix();
    return VectorXd(((Q * x).colwise() + c - X).reshaped());
  };
  const auto turned = [&](const VectorXd& f) { return VectorXd((Q * f.reshaped(3, X.cols()).matrix()).reshaped()); };
  const VectorXd rest = VectorXd::Zero(s.u0.size()), u = deformed(s);
  const double area = 0.01, size = E * area;              // [N]
  EXPECT_LT(force(s, moved(rest)).norm(), 1e-11 * size);  // rounding of x, 5 m, beside cells of 3 cm
  EXPECT_LT(s.stored_energy->energy(moved(rest)), 1e-13 * size);
  EXPECT_LT((force(s, moved(u)) - turned(force(s, u))).norm(), 1e-11 * size);
  EXPECT_NEAR(s.stored_energy->energy(moved(u)), s.stored_energy->energy(u), 1e-12 * s.stored_energy->energy(u));
  // A rigid velocity of the deformed body: neither viscous nor of any part in the velocities' complement.
  const Matrix3Xd x = X + moved(u).reshaped(3, X.cols()).matrix();
  VectorXd spin(s.u0.size());
  for (Index a = 0; a < X.cols(); ++a) spin.segment<3>(3 * a) = c + omega.cross(Vector3d(x.col(a)));
  EXPECT_LT((force(s, moved(u), spin) - force(s, moved(u))).norm(), 1e-9 * size);
  const MatrixXd R = s.stored_energy->rigid_motions(moved(u));
  const VectorXd rest_of_it = spin - R * R.colPivHouseholderQr().solve(spin);
  EXPECT_LT(rest_of_it.norm(), 1e-12 * spin.norm());
  EXPECT_LT((rotation(*s.stored_energy, moved(rest)) - Q).norm(), 1e-13);
  EXPECT_LT((rotation(*s.stored_energy, moved(u)) - Q * rotation(*s.stored_energy, u)).norm(), 1e-13);
  EXPECT_LT((s.stored_energy->rigid_motions(rest) - s.R).norm(), 1e-11 * s.R.norm());
}

TEST(FiniteStrain, ForcesAndTorquesBalance) {
  for (const Scene& scene : bodies()) {
    if (!scene.bodies[0].supports.empty()) continue;
    const auto model = model_of(scene);
    const System& s = model->system();
    const VectorXd u = deformed(s), f = force(s, u, random_vector(u.size(), 1, 8));
    const MatrixXd R = s.stored_energy->rigid_motions(u);
    EXPECT_LT((R.transpose() * f).norm(), 1e-12 * R.norm() * f.norm());  // rounding
  }
}

TEST(FiniteStrain, RigidMotionsThatSupportsLeave) {
  // Slides on a plane: two translations and a turn about its normal, also where it has turned.
  const Scene scene =
      finite(Box{{0.3, 0.2, 0.4}}, {2, {1, 1, 1}}, {testing::support(Support::Kind::sliding, testing::face("z-min"))});
  const auto model = model_of(scene);
  const System& s = model->system();
  ASSERT_EQ(s.R.cols(), 3);
  EXPECT_LT((s.stored_energy->rigid_motions(s.u0) - s.R).norm(), 1e-12 * s.R.norm());
  const VectorXd u = deformed(s);
  const MatrixXd R = s.stored_energy->rigid_motions(u);
  EXPECT_LT((R.transpose() * force(s, u)).norm(), 1e-12 * R.norm() * force(s, u).norm());
  EXPECT_EQ(rotation(*s.stored_energy, u), Matrix3d::Identity());
}

TEST(FiniteStrain, InversionIsSaidNotComputed) {
  const auto model = model_of(finite(Box{{0.3, 0.2, 0.4}}, {2, {1, 2, 2}}));
  const System& s = model->system();
  const VectorXd flipped = -2 * model->places();
  VectorXd f;
  SparseMatrix A = 0 * s.K;
  EXPECT_EQ(s.stored_energy->energy(flipped), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(s.stored_energy->force(flipped, s.v0, f));
  EXPECT_FALSE(s.stored_energy->add_tangent(flipped, 1, 1, A));
}

TEST(FiniteStrain, RefusesWhatItIsNotFor) {
  Scene wood = finite(Box{{0.3, 0.2, 0.4}}, {1, {1, 1, 1}});
  wood.bodies[0].material.orthotropy = Orthotropy{{1e4, 1e4, 1e4}, {0.3, 0.3, 0.3}, {4e3, 4e3, 4e3}};
  EXPECT_THROW(model_of(wood), std::invalid_argument);
  Scene ratios = finite(Box{{0.3, 0.2, 0.4}}, {1, {1, 1, 1}});
  ratios.bodies[0].damping_ratios = {0.1};
  EXPECT_THROW(full_model(ratios, ratios.bodies[0], ratios.bodies[0].resolution,
                          [](const System&, const Body&, int) { return Modes{}; }),
               std::invalid_argument);
}

}  // namespace
}  // namespace mb
