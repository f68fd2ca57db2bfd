#include "mechanics/contact/finite_stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "mechanics/contact/contact_steppers.h"
#include "mechanics/geometry/pose.h"
#include "mechanics/system/newmark.h"

namespace mb {
namespace {

using Eigen::Matrix3d;
constexpr double k = 4e3, length = 0.03, mass = 0.02;  // [N/m], [m], [kg] of a node

// Points along x, more than two in a zigzag, neighbours tied by springs that turn freely:  W = k/2 sum (d - l)^2,  d =
// |x_b - x_a|, with dashpots along them. It inverts below a tenth of l.
class Springs final : public StoredEnergy {
 public:
  Springs(Index n_nodes, double dashpot) : X_(3 * n_nodes), dashpot_(dashpot) {
    const double bend = n_nodes > 2 ? 0.2 : 0;  // [rad] off a line, about which nothing would turn
    for (Index a = 0; a < n_nodes; ++a)
      X_.segment<3>(3 * a) << length * std::cos(bend) * static_cast<double>(a),
          length * std::sin(bend) * static_cast<double>(a % 2), 0;
  }
  double energy(const VectorXd& u) const override {
    double W = 0;
    const bool whole = each(u, [&](Index, const Vector3d& r) { W += k / 2 * std::pow(r.norm() - length, 2); });
    return whole ? W : std::numeric_limits<double>::infinity();
  }
  bool force(const VectorXd& u, const VectorXd& v, VectorXd& f) const override {
    f.setZero(u.size());
    return each(u, [&](Index a, const Vector3d& r) {
      const Vector3d e = r.normalized(), rate = v.segment<3>(a + 3) - v.segment<3>(a);
      const Vector3d pull = (k * (r.norm() - length) + dashpot_ * e.dot(rate)) * e;
      f.segment<3>(a) -= pull, f.segment<3>(a + 3) += pull;
    });
  }
  bool add_tangent(const VectorXd& u, double by_u, double by_v, SparseMatrix& A) const override {
    return each(u, [&](Index a, const Vector3d& r) {
      const Matrix3d along = r.normalized() * r.normalized().transpose(), across = Matrix3d::Identity() - along;
      const Matrix3d B = by_u * k * (along + (1 - length / r.norm()) * across) + by_v * dashpot_ * along;
      for (Index i = 0; i < 3; ++i)
        for (Index j = 0; j < 3; ++j)
          for (const auto& [p, q, sign] : {std::tuple{0, 0, 1}, {3, 3, 1}, {0, 3, -1}, {3, 0, -1}})
            A.coeffRef(a + p + i, a + q + j) += sign * B(i, j);
    });
  }
  std::vector<Turn> turns(const VectorXd& u) const override {  // from end to end, which is as good as any
    const Vector3d r = X_.tail<3>() + u.tail<3>() - X_.head<3>() - u.head<3>();
    const auto Q = shortest_turn(X_.tail<3>() - X_.head<3>(), r);
    return {{0, u.size(), Q.toRotationMatrix()}};
  }
  MatrixXd rigid_motions(const VectorXd& u) const override {
    MatrixXd R(u.size(), 6);
    for (Index i = 0; i < u.size(); i += 3)
      for (Index j = 0; j < 3; ++j) {
        const Vector3d x = X_.segment<3>(i) + u.segment<3>(i), e = Vector3d::Unit(j);
        R.col(j).segment<3>(i) = e, R.col(3 + j).segment<3>(i) = e.cross(x);
      }
    return R;
  }
  const VectorXd& X() const { return X_; }

