#include "mechanics/system/joined.h"

#include <gtest/gtest.h>

#include "mechanics/system/newmark.h"
#include "mechanics/system/small_test_systems.h"
#include "mechanics/system/stored_energy.h"
#include "mechanics/system/unbalanced_force.h"

namespace mb {
namespace {

SparseMatrix sparse(const MatrixXd& A) { return A.sparseView(); }

// Three masses in a row, tied by two springs; nothing holds them.
System row(double mass, double stiffness, const Rayleigh& damping) {
  System s;
  MatrixXd K(3, 3);
  K << 1, -1, 0, -1, 2, -1, 0, -1, 1;
  s.M = s.lumped_mass = sparse(mass * MatrixXd::Identity(3, 3));
  s.K = sparse(stiffness * K);
  s.damping = damping;
  s.modal_damping.W = MatrixXd(3, 0);
  s.R = MatrixXd::Constant(3, 1, 1 / std::sqrt(3 * mass));
  s.F = VectorXd::Unit(3, 2);
  s.s = {Step{stiffness / 100}};
  s.u0 = VectorXd::LinSpaced(3, 0, 0.01);
  s.v0 = VectorXd::LinSpaced(3, 1, -0.5);
  return s;
}

VectorXd stacked(const VectorXd& a, const VectorXd& b) {
  VectorXd both(a.size() + b.size());
  both << a, b;
  return both;
}

TEST(Joined, EachMovesAsAlone) {
  for (const Rayleigh& second : {Rayleigh{3, 1e-3}, Rayleigh{40, 5e-3}}) {  // as the first, and not
    const System a = row(0.3, 800, {3, 1e-3}), b = row(1.1, 5e3, second), both = joined({a, b});
    const VectorXd v = VectorXd::LinSpaced(6, -1, 3);
    EXPECT_LT((apply_damping(both, v) - stacked(apply_damping(a, v.head(3)), apply_damping(b, v.tail(3)))).norm(),
              1e-12 * apply_damping(both, v).norm());
    const VectorXd t = VectorXd::LinSpaced(6, 0, 0.5);
    const States together = newmark(both, 1e-3)->run(t), first = newmark(a, 1e-3)->run(t),
                 other = newmark(b, 1e-3)->run(t);
    EXPECT_LT((together.u.topRows(3) - first.u).norm(), 1e-10 * first.u.norm());
    EXPECT_LT((together.u.bottomRows(3) - other.u).norm(), 1e-10 * other.u.norm());
    EXPECT_EQ(both.R.cols(), 2);
    EXPECT_EQ(both.F.cols(), 2);
  }
}

TEST(Joined, ForcesOnVelocitiesAreThoseOfEach) {
  const System a = row(0.3, 800, {3, 1e-3}), b = row(1.1, 5e3, {0, 0}), both = joined({a, b});
  using Mass = UnbalancedForce::Mass;
  const VectorXd u = VectorXd::LinSpaced(6, 0.1, -0.3), v = VectorXd::LinSpaced(6, -1, 3);
  VectorXd all, first, other;
  UnbalancedForce(both, Mass::consistent)(0.1, u, v, all);
  UnbalancedForce(a, Mass::consistent)(0.1, u.head(3), v.head(3), first);
  UnbalancedForce(b, Mass::consistent)(0.1, u.tail(3), v.tail(3), other);
  EXPECT_LT((all - stacked(first, other)).norm(), 1e-12 * all.norm());
}

// W = k |u|^4 / 4 + u^T K u / 2 of a row: enough to tell the parts apart.
class Hardening final : public StoredEnergy {
 public:
  Hardening(const System& s, double k) : K_(s.K), k_(k) {}
  double energy(const VectorXd& u) const override { return k_ * std::pow(u.norm(), 4) / 4 + 0.5 * u.dot(K_ * u); }
  bool force(const VectorXd& u, const VectorXd& v, VectorXd& f) const override {
    f = k_ * u.squaredNorm() * u + K_ * (u + beta * v);
    return u.norm() < 1;
  }
  bool add_tangent(const VectorXd& u, double by_u, double by_v, SparseMatrix& A) const override {
    A += (by_u + beta * by_v) * K_;
    for (Index i = 0; i < u.size(); ++i) A.coeffRef(i, i) += by_u * k_ * u.squaredNorm();
    return u.norm() < 1;
  }
  std::vector<Turn> turns(const VectorXd& u) const override { return {{0, u.size(), Eigen::Matrix3d::Identity()}}; }
  MatrixXd rigid_motions(const VectorXd& u) const override { return MatrixXd::Ones(u.size(), 1); }

 private:
  static constexpr double beta = 0.01;
  SparseMatrix K_;
  double k_;
};

TEST(JoinedEnergy, PartsOfItAreEachOthersNeighbours) {
  System a = row(0.3, 800, {0, 1e-3}), b = row(1.1, 5e3, {0, 2e-3});
  b.stored_energy = std::make_shared<Hardening>(b, 1e5);
  const System both = joined({a, b});
  ASSERT_TRUE(both.stored_energy);
  const StoredEnergy& W = *both.stored_energy;
  const VectorXd u = VectorXd::LinSpaced(6, 0.1, -0.3), v = VectorXd::LinSpaced(6, -1, 3);
  const VectorXd u_a = u.head(3), u_b = u.tail(3), v_a = v.head(3), v_b = v.tail(3);
  EXPECT_NEAR(W.energy(u), strain_energy(a, u_a) + strain_energy(b, u_b), 1e-13 * W.energy(u));
  VectorXd f, f_b;
  ASSERT_TRUE(W.force(u, v, f));
  b.stored_energy->force(u_b, v_b, f_b);
  EXPECT_LT((f - stacked(a.K * (u_a + 1e-3 * v_a), f_b)).norm(), 1e-13 * f.norm());
  SparseMatrix A = both.M, A_b = b.K * 0.0;
  A = both.K * 0.0;
  ASSERT_TRUE(W.add_tangent(u, 0.5, 0.25, A));
  b.stored_energy->add_tangent(u_b, 0.5, 0.25, A_b);
  MatrixXd expected = MatrixXd::Zero(6, 6);
  expected.topLeftCorner(3, 3) = (0.5 + 1e-3 * 0.25) * a.K;
  expected.bottomRightCorner(3, 3) = A_b;
  EXPECT_LT((MatrixXd(A) - expected).norm(), 1e-13 * expected.norm());
  ASSERT_EQ(W.turns(u).size(), 1);  // linear bodies do not turn
  EXPECT_EQ(W.turns(u)[0].first, 3);
  EXPECT_EQ(W.rigid_motions(u).cols(), 2);
  EXPECT_FALSE(W.force(4 * u, v, f));
  EXPECT_FALSE(W.add_tangent(4 * u, 1, 1, A));
}

TEST(Joined, WhatCannotBeJoinedIsRefused) {
  System a = row(0.3, 800, {3, 1e-3}), b = row(1.1, 5e3, {4, 1e-3});
  EXPECT_THROW(joined({}), std::invalid_argument);
  b.stored_energy = std::make_shared<Hardening>(b, 1e5);
  EXPECT_THROW(joined({a, b}), std::invalid_argument);  // alpha differs
  a.u0.resize(2);
  EXPECT_THROW(joined({a, a}), std::invalid_argument);
}

}  // namespace
}  // namespace mb
