#include "mechanics/geometry/superquadric_distance.h"

#include <gtest/gtest.h>

#include <limits>

#include "mechanics/geometry/superquadric.h"
#include "mechanics/geometry/superquadric_test_bodies.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using testing::bodies;
using testing::Random;

double dual_norm(double a, double b, double e) {
  const double p = 2 / e, greater = std::max(a, b), lesser = std::min(a, b);
  if (greater == 0 || p == 1) return greater;
  const double dual = p / (p - 1);
  return greater * std::pow(1 + std::pow(lesser / greater, dual), 1 / dual);
}

// max n . y over the body, the dual norm of the gauge.
double support(const Superquadric& body, const Vector3d& n) {
  const Vector3d m = n.cwiseAbs().cwiseProduct(body.semi_axes);
  return dual_norm(dual_norm(m[0], m[1], body.e2), m[2], body.e1);
}

Vector3d at_gauge(const Superquadric& body, const Vector3d& x, double N) { return N / gauge(body, x) * x; }

double extent_of(const Superquadric& body) { return 2 * body.semi_axes.maxCoeff(); }

// Every half-space about the body bounds the distance from below, every surface point from above: where they meet,
// it is exact. For both to meet at d, the foot x - d n must lie on the surface.
TEST(SuperquadricDistanceVerification, OutsideIsProvenByDuality) {
  Random random(1);
  double worst = 0;
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 100; ++k) {
      const double N =
          k % 3 == 0 ? 1 + std::exp(random.number(-30, 0)) : std::exp(random.number(0, k % 3 == 1 ? 1 : 9));
      const Vector3d x = at_gauge(body, random.vector(), N);
      const Distance d = superquadric_distance(body, x);
      const double tolerance = 2e-14 * (extent_of(body) + x.norm());
      const double below = d.gradient.dot(x) - support(body, d.gradient);
      EXPECT_NEAR(below, d.value, tolerance) << body.e1 << " " << body.e2;
      worst = std::max(2e-14 * std::abs(below - d.value) / tolerance, worst);
      EXPECT_NEAR(gauge(body, x - d.value * d.gradient), 1, tolerance / body.semi_axes.minCoeff());
      EXPECT_NEAR(d.gradient.norm(), 1, 1e-14);
    }
  testing::expect_verified(
      {.quantity = "distance outside 39 superquadrics less that of the plane at its foot, over extent + distance from "
                   "the centre",
       .reference = "property",
       .source = "Duality: no supporting plane is farther than a convex body, and one is as far",
       .uncertainty = "rounding",
       .tolerance = 2e-14,
       .why = "Some tens of roundings of coordinates, of which the support function loses a few to powers."},
      worst);
}

// The least |x - y| on grids of directions, narrowed around the best points to 1e-8, which leaves 1e-16 of the
// distance: shares nothing with the method.
double searched_distance(const Superquadric& body, const Vector3d& x) {
  const Vector3d inside = x.cwiseAbs();
  const auto at = [&](int axis, double s, double t) {
    Vector3d u;
    u[axis] = 1;
    u[(axis + 1) % 3] = std::abs(s);
    u[(axis + 2) % 3] = std::abs(t);
    const Vector3d y = body.semi_axes.cwiseProduct(u);
    return (inside - y / gauge(body, y)).norm();
  };
  constexpr int n = 24;
  struct Candidate {
    double value, s, t;
    int axis;
  };
  std::vector<Candidate> all;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const double s = std::pow(i / double{n}, 2), t = std::pow(j / double{n}, 2);
        all.push_back({at(axis, s, t), s, t, axis});
      }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  double best = all[0].value;
  for (int c = 0; c < 4; ++c) {
    Candidate p = all[c];
    for (double h = 0.05; h > 1e-8; h *= 0.5) {
      const double before = p.value;
      for (int k = 0; k < 16; ++k)
        for (const double r : {1.0, 0.15}) {
          const double s = p.s + r * h * std::cos(0.125 * pi * k), t = p.t + r * h * std::sin(0.125 * pi * k);
          const double value = at(p.axis, s, t);
          if (value < p.value) p = {value, s, t, p.axis};
        }
      if (p.value < before) h *= 1.8;
    }
    best = std::min(best, p.value);
  }
  return best;
}

