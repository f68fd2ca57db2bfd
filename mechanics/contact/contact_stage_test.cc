#include "mechanics/contact/contact_stage.h"

#include <gtest/gtest.h>

#include <random>

#include "mechanics/system/shifted.h"

namespace mb {
namespace {

// A block of springs: a chain of n_nodes points in 3-D, each tied to its neighbours and to the ground by a little.
struct Chain {
  explicit Chain(Index n_nodes) {
    const Index n = 3 * n_nodes;
    MatrixXd K = 10 * MatrixXd::Identity(n, n);
    for (Index a = 0; a + 1 < n_nodes; ++a)
      for (Index i = 0; i < 3; ++i) {
        const Index p = 3 * a + i, q = p + 3;
        const double k = i == 2 ? 4e4 : 1e4;
        K(p, p) += k, K(q, q) += k, K(p, q) -= k, K(q, p) -= k;
      }
    system.K = K.sparseView();
    system.M = MatrixXd(0.02 * MatrixXd::Identity(n, n)).sparseView();
    system.damping = {3, 1e-4};
    system.R = MatrixXd(n, 0);
    system.F = MatrixXd(n, 0);
    system.u0 = system.v0 = VectorXd::Zero(n);
    system.modal_damping.W = MatrixXd(n, 0);
  }
  System system;
};

// Points between neighbouring nodes of the chain, 1 mm above z = 0 at rest.
ContactPoints points(Index n_nodes) {
  const Index m = n_nodes - 1;
  std::vector<Eigen::Triplet<double>> entries;
  ContactPoints p{Matrix3Xd(3, m), VectorXd::Constant(m, 1e-3), SparseMatrix(3 * m, 3 * n_nodes)};
  for (Index a = 0; a < m; ++a) {
    p.X.col(a) << 0.01 * static_cast<double>(a), 0, 1e-3;
    for (Index i = 0; i < 3; ++i) {
      entries.emplace_back(3 * a + i, 3 * a + i, 0.4);
      entries.emplace_back(3 * a + i, 3 * a + 3 + i, 0.6);
    }
  }
  p.U.setFromTriplets(entries.begin(), entries.end());
  return p;
}

RigidSurface floor() { return {HalfSpace{}, 0, {}}; }
RigidSurface tilted() {
  return {HalfSpace{}, 0, {Vector3d(0, 0, 0), Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Vector3d::UnitY()))}};
}

// |A v - b - gamma f(a + gamma v, v)| over |b|.
double residual(const System& s, const ContactForces& forces, const VectorXd& a, double gamma, const VectorXd& b,
                const VectorXd& v) {
  VectorXd f, all = VectorXd::Zero(v.size());
  forces(forces.gather(a + gamma * v), forces.gather(v), f);
  forces.add(f, all);
  const VectorXd Av = s.M * v + gamma * apply_damping(s, v) + gamma * gamma * (s.K * v);
  return (Av - b - gamma * all).norm() / b.norm();
}

class ContactStages : public ::testing::TestWithParam<Contact> {};

TEST_P(ContactStages, SolveTheWholeEquation) {
  const Index n_nodes = 12, n = 3 * n_nodes;
  const Chain chain(n_nodes);
  std::vector<Contact> contacts{GetParam()};
  contacts[0].points = points(n_nodes);
  const ContactForces forces(contacts);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const double gamma : {1e-5, 1e-3, 1e-2}) {
    const Shifted A(chain.system, gamma);
    ContactStage stage(forces, n);
    for (int trial = 0; trial < 20; ++trial) {
      VectorXd a(n), b(n), v(n);
      for (Index i = 0; i < n; ++i)
        a[i] = 1e-3 * normal(random) - (i % 3 == 2 ? 2e-3 : 0), b[i] = 0.02 * normal(random);
      A.solve(b, v);
      const auto outcome = stage.solve(A, a, gamma, 1e-12, v);
      EXPECT_TRUE(outcome.converged);
      EXPECT_LE(outcome.iterations, 25);
      EXPECT_LT(residual(chain.system, forces, a, gamma, b, v), 1e-9);  // 1e-12 m/s beside some m/s, A's condition 1e3
    }
  }
}
INSTANTIATE_TEST_SUITE_P(
    Laws, ContactStages,
    ::testing::Values(Contact{{}, floor(), {1e9, 0, {}}, {1, 1}}, Contact{{}, tilted(), {1e9, 0.5, {}}, {1, 1}},
                      Contact{{}, tilted(), {1e8, 0, Friction{0.5, 0.01}}, {1, 1}},
                      Contact{{}, {Sphere{1}, 0, {Vector3d(0.05, 0, -1), {1, 0, 0, 0}}}, {1e8, 0.5, {}}, {1, 1}}));