 private:
  template <class Visit>
  bool each(const VectorXd& u, Visit&& visit) const {
    for (Index a = 0; a + 3 < u.size(); a += 3) {
      const Vector3d r = X_.segment<3>(a + 3) + u.segment<3>(a + 3) - X_.segment<3>(a) - u.segment<3>(a);
      if (!(r.norm() > length / 10)) return false;
      visit(a, r);
    }
    return true;
  }
  VectorXd X_;
  double dashpot_;
};

System chain(Index n_nodes, double alpha = 0, double dashpot = 0) {
  const Index n = 3 * n_nodes;
  System s;
  s.M = MatrixXd(mass * MatrixXd::Identity(n, n)).sparseView();
  s.stored_energy = std::make_shared<Springs>(n_nodes, dashpot);
  std::vector<Eigen::Triplet<double>> pattern;
  for (Index a = 0; a < n_nodes; ++a)
    for (Index b = std::max<Index>(0, a - 1); b <= std::min(n_nodes - 1, a + 1); ++b)
      for (Index i = 0; i < 9; ++i) pattern.emplace_back(3 * a + i % 3, 3 * b + i / 3, 0.0);
  s.K.resize(n, n);
  s.K.setFromTriplets(pattern.begin(), pattern.end());
  s.damping = {alpha, 0};
  s.R = MatrixXd(n, 0);
  s.F = MatrixXd(n, 0);
  s.u0 = s.v0 = VectorXd::Zero(n);
  s.modal_damping.W = MatrixXd(n, 0);
  return s;
}

std::vector<Contact> on_plane(Index n_nodes, double gap) {
  ContactPoints nodes{Matrix3Xd::Zero(3, n_nodes), VectorXd::Constant(n_nodes, 1e-3),
                      SparseMatrix(3 * n_nodes, 3 * n_nodes)};
  for (Index a = 0; a < n_nodes; ++a) nodes.X(0, a) = length * static_cast<double>(a);
  nodes.U.setIdentity();
  const RigidSurface plane{
      HalfSpace{}, 0, {{0, 0, -gap}, Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Vector3d::UnitY()))}};
  return {{nodes, plane, {1e9, 0.3, Friction{0.4, 0.05}}, {1e-3, 1}}};
}

// |M v - b + gamma r - gamma f_C| over |b|, by the definitions alone.
double residual(const System& s, const ContactForces* contact, const VectorXd& a, double gamma, const VectorXd& b,
                const VectorXd& v) {
  const VectorXd u = a + gamma * v;
  VectorXd f, f_C, r = s.M * v - b;
  EXPECT_TRUE(s.stored_energy->force(u, v, f));
  const MatrixXd R = s.stored_energy->rigid_motions(u);
  const VectorXd relative = v - R * (R.transpose() * R).ldlt().solve(R.transpose() * v);  // M = m 1
  r += gamma * (f + s.damping.alpha * mass * relative);
  if (contact) {
    (*contact)(contact->gather(u), contact->gather(v), f_C);
    VectorXd all = VectorXd::Zero(v.size());
    contact->add(f_C, all);
    r -= gamma * all;
  }
  return r.norm() / b.norm();
}

TEST(FiniteStage, SolvesTheWholeEquation) {
  const Index n_nodes = 8, n = 3 * n_nodes;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const bool touches : {false, true})
    for (const double alpha : {0.0, 30.0}) {
      const System s = chain(n_nodes, alpha, 0.5);
      const std::vector<Contact> contacts = on_plane(n_nodes, 1e-3);
      const ContactForces forces(contacts);
      const FiniteForce force(s);
      FiniteStage stage(s, force, touches ? &forces : nullptr);
      for (const double gamma : {1e-4, 5e-4})
        for (int trial = 0; trial < 10; ++trial) {
          VectorXd a(n), b(n), v(n);
          for (Index i = 0; i < n; ++i) a[i] = 2e-3 * normal(random), b[i] = mass * normal(random), v[i] = b[i] / mass;
          const VectorXd guess = v;
          const auto outcome = stage.solve(0, b, a, gamma, 1e-11, 1e-12, v);
          EXPECT_TRUE(outcome.converged);
          EXPECT_LT(residual(s, touches ? &forces : nullptr, a, gamma, b, v), 1e-9);  // 1e-11 m/s, condition 100
          EXPECT_GT((v - guess).norm(), 1e-3);
        }
    }
}