TEST(SuperquadricDistanceVerification, InsideIsTheLeastFoundBySearching) {
  Random random(2);
  double worst = 0;
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 3; ++k) {
      Vector3d direction = random.vector();
      if (k == 2) direction[1] = 0;
      const Vector3d x = at_gauge(body, direction.cwiseProduct(body.semi_axes), random.number(0.02, 0.999));
      const double found = searched_distance(body, x), d = superquadric_distance_value(body, x);
      EXPECT_LE(-d, found + 1e-14 * extent_of(body)) << body.e1 << " " << body.e2 << " at " << x.transpose();
      EXPECT_GE(-d, found - 1e-8 * extent_of(body)) << body.e1 << " " << body.e2;  // the search ends near it
      worst = std::max(std::abs(d + found) / extent_of(body), worst);
    }
  testing::expect_verified({.quantity = "distance from inside 39 superquadrics to their surface, over the extent",
                            .reference = "second route",
                            .source = "Least distance on grids of directions, narrowed to steps of 1e-8",
                            .uncertainty = "1e-8, one step, where edges make the distance of first order in it",
                            .tolerance = 1e-8,
                            .why = "The search may end a step short of the foot; from the other side, where it cannot "
                                   "err, the bound is 1e-14."},
                           worst);
}

// Every supporting plane is at least as far from a point inside as the surface is, the nearest point's just as far.
TEST(SuperquadricDistance, InsideNoSupportingPlaneIsNearer) {
  Random random(3);
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 20; ++k) {
      const Vector3d x = at_gauge(body, random.vector(), random.number(0.01, 1));
      const Distance d = superquadric_distance(body, x);
      EXPECT_NEAR(d.value, d.gradient.dot(x) - support(body, d.gradient), 1e-13 * extent_of(body));
      for (int l = 0; l < 50; ++l) {
        const Vector3d n = random.vector().normalized();
        EXPECT_LE(n.dot(x) - support(body, n), d.value + 1e-14 * extent_of(body));
      }
    }
}

TEST(SuperquadricDistanceVerification, PolyhedraConesAndSpheres) {
  const double a = 0.3, b = 0.2, c = 0.5;
  const Superquadric octahedron{{a, b, c}, 2, 2}, cone{{a, a, c}, 2, 1}, sphere{{a, a, a}, 1, 1};
  const Vector3d face(1 / a, 1 / b, 1 / c);
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    const Vector3d in = at_gauge(octahedron, random.vector(), random.number(0, 1));
    EXPECT_NEAR(superquadric_distance_value(octahedron, in), (gauge(octahedron, in) - 1) / face.norm(), 1e-14);
    const Vector3d x = random.vector();
    const Distance of_sphere = superquadric_distance(sphere, x);
    EXPECT_NEAR(of_sphere.value, x.norm() - a, 1e-15);
    EXPECT_LT((of_sphere.gradient - x.normalized()).norm(), 1e-14);
    const Vector3d n = x.normalized();
    EXPECT_LT((of_sphere.hessian - (Eigen::Matrix3d::Identity() - n * n.transpose()) / x.norm()).norm(),
              1e-12 / x.norm());
    const Vector3d within = at_gauge(cone, x, random.number(0, 1));
    const double slant = std::hypot(1 / a, 1 / c);
    EXPECT_NEAR(superquadric_distance_value(cone, within), (gauge(cone, within) - 1) / slant, 1e-14);
  }
  // Above a vertex, beside an edge, over a rim: nearest to the vertex, the edge, the rim.
  EXPECT_NEAR(superquadric_distance_value(octahedron, {0.01, -0.02, 1.1}), Vector3d(0.01, 0.02, 0.6).norm(), 1e-14);
  const Vector3d edge = Vector3d(a, 0, -c).normalized(), beside(0.5 * a + 0.2 / a, 0.01, 0.5 * c + 0.2 / c);
  const Vector3d from_vertex = beside - Vector3d(0, 0, c);
  EXPECT_NEAR(superquadric_distance_value(octahedron, beside), (from_vertex - edge * edge.dot(from_vertex)).norm(),
              1e-14);
  EXPECT_NEAR(superquadric_distance_value(cone, {0.6, 0.8, 0.1}), std::hypot(1 - a, 0.1), 1e-14);
}

TEST(SuperquadricDistanceVerification, HessianHasTheCurvaturesOfParallelSurfaces) {
  Random random(5);
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 30; ++k) {
      const Vector3d y =
          at_gauge(body, (random.positive_vector() + Vector3d::Constant(0.3)).cwiseProduct(body.semi_axes), 1);
      const Vector3d n = outward_normal(body, y);
      const PrincipalCurvatures at_foot = principal_curvatures(body, y);
      const double d = k % 2 == 0 ? random.number(0, 2) : -0.01 * std::min(0.1, 1 / at_foot.values[1]);
      const Distance computed = superquadric_distance(body, y + d * n);
      EXPECT_NEAR(computed.value, d, 1e-14 * (extent_of(body) + std::abs(d)));
      EXPECT_LT((computed.gradient - n).norm(), 1e-12 * std::max(1.0, at_foot.values[1] * extent_of(body)));
      Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 2; ++i) {
        const Vector3d t = at_foot.directions.col(i);
        expected += at_foot.values[i] / (1 + at_foot.values[i] * d) * t * t.transpose();
      }
      EXPECT_LT((computed.hessian - expected).norm(), 1e-10 * (1 / extent_of(body) + expected.norm()))
          << body.e1 << " " << body.e2 << " d " << d;
    }
}

