#include "mechanics/contact/facets.h"

#include <gtest/gtest.h>

#include <random>

#include "mechanics/contact/contact_forces.h"

namespace mb {
namespace {

// n x n patches of degree 2 over [-1, 1]^2, a bowl turned upside down: z = -(x^2 + y^2 / 2) / 4. Nodes are shared.
Facets dome(int n) {
  const int across = 2 * n + 1;
  Facets f{Vector3d(0, 0.5, 1), Eigen::MatrixXi(9, n * n), Matrix3Xd(3, across * across), {}};
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < across; ++i) {
      const double x = -1 + 1.0 * i / n, y = -1 + 1.0 * j / n;
      f.X.col(i + across * j) << x, y, -(x * x + y * y / 2) / 4;
    }
  for (int q = 0; q < n; ++q)
    for (int p = 0; p < n; ++p)
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) f.nodes(a + 3 * b, p + n * q) = 2 * p + a + across * (2 * q + b);
  f.U.resize(3 * across * across, 3 * across * across);
  f.U.setIdentity();
  return f;
}

double brute_distance(const Vector3d& x) {
  double least = 1e9;
  for (int i = -400; i <= 400; ++i)
    for (int j = -400; j <= 400; ++j) {
      const double a = i / 400.0, b = j / 400.0;
      least = std::min(least, (x - Vector3d(a, b, -(a * a + b * b / 2) / 4)).norm());
    }
  return least;
}

TEST(Facets, FootIsTheNearestPoint) {
  const Facets f = dome(4);  // quadratics are in the space: the surface is exact
  FootSearch search(f, 40);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-0.8, 0.8);
  for (Index i = 0; i < 40; ++i) {
    const Vector3d x{any(random), any(random), -0.3 * any(random) - 0.1};  // braces: in this order everywhere
    const auto near = search(i, x, 10);
    ASSERT_NE(near.foot, nullptr);
    // The nearest point of the grid is off along the surface by half a diagonal of a cell at most, s.
    const double gap = std::abs(near.gap), s = std::sqrt(2 * (1 + 0.5 * 0.5)) / 800;
    EXPECT_GE(brute_distance(x), gap - 1e-12);
    EXPECT_LE(brute_distance(x), std::hypot(gap, s) + 1e-12);
    const double side = x.z() + (x.x() * x.x() + x.y() * x.y() / 2) / 4;
    EXPECT_EQ(near.gap > 0, side > 0) << x.transpose();
    EXPECT_NEAR(near.foot->N.sum(), 1, 1e-13);  // rounding
  }
}

TEST(Facets, NormalIsTheGradientOfTheGap) {
  const Facets f = dome(3);
  FootSearch search(f, 1);
  const Vector3d x(0.21, -0.33, 0.07);
  const auto near = search(0, x, 10);
  const Vector3d normal = near.foot->normal;
  constexpr double e = 1e-6;
  for (int k = 0; k < 3; ++k) {
    const double up = search(0, x + e * Vector3d::Unit(k), 10).gap, down = search(0, x - e * Vector3d::Unit(k), 10).gap;
    EXPECT_NEAR((up - down) / (2 * e), normal[k], 1e-8);  // differences of second order
  }
}

// What is skipped is never nearer than said, and what is found is what a search without memory finds.
TEST(Facets, MemoryMissesNothing) {
  const Facets f = dome(5);
  FootSearch search(f, 1);
  std::mt19937 random(2);
  std::normal_distribution<double> step(0, 0.02);
  Vector3d x(0, 0, 0.1);
  VectorXd u = VectorXd::Zero(3 * f.X.cols());
  int n_skipped = 0;
  for (int k = 0; k < 400; ++k) {
    x += Vector3d(step(random), step(random), step(random) - 0.05 * x.z());
    x = x.cwiseMax(-0.7).cwiseMin(0.7);
    for (double& value : u) value += 0.02 * step(random);
    search.move_to(u);
    FootSearch fresh(f, 1);
    fresh.move_to(u);
    const auto now = search(0, x), sought = fresh(0, x, 10);
    if (now.foot) {
      EXPECT_NEAR(now.gap, sought.gap, 1e-9);  // of one foot, reached from elsewhere
    } else {
      EXPECT_LE(now.gap, sought.gap + 1e-12);
      EXPECT_GE(sought.gap, 0);
      ++n_skipped;
    }
  }
  EXPECT_GT(n_skipped, 20);
}

TEST(Facets, WrongSizesThrow) {
  Facets f = dome(1);
  f.nodes(0, 0) = 99;
  EXPECT_THROW(FootSearch(f, 1), std::invalid_argument);
}

