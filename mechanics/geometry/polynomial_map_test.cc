#include "mechanics/geometry/polynomial_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace mb {
namespace {

using Eigen::Matrix3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Random {
 public:
  double operator()() { return uniform_(generator_); }
  Vector3d vector() { return {(*this)(), (*this)(), (*this)()}; }
  Matrix3Xd points(const Monomials& m, Index n, double reach = 1) {
    Matrix3Xd X(3, n);
    for (Index i = 0; i < n; ++i) X.col(i) = m.centre() + reach * m.half_extents().cwiseProduct(vector());
    return X;
  }
  // Coefficients of which the displacement is about `size` times the half extents.
  Matrix3Xd coefficients(const Monomials& m, double size) {
    Matrix3Xd a(3, m.size());
    for (Index k = 0; k < m.size(); ++k) a.col(k) = size * m.half_extents().cwiseProduct(vector());
    return a;
  }

 private:
  std::mt19937 generator_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

// x = c + t + A (X - c).
PolynomialMap affine(const Vector3d& c, const Vector3d& half, const Matrix3d& A, const Vector3d& t) {
  Matrix3Xd a(3, 4);
  a << t, (A - Matrix3d::Identity()) * half.asDiagonal();
  return {Monomials(1, c, half), a};
}

// x_1 = h (xi + a xi^2), else at rest: folded where xi < -1 / 2a.
PolynomialMap parabola(double a, double h) {
  const Monomials m(2, {0, 0, 0}, Vector3d(h, 1, 1));
  Matrix3Xd coefficients = Matrix3Xd::Zero(3, m.size());
  coefficients(0, monomial_index(2, 0, 0)) = a * h;
  return {m, coefficients};
}

const std::vector<Monomials> bodies = {Monomials(3, {0, 0, 0}, {1, 1, 1}),
                                       Monomials(2, {0.1, 2, -3}, {0.5, 0.01, 0.02}),
                                       Monomials(8, {-4, 0, 0.3}, {0.02, 0.05, 0.03})};

TEST(PolynomialMap, ManyPointsAtOnceAreTheSingleOnes) {
  Random random;
  for (const Monomials& m : bodies) {
    const PolynomialMap map(m, random.coefficients(m, 0.1));
    const Matrix3Xd X = random.points(m, 19, 1.5), x = map.positions(X),
                    F = map.gradients(X);  // not a multiple of a block
    for (Index i = 0; i < X.cols(); ++i) {
      const auto [position, gradient] = map.at(X.col(i));
      // Same operations in another order of components: rounding of up to 165 terms of size 0.1 * 1.5^8 half extents.
      EXPECT_LT((x.col(i) - position).norm(), 1e-13 * m.extent());
      EXPECT_LT((F.middleCols<3>(3 * i) - gradient).norm(), 1e-12 * gradient.norm());
      EXPECT_EQ(position, map.position(X.col(i)));
      EXPECT_EQ(gradient, map.gradient(X.col(i)));
    }
    EXPECT_EQ(map.positions(Matrix3Xd(3, 0)).cols(), 0);
  }
}

// The nested scheme against the sum over monomials.
TEST(PolynomialMap, IsTheSumOfItsMonomials) {
  Random random;
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
  Random random;
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

TEST(PolynomialMapVerification, RigidMotionsAndAffineMapsInvertInOneStep) {
  Random random;
  const std::vector<Matrix3d> matrices = {
      Matrix3d::Identity(), Eigen::AngleAxisd(2.5, Vector3d(1, 2, -1).normalized()).toRotationMatrix(),
      Vector3d(0.3, 2, 1.1).asDiagonal().toDenseMatrix(), (Matrix3d() << 1, 0.9, -3, 0, 1, 0.2, 0, 0, 0.5).finished()};
  for (const Vector3d& half : {Vector3d(1, 1, 1), Vector3d(0.5, 0.01, 0.02)})
    for (const Matrix3d& A : matrices) {
      const Vector3d c(2, -1, 0.5), t(0.4, 3, -0.1);
      const PolynomialMap map = affine(c, half, A, t);
      const double size = map.monomials().extent();
      for (int i = 0; i < 20; ++i) {
        const Vector3d X = c + 1.5 * half.cwiseProduct(random.vector()), x = c + t + A * (X - c);
        EXPECT_LT((map.position(X) - x).norm(), 1e-14 * (size + x.norm()));
        EXPECT_LT((map.gradient(X) - A).norm(), 1e-13 * A.norm());  // (A - I) h / h
        const auto back = map.inverse(x, {}, 1);
        ASSERT_TRUE(back) << A;
        EXPECT_LT((*back - X).norm(), 2e-13 * (size + x.norm()));  // |A^-1| < 10, and the rounding of x and c
      }
      EXPECT_TRUE(map.certainly_invertible());
    }
  EXPECT_FALSE(parabola(0.3, 2).inverse({1, 0, 0}, {}, 1));  // so steps are really limited
  EXPECT_TRUE(parabola(0.3, 2).inverse({1, 0, 0}));
}

TEST(PolynomialMapVerification, ParabolaHasTheUnfoldedRoot) {
  for (const double h : {1.0, 1e-3, 40.0})
    for (const double a : {-0.2, 0.4, 1.0})
      for (double s = -1.3; s < 1.4; s += 0.05) {
        const auto X = parabola(a, h).inverse({s * h, 0.2, -0.1});
        const double discriminant = 1 + 4 * a * s;
        const double root = 2 * s / (1 + std::sqrt(std::max(0.0, discriminant)));
        // At the fold itself and on the region's boundary either answer is right.
        if (std::abs(discriminant) < 1e-6 || std::abs(std::abs(root) - PolynomialMap::reach) < 1e-6) continue;
        const bool exists = discriminant > 0 && std::abs(root) <= PolynomialMap::reach;
        ASSERT_EQ(X.has_value(), exists) << a << " " << s;
        if (!exists) continue;
        // The residual, 1e-13 of the extent max(2 h, 2), over the slope.
        const double error = 2e-13 * std::max(1.0, h) / std::sqrt(discriminant);
        EXPECT_LT((*X - Vector3d(root * h, 0.2, -0.1)).norm(), error + 1e-15);
      }
}

// x = X + a X^2 with a = 1 turns back at xi = -1/2: no point lies below x = -1/4, and starts beyond the fold do not
// lead to its roots.
TEST(PolynomialMapVerification, FoldsAreDetected) {
  const PolynomialMap map = parabola(1, 1);
  EXPECT_FALSE(map.certainly_invertible());
  EXPECT_FALSE(map.inverse({-0.26, 0, 0}));
  EXPECT_FALSE(map.inverse({-0.26, 0, 0}, Vector3d(-0.9, 0, 0)));
  const auto X = map.inverse({-0.2, 0, 0}, Vector3d(-0.9, 0, 0));
  ASSERT_TRUE(X);
  EXPECT_NEAR((*X)[0], (-1 + std::sqrt(0.2)) / 2, 1e-12);
  EXPECT_GT(map.gradient(*X).determinant(), 0);

  const Vector3d mirrored(-1, 1, 1);  // det F = -1 everywhere
  const PolynomialMap mirror = affine({0, 0, 0}, {1, 1, 1}, mirrored.asDiagonal(), {0, 0, 0});
  const PolynomialMap point = affine({0, 0, 0}, {1, 1, 1}, Matrix3d::Zero(), {0, 0, 0});  // det F = 0
  for (const PolynomialMap& folded : {mirror, point}) {
    EXPECT_FALSE(folded.certainly_invertible());
    EXPECT_FALSE(folded.inverse({0.5, 0, 0}));
    EXPECT_FALSE(folded.inverse({0, 0, 0}));
  }
}

TEST(PolynomialMap, InverseKeepsToTheRegionOfValidity) {
  const PolynomialMap rest = affine({1, 2, 3}, {0.5, 0.1, 1}, Matrix3d::Identity(), {0, 0, 0});
  EXPECT_EQ(rest.monomials().degree(), 0);
  const Vector3d near(1.95, 2.19, 3), far(2.05, 2, 3);
  ASSERT_TRUE(rest.inverse(near));
  EXPECT_LT((*rest.inverse(near) - near).norm(), 1e-15);
  EXPECT_FALSE(rest.inverse(far));
  EXPECT_FALSE(rest.inverse({1e300, 0, 0}));
  EXPECT_TRUE(rest.inverse(near, Vector3d(1e300, 0, 0)));  // guesses are moved into the region
  const PolynomialMap wild = affine({0, 0, 0}, {1, 1, 1}, 1e200 * Matrix3d::Ones(), {0, 0, 0});
  EXPECT_FALSE(wild.inverse({1, 0, 0}));  // overflow inside: no answer, no NaN
  EXPECT_NEAR(wild.lipschitz_bound() / 3e200, 1, 1e-14);
  EXPECT_FALSE(wild.certainly_invertible());
}

// Wherever |grad u| < 1 in axes scaled to the box the map is one to one: the inverse must be X itself. Its error is the
// residual, and the rounding of x, over the least singular value of F in those axes (> 1 - 0.8).
TEST(PolynomialMapVerification, InverseOfForwardIsX) {
  Random random;
  for (int degree = 1; degree <= 8; ++degree)
    for (const Vector3d& half : {Vector3d(1, 0.7, 1.3), Vector3d(0.5, 0.01, 0.02)})
      for (const double distance : {0.0, 1e3}) {
        const Monomials m(degree, Vector3d(distance, 0, -distance) * half.maxCoeff(), half);
        const Matrix3Xd X = random.points(m, 40), a = random.coefficients(m, 1);
        double largest = 0;
        const Matrix3Xd F = PolynomialMap(m, a).gradients(X);
        for (Index i = 0; i < X.cols(); ++i) {
          const Matrix3d grad = F.middleCols<3>(3 * i) - Matrix3d::Identity();
          largest = std::max(largest, (half.cwiseInverse().asDiagonal() * grad * half.asDiagonal()).norm());
        }
        const PolynomialMap map(m, a * (0.8 / largest));
        for (Index i = 0; i < X.cols(); ++i) {
          const Vector3d x = map.position(X.col(i));
          const auto back = map.inverse(x), warm = map.inverse(x, Vector3d(X.col(i) + 0.01 * half));
          ASSERT_TRUE(back && warm) << degree << " " << i;
          const double error = 1e-13 * m.extent() + 4e-16 * X.col(i).norm();
          EXPECT_LT((*back - X.col(i)).cwiseQuotient(half).norm(), 5 * error / half.minCoeff());
          EXPECT_LT((*warm - X.col(i)).cwiseQuotient(half).norm(), 5 * error / half.minCoeff());
          EXPECT_LT((map.position(*back) - x).norm(), error);
        }
      }
}

// Strongly deformed bodies: each point of the body whose image is unfolded has an inverse, if not always that point.
TEST(PolynomialMap, InverseSolvesItsEquationUnderLargeDeformation) {
  Random random;
  int found = 0, asked = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Monomials m(3, {0, 0, 0}, {1, 0.1, 0.3});
    const PolynomialMap map(m, random.coefficients(m, 0.3));
    const Matrix3Xd X = random.points(m, 20);
    for (Index i = 0; i < X.cols(); ++i) {
      if (map.gradient(X.col(i)).determinant() <= 0) continue;
      ++asked;
      const Vector3d x = map.position(X.col(i));
      const auto back = map.inverse(x);
      if (!back) continue;
      ++found;
      EXPECT_LT((map.position(*back) - x).norm(), 2e-13 * std::max(m.extent(), x.norm()));
      EXPECT_GT(map.gradient(*back).determinant(), 0);
    }
  }
  EXPECT_GT(asked, 1000);
  EXPECT_GT(found, 0.99 * asked);  // Newton from four starts is no guarantee; all but a few in 1000 are found
}

TEST(PolynomialMap, BoundsHold) {
  Random random;
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
  EXPECT_NEAR(parabola(0.3, 2).lipschitz_bound(), 0.6, 1e-15);
  EXPECT_EQ(parabola(0.3, 2).displacement_bound(), Vector3d(0.6, 0, 0));
}

TEST(PolynomialMap, CertainlyInvertibleUpToTheFirstFold) {
  EXPECT_TRUE(parabola(0.499, 2).certainly_invertible());
  EXPECT_FALSE(parabola(0.501, 2).certainly_invertible());
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
  const PolynomialMap map = parabola(0.1, 1);
  EXPECT_THROW(map.inverse({0, nan, 0}), std::invalid_argument);
  EXPECT_THROW(map.inverse({0, 0, 0}, Vector3d(0, 0, nan)), std::invalid_argument);
  EXPECT_THROW(map.inverse({0, 0, 0}, {}, 0), std::invalid_argument);
  EXPECT_TRUE(std::isnan(map.position({nan, 0, 0})[0]));  // propagates
  EXPECT_TRUE(std::isnan(map.positions(Vector3d(nan, 0, 0))(0, 0)));
}

}  // namespace
}  // namespace mb