// The same state turned: columns and factor turn with it, none is made anew.
TEST(FiniteStage, TurnsWithTheBody) {
  const Index n_nodes = 6, n = 3 * n_nodes;
  const System s = chain(n_nodes);
  const FiniteForce force(s);
  FiniteStage stage(s, force, nullptr);
  const Springs& springs = dynamic_cast<const Springs&>(*s.stored_energy);
  const VectorXd stretched = 0.02 * springs.X(), b = mass * VectorXd::LinSpaced(n, -1, 1);
  VectorXd v = VectorXd::Zero(n);
  ASSERT_TRUE(stage.solve(0, b, stretched, 1e-3, 1e-10, 1e-12, v).converged);
  const Matrix3d Q = Eigen::AngleAxisd(1.3, Vector3d::UnitZ()).toRotationMatrix();
  const auto turn = [&](const VectorXd& x) { return VectorXd((Q * x.reshaped(3, n_nodes).matrix()).reshaped()); };
  VectorXd v_turned = VectorXd::Zero(n);
  const auto outcome =
      stage.solve(0, turn(b), turn(springs.X() + stretched) - springs.X(), 1e-3, 1e-10, 1e-12, v_turned);
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.factorisations, 0);
  EXPECT_LT((v_turned - turn(v)).norm(), 1e-9 * v.norm());
}

// Pressed together it would buckle: M + gamma^2 K_T is not positive definite, and the tangent at rest must do.
TEST(FiniteStage, GoesOnWhereTheTangentIsIndefinite) {
  const Index n = 6;
  const System s = chain(2);
  const FiniteForce force(s);
  const VectorXd pressed = Eigen::Map<const VectorXd>(std::vector<double>{0.006, 0, 0, -0.006, 1e-4, 0}.data(), n);
  const double gamma = 2e-3;  // gamma^2 k (l/d - 1) = 0.011 N s^2/m, twice: more than m
  VectorXd v = VectorXd::Zero(n), b = VectorXd::Zero(n);
  b[1] = mass;
  FiniteStage stage(s, force, nullptr);
  const auto outcome = stage.solve(0, b, pressed, gamma, 1e-9, 1e-12, v);
  EXPECT_GE(outcome.factorisations, 2);
  ASSERT_TRUE(outcome.converged);
  EXPECT_LT(residual(s, nullptr, pressed, gamma, b, v), 1e-6);
  EXPECT_TRUE(v.allFinite());
}

TEST(FiniteStage, InversionIsSaid) {
  const System s = chain(2);
  const FiniteForce force(s);
  FiniteStage stage(s, force, nullptr);
  VectorXd v = VectorXd::Zero(6), a = VectorXd::Zero(6);
  a[0] = length;  // one node on the other
  const auto outcome = stage.solve(0, VectorXd::Ones(6), a, 1e-3, 1e-9, 1e-12, v);
  EXPECT_TRUE(outcome.inverted);
  EXPECT_FALSE(outcome.converged);
  System linear = s;
  linear.stored_energy = nullptr;
  EXPECT_THROW(FiniteForce{linear}, std::invalid_argument);
}

// Two masses that circle each other: k (d - l) = m omega^2 d/2, for ever; the tenth turn at order 2.
TEST(NewmarkFinite, CirclesAtOrderTwo) {
  const double omega = 150, d = k * length / (k - mass * omega * omega / 2);
  System s = chain(2);
  s.u0 << -(d - length) / 2, 0, 0, (d - length) / 2, 0, 0;
  s.v0 << 0, -omega * d / 2, 0, 0, omega * d / 2, 0;
  const double T = 20 * pi / omega;
  const auto error = [&](int n) {
    const States states = newmark(s, T / n)->run(VectorXd{{T}});
    EXPECT_EQ(states.status, Status::ok);
    EXPECT_LE(states.work.factorisations, 4);
    return (states.u.col(0) - s.u0).norm() / d;
  };
  const double coarse = error(4000), fine = error(8000);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  EXPECT_LT(fine, 2.5e-4);  // 2.28e-4 is the steps' own; stages solved to 1e-9 of a foretold error left ten times that
}

TEST(NewmarkFinite, RunsRepeatToTheLastDigit) {
  System s = chain(4, 3, 0.2);
  s.v0.setLinSpaced(-0.1, 0.2);
  const std::vector<Contact> contacts = on_plane(4, 1e-3);
  const auto stepper = newmark(s, contacts, 1e-4);
  const VectorXd times = VectorXd::LinSpaced(5, 0, 0.02);
  const States first = stepper->run(times), second = stepper->run(times);
  EXPECT_EQ(first.status, Status::ok);
  EXPECT_EQ(first.u, second.u);
  EXPECT_EQ(first.v, second.v);
}

}  // namespace
}  // namespace mb
