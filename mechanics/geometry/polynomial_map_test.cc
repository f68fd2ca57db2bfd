#include "mechanics/geometry/polynomial_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/geometry/polynomial_test_maps.h"

namespace mb {
namespace {

using Eigen::Matrix3d;
using namespace testing;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const std::vector<Monomials> bodies = {Monomials(3, {0, 0, 0}, {1, 1, 1}),
                                       Monomials(2, {0.1, 2, -3}, {0.5, 0.01, 0.02}),
                                       Monomials(8, {-4, 0, 0.3}, {0.02, 0.05, 0.03})};

TEST(PolynomialMap, ManyPointsAtOnceAreTheSingleOnes) {
  RandomMaps random;
  for (const Monomials& m : bodies) {
    const PolynomialMap map(m, random.coefficients(m, 0.1));
    const Matrix3Xd X = random.points(m, 19, 1.5), x = map.positions(X),
                    F = map.gradients(X);  // not a multiple of a block
    const auto both = map.points(X);
    EXPECT_EQ(both.x, x);
    EXPECT_EQ(both.F, F);
    for (Index i = 0; i < X.cols(); ++i) {
      const auto [position, gradient] = map.at(X.col(i));
      // Same operations in another order of components: rounding of up to 165 terms of size 0.1 * 1.5^8 half extents.
      EXPECT_LT((x.col(i) - position).norm(), 1e-13 * m.extent());
      EXPECT_LT((F.middleCols<3>(3 * i) - gradient).norm(), 1e-12 * gradient.norm());
      EXPECT_EQ(position, map.position(X.col(i)));
      EXPECT_EQ(gradient, map.gradient(X.col(i)));
    }
    EXPECT_EQ(map.positions(Matrix3Xd(3, 0)).cols(), 0);
    EXPECT_EQ(map.points(Matrix3Xd(3, 0)).F.cols(), 0);
  }
}

// The nested scheme against the sum over monomials.
TEST(PolynomialMap, IsTheSumOfItsMonomials) {
  RandomMaps random;
  for (const Monomials& m : bodies) {
    const Matrix3Xd a = random.coefficients(m, 0.1), X = random.points(m, 20);
    const PolynomialMap map(m, a);
    const Matrix3Xd u = a * m.values(X).transpose();
    const auto along = m.gradients(X);
    for (Index i = 0; i < X.cols(); ++i) {
      EXPECT_LT((map.displacement(X.col(i)) - u.col(i)).norm(), 1e-14 * m.extent());
      Matrix3d F = Matrix3d::Identity();
      for (Index b = 0; b < 3; ++b) F.col(b) += a * along[static_cast<size_t>(b)].row(i).transpose();
      EXPECT_LT((map.gradient(X.col(i)) - F).norm(), 1e-13 * F.norm());
    }
  }
}

// Central differences over d = 1e-5 half extents: d^2 u''' / 6 ~ 1e-9, rounding eps |x - c| / d ~ 1e-11, more where |c|
// is far larger than the body (both in units of the largest entry of F scaled to the box).
TEST(PolynomialMap, GradientByDifferences) {
  RandomMaps random;
  for (const Monomials& m : bodies) {
    const PolynomialMap map(m, random.coefficients(m, 0.1));
    const Vector3d& h = m.half_extents();
    for (int i = 0; i < 20; ++i) {
      const Vector3d X = m.centre() + h.cwiseProduct(random.vector());
      Matrix3d scaled, differences;
      for (Index b = 0; b < 3; ++b) {
        const Vector3d d = 1e-5 * h[b] * Vector3d::Unit(b);
        differences.col(b) = ((map.position(X + d) - map.position(X - d)) / 2e-5).cwiseQuotient(h);
      }
      scaled = h.cwiseInverse().asDiagonal() * map.gradient(X) * h.asDiagonal();
      const double rounding = 1e-15 * m.centre().norm() / h.minCoeff() / 1e-5;
      EXPECT_LT((scaled - differences).norm(), 1e-7 + rounding);
    }
  }
}

TEST(PolynomialMap, DegreeIsThatOfTheLastCoefficientsNotZero) {
  const Monomials m(5, {0, 0, 0}, {1, 2, 3});
  Matrix3Xd a = Matrix3Xd::Zero(3, m.size());
  EXPECT_EQ(PolynomialMap(m, a).monomials().degree(), 0);
  a(2, monomial_index(1, 0, 2)) = 1e-300;
  EXPECT_EQ(PolynomialMap(m, a).monomials().degree(), 3);
}

TEST(PolynomialMap, BoundsHold) {
  RandomMaps random;
  for (const Monomials& m : bodies) {
    const PolynomialMap map(m, random.coefficients(m, 0.1));
    const Matrix3Xd X = random.points(m, 200), F = map.gradients(X);
    const double L = map.lipschitz_bound();
    const Matrix3Xd u = map.positions(X) - X;
    for (Index i = 0; i < X.cols(); ++i) {
      EXPECT_LE((F.middleCols<3>(3 * i) - Matrix3d::Identity()).operatorNorm(), L);
      EXPECT_TRUE((u.col(i).cwiseAbs().array() <= map.displacement_bound().array()).all());
    }
  }
  // Sharp: xi^2 a h has the largest slope 2 a and the largest displacement a h at the face.
  EXPECT_NEAR(parabolas({0.3, 0, 0}, 2).lipschitz_bound(), 0.6, 1e-15);
  EXPECT_EQ(parabolas({0.3, 0, 0}, 2).displacement_bound(), Vector3d(0.6, 0, 0));
}

TEST(PolynomialMap, CertainlyInvertibleUpToTheFirstFold) {
  // In every direction, and in two at once (where the product of two minors is positive again).
  for (Index a = 0; a < 3; ++a) {
    EXPECT_TRUE(parabolas(0.499 * Vector3d::Unit(a), 2).certainly_invertible());
    EXPECT_FALSE(parabolas(0.501 * Vector3d::Unit(a), 2).certainly_invertible());
    EXPECT_FALSE(parabolas(0.6 * (Vector3d::Ones() - Vector3d::Unit(a)), 2).certainly_invertible());
  }
  Matrix3d singular = Matrix3d::Identity();  // but for rounding
  singular.topLeftCorner<2, 2>() << 1, 1 - 2e-16, 1, 1;
  EXPECT_FALSE(affine({0, 0, 0}, {1, 1, 1}, singular, {0, 0, 0}).certainly_invertible());
  // Large gradients alone do no harm: a shear of a slender body, and of that a bent one.
  Matrix3d shear = Matrix3d::Identity();
  shear(0, 1) = 30;
  EXPECT_TRUE(affine({0, 0, 0}, {1, 0.01, 0.01}, shear, {0, 0, 0}).certainly_invertible());
  const Monomials m(2, {0, 0, 0}, {1, 0.01, 0.01});
  Matrix3Xd a = Matrix3Xd::Zero(3, m.size());
  a(1, monomial_index(2, 0, 0)) = 1;  // y moves by 100 half thicknesses: |grad u| = 2, det F = 1
  EXPECT_NEAR(PolynomialMap(m, a).lipschitz_bound(), 2, 1e-14);
  EXPECT_TRUE(PolynomialMap(m, a).certainly_invertible());
}

TEST(PolynomialMap, BadInputIsRefused) {
  const Monomials m(2, {0, 0, 0}, {1, 1, 1});
  Matrix3Xd a = Matrix3Xd::Zero(3, m.size());
  EXPECT_THROW(PolynomialMap(m, a.leftCols(9)), std::invalid_argument);
  a(1, 7) = nan;
  EXPECT_THROW(PolynomialMap(m, a), std::invalid_argument);
  const PolynomialMap map = parabolas({0.1, 0, 0}, 1);
  EXPECT_TRUE(std::isnan(map.position({nan, 0, 0})[0]));  // propagates
  EXPECT_TRUE(std::isnan(map.positions(Vector3d(nan, 0, 0))(0, 0)));
}

}  // namespace
}  // namespace mb