TEST(SuperquadricDistance, DerivativesAreTheLimitsOfDifferences) {
  Random random(6);
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 10; ++k) {
      const Vector3d x = at_gauge(body, random.vector(), random.number(1.2, 3));
      const Distance at = superquadric_distance(body, x);
      const double h = 1e-6 * extent_of(body), sharp = std::pow(1 + at.hessian.norm() * extent_of(body), 3);
      for (int i = 0; i < 3; ++i) {
        const Distance after = superquadric_distance(body, x + h * Vector3d::Unit(i));
        const Distance before = superquadric_distance(body, x - h * Vector3d::Unit(i));
        EXPECT_NEAR((after.value - before.value) / (2 * h), at.gradient[i], 1e-8);
        // One in a hundred steps crosses from an edge's region to a face's, where the Hessian jumps.
        const double jump = (after.hessian - before.hessian).norm();
        EXPECT_LT(((after.gradient - before.gradient) / (2 * h) - at.hessian.col(i)).norm(),
                  1e-7 * sharp / extent_of(body) + jump);
      }
      EXPECT_LT((at.hessian * at.gradient).norm(), 1e-13 * at.hessian.norm() + 1e-300);
      EXPECT_LT((at.hessian - at.hessian.transpose()).norm(), 1e-15 * at.hessian.norm() + 1e-300);
    }
}

TEST(SuperquadricDistance, IsLipschitzAndSymmetric) {
  Random random(7);
  for (const Superquadric& body : bodies())
    for (int k = 0; k < 50; ++k) {
      const Vector3d x = 1.3 * random.vector(), y = x + std::exp(random.number(-12, 0)) * random.vector();
      const double d = superquadric_distance_value(body, x);
      EXPECT_LE(std::abs(d - superquadric_distance_value(body, y)), (x - y).norm() + 1e-14 * extent_of(body));
      const Vector3d mirrored(-x[0], x[1], -x[2]);
      EXPECT_EQ(superquadric_distance_value(body, mirrored), d);
      EXPECT_EQ(superquadric_distance(body, mirrored).gradient,
                superquadric_distance(body, x).gradient.cwiseProduct(Vector3d(-1, 1, -1)));
      EXPECT_EQ(superquadric_distance(body, x).value, d);
    }
}

TEST(SuperquadricDistance, ScalesWithTheBody) {
  Random random(8);
  for (const double size : {1e-90, 1e-9, 1e7, 1e90})
    for (const Superquadric& body : bodies()) {
      const Vector3d x = 1.5 * random.vector();
      const Distance at = superquadric_distance(body, x);
      const Distance scaled = superquadric_distance({size * body.semi_axes, body.e1, body.e2}, size * x);
      EXPECT_NEAR(scaled.value / size, at.value, 1e-13 * extent_of(body));
      EXPECT_LT((scaled.gradient - at.gradient).norm(), 1e-11);
      EXPECT_LT((size * scaled.hessian - at.hessian).norm(), 1e-8 * (1 + at.hessian.norm()));
    }
}

TEST(SuperquadricDistance, FiniteInputMakesFiniteOutput) {
  for (const Superquadric& body : bodies())
    for (const Vector3d& x : testing::awkward_points()) {
      const Distance d = superquadric_distance(body, x);
      ASSERT_TRUE(std::isfinite(d.value) && d.hessian.allFinite()) << x.transpose();
      ASSERT_NEAR(d.gradient.norm(), 1, 1e-14);
      ASSERT_LE(d.hessian.norm(), 2e9 / extent_of(body));
      ASSERT_TRUE(std::abs(d.value) < 1e-14 * extent_of(body) || (d.value > 0) == (gauge(body, x) > 1))
          << x.transpose();
    }
  const Superquadric tiny{{1e-100, 2e-100, 1e-100}, 0.5, 2};
  EXPECT_NEAR(superquadric_distance_value(tiny, {1e308, 0, 0}), 1e308, 1e294);
}

TEST(SuperquadricDistance, RefusesBadInput) {
  const Vector3d x(1, 1, 1);
  EXPECT_THROW(superquadric_distance({{1, 1, 1}, 0.05, 1}, x), std::invalid_argument);
  EXPECT_THROW(superquadric_distance_value({{1, 1, 1}, 1, 3}, x), std::invalid_argument);
  EXPECT_THROW(superquadric_distance({{1, -1, 1}, 1, 1}, x), std::invalid_argument);
  EXPECT_THROW(signed_distance(Superquadric{{1, 0, 1}, 1, 1}, x), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(signed_distance_value(Superquadric{{1, 1, 1}, 1, 1}, {nan, 0, 0})));
}

}  // namespace
}  // namespace mb
