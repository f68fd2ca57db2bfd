#include "modal/contact/modal_bounds.h"
#include "mechanics/algebra/dense_eigen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/geometry/signed_distance.h"
#include "modal/contact/floating_bodies_test.h"
#include "modal/frame/body_flight.h"

namespace mb {
namespace {

using testing::at_rest;
using testing::floating;
using testing::half_box;
using testing::random_modes;

const std::vector<Shape> shapes{Box{{0.1, 0.02, 0.3}}, Cylinder{0.05, 0.02}, Sphere{0.07},
                                Superquadric{{0.05, 0.03, 0.08}, 0.4, 1.6},
                                TaperedSuperquadric{{{0.05, 0.03, 0.08}, 0.8, 1}, -0.6}};

// Points inside and on the surface: those inside of a lattice and what lies outside pulled in.
Matrix3Xd points_of(const Shape& shape, int n) {
  std::vector<Vector3d> X;
  const Vector3d half = half_box(shape);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) {
        Vector3d x = half.cwiseProduct(Vector3d(i, j, k) * 2 / n - Vector3d::Ones());
        while (signed_distance_value(shape, x) > 0) x *= 0.98;
        X.push_back(x);
      }
  Matrix3Xd all(3, static_cast<Index>(X.size()));
  for (size_t i = 0; i < X.size(); ++i) all.col(static_cast<Index>(i)) = X[i];
  return all;
}

struct Found {
  double value = 0, gradient = 0, bend = 0;
};
// Second derivatives along random directions, by differences of the gradient: below the largest there is.
Found largest(const Shape& shape, const Matrix3Xd& X, const PolynomialBasis& modes, Index j) {
  const PolynomialMap map = modes.map(VectorXd::Unit(modes.size(), j));
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  Found found;
  for (Index i = 0; i < X.cols(); ++i) {
    const Vector3d x = X.col(i);
    found.value = std::max(found.value, map.displacement(x).norm());
    const Eigen::Matrix3d G = map.gradient(x) - Eigen::Matrix3d::Identity();
    found.gradient = std::max(found.gradient, spectral_norm(G));
    const Vector3d a = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const double h = 1e-5 * half_box(shape).minCoeff();
    const Eigen::Matrix3d D = (map.gradient(x + h * a) - map.gradient(x - h * a)) / (2 * h);
    found.bend = std::max(found.bend, spectral_norm(D));
  }
  return found;
}

// They hold, and are not silly: |phi| to 1/cos^3(pi/6) = 1.54 and what the lattice misses of it, but for superquadrics,
// which fill their ellipsoids less than the others their grids, at most sqrt(monomials) times as much; derivatives to
// Markov's d^2 over the least width, which the most slender shape is off by its slenderness.
TEST(ModalBounds, HoldOnAllOfTheBodyAndAreNotSilly) {
  for (size_t k = 0; k < shapes.size(); ++k) {
    const Matrix3Xd X = points_of(shapes[k], 8);
    for (const int degree : {0, 1, 2, 3, 5, 8}) {
      const PolynomialBasis modes = random_modes(shapes[k], degree, 2, 0.7, static_cast<unsigned>(degree));
      const ShapeBounds bounds = shape_bounds(shapes[k], modes);
      ASSERT_EQ(bounds.value.size(), 2);
      const Vector3d half = half_box(shapes[k]);
      const double slender = half.maxCoeff() / half.minCoeff(), d2 = std::max(1, degree * degree);
      const double loose = k >= 3 ? std::sqrt(static_cast<double>(modes.monomials().size())) * 4 : 2.2;
      for (Index j = 0; j < 2; ++j) {
        const Found found = largest(shapes[k], X, modes, j);
        EXPECT_LE(found.value, bounds.value[j] * (1 + 1e-12)) << k << ' ' << degree;
        EXPECT_LE(found.gradient, bounds.gradient[j] * (1 + 1e-12)) << k << ' ' << degree;
        EXPECT_LE(found.bend, bounds.bend[j] * (1 + 1e-6) + 1e-6) << k << ' ' << degree;  // of the differences
        EXPECT_LE(bounds.value[j], loose * found.value) << k << ' ' << degree;
        EXPECT_LE(bounds.gradient[j], loose * d2 * slender * found.gradient) << k << ' ' << degree;
        if (degree < 2)
          EXPECT_EQ(bounds.bend[j], 0);
        else
          EXPECT_LE(bounds.bend[j], loose * d2 * d2 * slender * slender * found.bend) << k << ' ' << degree;
      }
    }
  }
}

TEST(ModalBounds, AreSharpForWhatSwells) {
  const Shape ball = Sphere{0.05};
  const ShapeBounds bounds = shape_bounds(ball, testing::swelling(0.05, 2));
  EXPECT_GE(bounds.value[0], 2);  // at the surface; by its coefficients 2 (1 + 1 + 1)
  EXPECT_LE(bounds.value[0], 2 * 1.5397);
  EXPECT_GE(bounds.gradient[0], 2 / 0.05 * (1 - 1e-15));
  EXPECT_LE(bounds.gradient[0], 2 / 0.05 * 1.5397);
  EXPECT_EQ(bounds.bend[0], 0);
  EXPECT_EQ(shape_bounds(ball, testing::no_modes(ball)).value.size(), 0);
}

// Modes of every kind: weak, strong and critical damping, none, and one that nothing holds.
TEST(AmplitudeBounds, HoldForEverAndAreMet) {
  FloatingBody body = floating(Sphere{0.05},
                               {roots({100, 0}), roots({1e4, 4}), roots({1e4, 200}), roots({1e4, 900}), roots({0, 0}),
                                roots({0, 3}), roots({400, 0.1})},
                               {0, 0, 0});
  body.free = false;
  const double T = 3;
  for (const double weight : {0.0, 0.7, -2.0}) {
    body.weight.setConstant(weight);
    BodyState start = at_rest(body, Vector3d::Zero());
    start.q << 0.1, -0.2, 0.05, 0.3, 0.1, -0.1, 0;
    start.p << -1, 3, 20, -4, 0.2, 0.5, 0;
    const AmplitudeBounds bounds = amplitude_bounds(body, start.q, start.p, T);
    const BodyFlight flight(body, start, 0);
    VectorXd q = VectorXd::Zero(7), p = q, a = q;
    const int n = 20000;
    for (int k = 0; k <= n; ++k) {
      const BodyState at = flight.at(T * k / n);
      q = q.cwiseMax(at.q.cwiseAbs()), p = p.cwiseMax(at.p.cwiseAbs());
      for (Index i = 0; i < 7; ++i) {
        const Roots& mode = body.modes[static_cast<size_t>(i)];
        a[i] = std::max(a[i], std::abs(weight - 2 * mode.h * at.p[i] - mode.k * at.q[i]));
      }
    }
    EXPECT_TRUE((q.array() <= bounds.q.array() * (1 + 1e-12)).all()) << (bounds.q - q).transpose();
    EXPECT_TRUE((p.array() <= bounds.p.array() * (1 + 1e-12)).all()) << (bounds.p - p).transpose();
    EXPECT_TRUE((a.array() <= bounds.a.array() * (1 + 1e-12)).all()) << (bounds.a - a).transpose();
    // Without damping they are reached, |q| about a rest of weight / k but for the side that swings farther.
    EXPECT_GT(q[0], 0.999 * bounds.q[0]);
    EXPECT_GT(p[0], 0.999 * bounds.p[0]);
    EXPECT_GT(a[0], 0.999 * bounds.a[0]);
    EXPECT_NEAR(bounds.q[4], 0.1 + 0.2 * T + std::abs(weight) * T * T, 1e-12);
  }
}

}  // namespace
}  // namespace mb