// Five points that press into a dome, all of both free to move.
struct Pressing {
  std::vector<Contact> contacts;
  VectorXd u, v;
  explicit Pressing(double friction) {
    Facets f = dome(2);
    const Index k = 3 * f.X.cols(), m = 5, n = 3 * m + k;
    SparseMatrix of_points(3 * m, n), of_nodes(k, n);
    for (Index i = 0; i < 3 * m; ++i) of_points.insert(i, i) = 1;
    for (Index i = 0; i < k; ++i) of_nodes.insert(i, 3 * m + i) = 1;
    f.U = of_nodes;
    Matrix3Xd X(3, m);
    for (Index i = 0; i < m; ++i) {
      const double x = -0.5 + 0.23 * static_cast<double>(i), y = 0.4 - 0.17 * static_cast<double>(i);
      X.col(i) << x, y, -(x * x + y * y / 2) / 4 - 1e-4 * static_cast<double>(i + 1);
    }
    Contact contact{{X, VectorXd::LinSpaced(m, 1e-3, 2e-3), of_points}, {}, {1e4, 0.3, {}}, {1, 1}};
    if (friction > 0) contact.law.friction = {friction, 0.1};
    contact.partner = std::make_shared<const Facets>(f);
    contacts.push_back(contact);
    u = 1e-5 * VectorXd::Random(n), v = VectorXd::Random(n);
  }
};

TEST(ContactOfTwo, ForcesSumToZeroAndTorquesCancel) {
  Pressing p(0);
  const ContactForces forces(p.contacts);
  VectorXd f;
  forces(forces.gather(p.u), forces.gather(p.v), f);
  VectorXd all = VectorXd::Zero(p.u.size());
  forces.add(f, all);
  const Matrix3Xd X = p.contacts[0].points.X, nodes = p.contacts[0].partner->X;
  Matrix3Xd x(3, all.size() / 3);
  x << X, nodes;
  x += p.u.reshaped(3, x.cols()).matrix();
  const auto at = all.reshaped(3, x.cols());
  Vector3d torque = Vector3d::Zero();
  double size = 0;
  for (Index i = 0; i < x.cols(); ++i) {
    torque += Vector3d(x.col(i)).cross(Vector3d(at.col(i)));
    size += Vector3d(x.col(i)).cross(Vector3d(at.col(i))).norm();
  }
  ASSERT_GT(size, 0);
  EXPECT_LT(at.matrix().rowwise().sum().norm(), 1e-12 * at.norm());  // rounding
  EXPECT_LT(torque.norm(), 1e-12 * size);
}

TEST(ContactOfTwo, PowerIsStoredOrDissipated) {
  for (const double friction : {0.0, 0.4}) {
    const Pressing p(friction);
    const ContactForces forces(p.contacts);
    constexpr double e = 1e-7;
    VectorXd f;
    const ContactSum at = forces(forces.gather(p.u), forces.gather(p.v), f);
    const double power = f.dot(forces.gather(p.v));
    VectorXd g;
    const double later = forces(forces.gather(p.u + e * p.v), forces.gather(p.v), g).stored;
    const double before = forces(forces.gather(p.u - e * p.v), forces.gather(p.v), g).stored;
    EXPECT_NEAR(-power, (later - before) / (2 * e) + at.dissipation, 1e-6 * std::abs(power));  // differences
    EXPECT_GT(at.dissipation, 0);
  }
}

// At rest: rates of neighbouring nodes differ as they never do in a body.
TEST(ContactOfTwo, TangentIsTheDerivativeButForCurvature) {
  for (const double friction : {0.0, 0.4}) {
    Pressing p(friction);
    p.v.setZero();
    const ContactForces forces(p.contacts);
    ContactForces::Tangent tangent;
    VectorXd f, up, down;
    forces(forces.gather(p.u), forces.gather(p.v), f, tangent);
    const VectorXd along = VectorXd::Random(p.u.size());
    constexpr double e = 1e-7;
    forces(forces.gather(p.u + e * along), forces.gather(p.v), up);
    forces(forces.gather(p.u - e * along), forces.gather(p.v), down);
    const VectorXd by_u = (up - down) / (2 * e);
    VectorXd predicted = VectorXd::Zero(f.size());
    predicted(tangent.active) = tangent.by_u * VectorXd(forces.gather(along)(tangent.active));
    EXPECT_LT((predicted - by_u).norm(),
              0.02 * by_u.norm());  // gap by radius and by width of a patch: 5e-4 by 1/2, random slopes of some 4
    constexpr double e_v = 1e-4;
    forces(forces.gather(p.u), forces.gather(p.v + e_v * along), up);
    forces(forces.gather(p.u), forces.gather(p.v - e_v * along), down);
    predicted(tangent.active) = tangent.by_v * VectorXd(forces.gather(along)(tangent.active));
    EXPECT_LT((predicted - (up - down) / (2 * e_v)).norm(), 1e-5 * predicted.norm());  // e_v by slip speed, squared
  }
}

}  // namespace
}  // namespace mb
