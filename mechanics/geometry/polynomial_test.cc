#include "mechanics/geometry/polynomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace mb {
namespace {

Matrix3Xd points_in_box(const Monomials& m, Index n) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matrix3Xd X(3, n);
  for (auto& x : X.reshaped()) x = uniform(generator);
  return (m.half_extents().asDiagonal() * X).colwise() + m.centre();
}

const Vector3d centre(0.3, -0.2, 1), half(0.5, 0.01, 0.2);

TEST(Monomials, AreAllOfThatDegreeOnceAndInGradedOrder) {
  for (int degree = 0; degree <= max_polynomial_degree; ++degree) {
    const Monomials m(degree, centre, half);
    std::set<std::array<int, 3>> all;
    int last = 0;
    for (Index k = 0; k < m.size(); ++k) {
      const auto e = Monomials::exponents(k);
      const int total = e[0] + e[1] + e[2];
      EXPECT_EQ(monomial_index(e[0], e[1], e[2]), k);
      EXPECT_GE(total, last);
      EXPECT_LE(total, degree);
      last = total;
      all.insert(e);
    }
    EXPECT_EQ(last, degree);
    // (degree + 3 over 3) is the number of triples.
    EXPECT_EQ(static_cast<Index>(all.size()), (degree + 1) * (degree + 2) * (degree + 3) / 6);
    EXPECT_EQ(static_cast<Index>(all.size()), m.size());
  }
}

// Recurrences against powers: a product of at most 8 factors rounds by 8 eps.
TEST(Monomials, ValuesArePowers) {
  const Monomials m(8, centre, half);
  const Matrix3Xd X = points_in_box(m, 50);
  const MatrixXd values = m.values(X);
  for (Index i = 0; i < X.cols(); ++i)
    for (Index k = 0; k < m.size(); ++k) {
      const auto [a, b, c] = Monomials::exponents(k);
      const Vector3d xi = (X.col(i) - centre).cwiseQuotient(half);
      const double expected = std::pow(xi[0], a) * std::pow(xi[1], b) * std::pow(xi[2], c);
      EXPECT_NEAR(values(i, k), expected, 4e-15 * std::abs(expected));
    }
}

TEST(Monomials, GradientsAreClosedForms) {
  const Monomials m(8, centre, half);
  const Matrix3Xd X = points_in_box(m, 50);
  const auto along = m.gradients(X);
  for (Index i = 0; i < X.cols(); ++i)
    for (Index k = 0; k < m.size(); ++k) {
      const auto e = Monomials::exponents(k);
      const Vector3d xi = (X.col(i) - centre).cwiseQuotient(half);
      for (size_t a = 0; a < 3; ++a) {
        double expected = 1 / half[static_cast<Index>(a)];
        for (size_t b = 0; b < 3; ++b) {
          const double x = xi[static_cast<Index>(b)];
          expected *= a != b ? std::pow(x, e[b]) : e[b] == 0 ? 0 : e[b] * std::pow(x, e[b] - 1);
        }
        EXPECT_NEAR(along[a](i, k), expected, 1e-14 * std::abs(expected));  // up to 8 equal terms are summed
      }
    }
}

TEST(Monomials, BoxAboutPoints) {
  Matrix3Xd X(3, 3);
  X << 1, 3, 2, 10, 10.02, 10, 5, 5, 5;
  const Monomials m = monomials_about(X, 2);
  EXPECT_LT((m.centre() - Vector3d(2, 10.01, 5)).norm(), 1e-14);
  EXPECT_LT((m.half_extents() - Vector3d(1, 0.01, 1)).norm(), 1e-14);  // flat along z: the largest
  EXPECT_DOUBLE_EQ(m.extent(), 2);
}

TEST(Monomials, BadInputIsRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Monomials(-1, centre, half), std::invalid_argument);
  EXPECT_THROW(Monomials(9, centre, half), std::invalid_argument);
  EXPECT_THROW(Monomials(2, centre, {1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(Monomials(2, centre, {1, nan, 1}), std::invalid_argument);
  EXPECT_THROW(Monomials(2, centre, {nan, 1, 1}), std::invalid_argument);
  EXPECT_THROW(Monomials(2, {0, nan, 0}, half), std::invalid_argument);
  EXPECT_THROW(Monomials::exponents(-1), std::invalid_argument);
  EXPECT_THROW(Monomials::exponents(165), std::invalid_argument);
  EXPECT_THROW(monomials_about(Matrix3Xd(3, 0), 1), std::invalid_argument);
  EXPECT_THROW(monomials_about(Matrix3Xd::Ones(3, 4), 1), std::invalid_argument);
  EXPECT_THROW(monomials_about(Vector3d(nan, 0, 0).replicate(1, 2), 1), std::invalid_argument);
  EXPECT_TRUE(std::isnan(Monomials(1, centre, half).values(Vector3d(nan, 0, 0))(0, 1)));  // propagates
}

}  // namespace
}  // namespace mb
