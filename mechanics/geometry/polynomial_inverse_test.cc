#include "mechanics/geometry/polynomial_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mechanics/geometry/polynomial_test_maps.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using Eigen::Matrix3d;
using namespace testing;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(PolynomialInverseVerification, RigidMotionsAndAffineMapsInvertInOneStep) {
  RandomMaps random;
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
  EXPECT_FALSE(parabolas({0.3, 0, 0}, 2).inverse({1, 0, 0}, {}, 1));  // so steps are really limited
  EXPECT_TRUE(parabolas({0.3, 0, 0}, 2).inverse({1, 0, 0}));
}

TEST(PolynomialInverseVerification, ParabolaHasTheUnfoldedRoot) {
  double worst = 0;
  for (const double h : {1.0, 1e-3, 40.0})
    for (const double a : {-0.2, 0.4, 1.0})
      for (double s = -1.3; s < 1.4; s += 0.05) {
        const auto X = parabolas({a, 0, 0}, h).inverse({s * h, 0.2 * h, -0.1 * h});
        const double discriminant = 1 + 4 * a * s;
        const double root = 2 * s / (1 + std::sqrt(std::max(0.0, discriminant)));
        // At the fold itself and on the region's boundary either answer is right.
        if (std::abs(discriminant) < 1e-6 || std::abs(std::abs(root) - PolynomialMap::reach) < 1e-6) continue;
        const bool exists = discriminant > 0 && std::abs(root) <= PolynomialMap::reach;
        ASSERT_EQ(X.has_value(), exists) << a << " " << s;
        if (!exists) continue;
        // The residual, 1e-13 of the extent 2 h, over the slope.
        const double error = 2e-13 * h / std::sqrt(discriminant);
        EXPECT_LT((*X - h * Vector3d(root, 0.2, -0.1)).norm(), error);
        worst = std::max(2e-13 * (*X - h * Vector3d(root, 0.2, -0.1)).norm() / error, worst);
      }
  expect_verified(
      {.quantity = "inverse of x = X + a X^2/h short of its fold, times the slope there, over the half extent h",
       .reference = "exact solution",
       .source = "The unfolded root of the quadratic equation",
       .uncertainty = "rounding",
       .tolerance = 2e-13,
       .why = "Newton's method stops at a residual of 1e-13 of the extent 2 h, which the slope divides."},
      worst);
}

// x = X + a X^2 with a = 1 turns back at xi = -1/2: no point lies below x = -1/4, and starts beyond the fold do not
// lead to its roots.
TEST(PolynomialInverseVerification, FoldsAreDetected) {
  const PolynomialMap map = parabolas({1, 0, 0}, 1);
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

TEST(PolynomialInverse, KeepsToTheRegionOfValidity) {
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
TEST(PolynomialInverseVerification, OfForwardIsX) {
  RandomMaps random;
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
TEST(PolynomialInverse, SolvesItsEquationUnderLargeDeformation) {
  RandomMaps random;
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

// X -> -X(-x): every start, step and decision is that of the original, mirrored. Maps with folds and points without an
// inverse, where it matters which way a step leaves the region.
TEST(PolynomialInverse, MirroredMapsHaveMirroredInverses) {
  RandomMaps random;
  const Monomials m(4, {0, 0, 0}, {1, 0.5, 0.2});
  int found = 0, missing = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix3Xd a = random.coefficients(m, 0.2);
    Matrix3Xd mirrored = a;
    for (Index k = 0; k < m.size(); ++k) {
      const auto [i, j, l] = Monomials::exponents(k);
      if ((i + j + l) % 2 == 0) mirrored.col(k) *= -1;
    }
    const PolynomialMap map(m, a), mirror(m, mirrored);
    const Vector3d x = 2 * m.half_extents().cwiseProduct(random.vector());
    const auto X = map.inverse(x, {}, 4), Y = mirror.inverse(-x, {}, 4);  // few steps: the first start often fails
    ASSERT_EQ(X.has_value(), Y.has_value()) << trial;
    X ? ++found : ++missing;
    if (X) {
      EXPECT_LT((*X + *Y).norm(), 1e-15);
    }
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(missing, 20);
}

TEST(PolynomialInverse, BadInputIsRefused) {
  const PolynomialMap map = parabolas({0.1, 0, 0}, 1);
  EXPECT_THROW(map.inverse({0, nan, 0}), std::invalid_argument);
  EXPECT_THROW(map.inverse({0, 0, 0}, Vector3d(0, 0, nan)), std::invalid_argument);
  EXPECT_THROW(map.inverse({0, 0, 0}, {}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace mb