// What lifts A out of a stiff floor presses B, exactly on it, which the tangent at the start knows nothing of; B throws
// up C, far above and light, whose residual is the largest and grows however short the step is: no halving helps, and
// the shortest is taken. With the tangent of where that ended the next step is exact: the law is linear.
TEST(ContactStage, GoesOnFromWhereTheLineSearchGaveUp) {
  Chain chain(3);
  const std::vector<Index> z{2, 5, 8};
  MatrixXd M = 0.02 * MatrixXd::Identity(9, 9);
  M(z, z) = 0.02 * (Eigen::Matrix3d() << 1, -2, -2, -2, 9, -2, -2, -2, 20).finished().inverse();
  chain.system.M = M.sparseView();
  chain.system.K = SparseMatrix(9, 9);
  chain.system.damping = {0, 0};
  ContactPoints nodes{Matrix3Xd::Zero(3, 3), VectorXd::Ones(3), SparseMatrix(9, 9)};
  nodes.U.setIdentity();
  const std::vector<Contact> contacts{{nodes, floor(), {1e8, 0, {}}, {1, 1}}};
  const ContactForces forces(contacts);
  ContactStage stage(forces, 9);
  const double gamma = 1e-3;
  const Shifted A(chain.system, gamma);
  VectorXd a = VectorXd::Zero(9), v = VectorXd::Zero(9);
  a[2] = -1e-3;
  a[8] = 1;
  const auto outcome = stage.solve(A, a, gamma, 1e-9, v);
  EXPECT_TRUE(outcome.converged);
  EXPECT_LE(outcome.iterations, 3);  // one more for rounding: the first residual is 1e10 times the tolerance
  const VectorXd u = a + gamma * v;
  EXPECT_LT(std::max(std::abs(u[2]), std::abs(u[5])), 1e-6);  // on the floor, which gives way by 20 N / 1e8 Pa/m
}

TEST(ContactStage, WithoutTouchLeavesTheLinearSolution) {
  const Chain chain(4);
  const std::vector<Contact> contacts{{points(4), floor(), {1e9, 0, {}}, {1, 1}}};
  const ContactForces forces(contacts);
  ContactStage stage(forces, 12);
  const Shifted A(chain.system, 1e-3);
  const VectorXd a = VectorXd::Constant(12, 1.0), before = VectorXd::Constant(12, 0.3);
  VectorXd v = before;
  const auto outcome = stage.solve(A, a, 1e-3, 1e-12, v);
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 0);
  EXPECT_EQ(outcome.solves, 0);
  EXPECT_EQ(v, before);
}

TEST(ContactStage, KeepsColumnsUntilTold) {
  const Chain chain(6);
  const std::vector<Contact> contacts{{points(6), floor(), {1e9, 0, {}}, {1, 1}}};
  const ContactForces forces(contacts);
  EXPECT_EQ(forces.dofs().size(), 6u);  // normal components alone
  ContactStage stage(forces, 18);
  const Shifted A(chain.system, 1e-3);
  const VectorXd a = VectorXd::Constant(18, -2e-3);
  VectorXd v = VectorXd::Zero(18);
  EXPECT_GT(stage.solve(A, a, 1e-3, 1e-12, v).solves, 0);
  v.setZero();
  EXPECT_EQ(stage.solve(A, a, 1e-3, 1e-12, v).solves, 0);
  stage.forget();
  v.setZero();
  EXPECT_GT(stage.solve(A, a, 1e-3, 1e-12, v).solves, 0);
}

TEST(ContactStage, NotANumberIsNoConvergence) {
  const Chain chain(4);
  const std::vector<Contact> contacts{{points(4), floor(), {1e9, 0, {}}, {1, 1}}};
  const ContactForces forces(contacts);
  ContactStage stage(forces, 12);
  const Shifted A(chain.system, 1e-3);
  VectorXd v = VectorXd::Constant(12, std::nan(""));
  EXPECT_FALSE(stage.solve(A, VectorXd::Zero(12), 1e-3, 1e-12, v).converged);
}

TEST(ContactForces, SizesMustFit) {
  std::vector<Contact> contacts{{points(4), floor(), {1e9, 0, {}}, {1, 1}}};
  contacts[0].points.w.resize(2);
  EXPECT_THROW(ContactForces{contacts}, std::invalid_argument);
}

// What goes in is kept in the layer or lost: power of the forces = - d(stored)/dt - dissipation.
TEST(ContactForces, PowerIsStoredOrDissipated) {
  for (const PenaltyLaw& law :
       {PenaltyLaw{1e8, 0, {}}, PenaltyLaw{1e8, 0.4, {}}, PenaltyLaw{1e8, 0.4, Friction{0.3, 0.1}}}) {
    const std::vector<Contact> contacts{{points(5), tilted(), law, {1, 1}}};
    const ContactForces forces(contacts);
    const auto n = static_cast<Index>(forces.dofs().size());
    const VectorXd u = VectorXd::LinSpaced(n, -3e-3, -1e-3), v = VectorXd::LinSpaced(n, 0.9, -1.2);
    VectorXd f;
    const ContactSum at = forces(u, v, f);
    const double h = 1e-7, change = (forces(u + h * v, v, f).stored - forces(u - h * v, v, f).stored) / (2 * h);
    forces(u, v, f);
    EXPECT_LT(at.least_gap, 0);
    EXPECT_GE(at.dissipation, 0);
    EXPECT_NEAR(f.dot(v), -change - at.dissipation, 1e-6 * (std::abs(change) + at.dissipation));
  }
}

}  // namespace
}  // namespace mb
