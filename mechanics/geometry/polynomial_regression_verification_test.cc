#include "mechanics/geometry/polynomial_regression.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "mechanics/geometry/gauss.h"
#include "mechanics/geometry/polynomial_test_samples.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using namespace testing;

Samples gauss_points(const Vector3d& half, const std::array<int, 3>& n) {
  const std::array<Rule, 3> rule = {gauss_legendre(n[0]), gauss_legendre(n[1]), gauss_legendre(n[2])};
  Samples s{Matrix3Xd(3, n[0] * n[1] * n[2]), VectorXd(n[0] * n[1] * n[2])};
  Index at = 0;
  for (Index i = 0; i < n[0]; ++i)
    for (Index j = 0; j < n[1]; ++j)
      for (Index k = 0; k < n[2]; ++k, ++at) {
        const Vector3d unit(rule[0].x[i], rule[1].x[j], rule[2].x[k]);
        s.X.col(at) = half.cwiseProduct(2 * unit - Vector3d::Ones());
        s.w[at] = rule[0].w[i] * rule[1].w[j] * rule[2].w[k];
      }
  return s;
}

TEST(RegressionVerification, PolynomialsAreReproduced) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double worst = 0;
  for (int degree = 0; degree <= 8; ++degree)
    for (const Vector3d& half : {ones, slender})
      for (const double distance : {0.0, 1e3}) {
        const Vector3d centre(distance, -distance, 0.5 * distance);
        const Samples s = scattered(centre, half, 900), others = scattered(centre, 0.9 * half, 37);
        MatrixXd a(3 * n_monomials(degree), 2);
        for (auto& value : a.reshaped()) value = uniform(generator);
        const Field field = [&](const Vector3d& X) {  // powers, not recurrences
          const Vector3d xi = (X - centre).cwiseQuotient(half);
          Vector3d u = Vector3d::Zero();
          for (Index k = 0; k < n_monomials(degree); ++k) {
            const auto [i, j, l] = Monomials::exponents(k);
            u += a.block<3, 1>(3 * k, 0) * std::pow(xi[0], i) * std::pow(xi[1], j) * std::pow(xi[2], l);
          }
          return u;
        };
        const Regression fit = regress(Monomials(8, centre, half), s.X, s.w, modes(s.X, {field}));
        EXPECT_EQ(fit.modes[0].degree, degree);
        EXPECT_EQ(fit.basis.monomials().degree(), degree);
        EXPECT_EQ(fit.rank, 165);
        EXPECT_LT(fit.modes[0].residual, 1e-12);
        EXPECT_LT(fit.modes[0].largest_residual, 1e-12);
        // At other points and in the coefficients rounding grows with the condition number, some 1e4 for degree 8.
        const MatrixXd exact = modes(others.X, {field});
        EXPECT_LT((fit.basis.at(others.X) - exact).norm(), 1e-12 * exact.norm());
        worst = std::max((fit.basis.at(others.X) - exact).norm() / exact.norm(), worst);
        EXPECT_LT((fit.basis.coefficients() - a.col(0)).norm(), 1e-15 * fit.condition * a.col(0).norm());
        EXPECT_EQ(fit.modes[0].n_kept, 3 * n_monomials(degree));
      }
  expect_verified(
      {.quantity = "fitted fields of degrees 0 to 8 at points that were not fitted, relative in the Euclidean norm",
       .reference = "manufactured solution",
       .source = "Polynomials of random coefficients by powers",
       .uncertainty = "rounding",
       .tolerance = 1e-12,
       .why = "Rounding times the condition number, some 1e4 for degree 8."},
      worst);
}

TEST(RegressionVerification, RigidMotionsAndStrainsHaveOnlyTheirOwnCoefficients) {
  const Vector3d centre(0.2, 4, -1);
  const Samples s = scattered(centre, slender, 300);
  std::vector<Field> fields;
  for (Index a = 0; a < 3; ++a) fields.push_back([a](const Vector3d&) { return Vector3d(Vector3d::Unit(a)); });
  for (Index a = 0; a < 3; ++a)
    fields.push_back([&, a](const Vector3d& X) { return Vector3d(Vector3d::Unit(a).cross(X - centre)); });
  fields.push_back([&](const Vector3d& X) { return Vector3d(X[0] - centre[0], 0, 0); });
  const Regression fit = regress(Monomials(4, centre, slender), s.X, s.w, modes(s.X, fields));
  const std::vector<Index> kept = {1, 1, 1, 2, 2, 2, 1};
  for (size_t j = 0; j < kept.size(); ++j) {
    EXPECT_EQ(fit.modes[j].n_kept, kept[j]) << j;
    EXPECT_EQ(fit.modes[j].degree, j < 3 ? 0 : 1);
    EXPECT_LT(fit.modes[j].residual, 1e-13);
  }
  // Hence an affine map: rotated by q about z (linearised), x = c + (1, q; -q, 1) (X - c), inverted in one step.
  const VectorXd q = 0.5 * VectorXd::Unit(7, 5);
  const Vector3d X = centre + Vector3d(0.3, -0.01, 0.02);
  const PolynomialMap map = fit.basis.map(q);
  const auto back = map.inverse(map.position(X), {}, 1);
  ASSERT_TRUE(back);
  EXPECT_LT((*back - X).norm(), 1e-14);
  EXPECT_LT((map.position(X) - X - 0.5 * Vector3d(0.01, 0.3, 0)).norm(), 1e-14);
}

// Pure bending of a beam along x (Timoshenko & Goodier, section 102): quadratic, with anticlastic curvature.
TEST(RegressionVerification, PureBendingIsQuadratic) {
  constexpr double nu = 0.3;
  const Field bending = [](const Vector3d& X) {
    const auto& [x, y, z] = std::tuple(X[0], X[1], X[2]);
    return Vector3d(-x * z, nu * y * z, (x * x + nu * (z * z - y * y)) / 2);
  };
  const Samples s = scattered({0, 0, 0}, slender, 400);
  const Regression fit = regress(Monomials(5, {0, 0, 0}, slender), s.X, s.w, modes(s.X, {bending}));
  EXPECT_EQ(fit.modes[0].degree, 2);
  EXPECT_EQ(fit.modes[0].n_kept, 5);
  const PolynomialMap map = fit.basis.map(VectorXd::Constant(1, 0.1));
  const Vector3d X(0.7, -0.01, 0.04);
  Eigen::Matrix3d F;
  F << -X[2], 0, -X[0], 0, nu * X[2], nu * X[1], X[0], -nu * X[1], nu * X[2];
  F = 0.1 * F + Eigen::Matrix3d::Identity();
  EXPECT_LT((map.gradient(X) - F).norm(), 1e-12);
  EXPECT_TRUE(map.certainly_invertible());
  EXPECT_LT((*map.inverse(map.position(X)) - X).norm(), 1e-12);
}

// sin(k xi) = sum over odd n of +- (2n + 1) j_n(k) P_n(xi) (Abramowitz & Stegun 10.1.47): the best fit of degree d
// leaves what is above d. Gauss points integrate all products here exactly or, of sines, to rounding.
TEST(RegressionVerification, ResidualOfASineByDegree) {
  constexpr double k = 3;
  const Samples s = gauss_points(slender, {16, 9, 9});
  const Field sine = [](const Vector3d& X) { return Vector3d(0, std::sin(k * X[0]), 0); };
  const Regression fit = regress(Monomials(8, {0, 0, 0}, slender), s.X, s.w, modes(s.X, {sine}));
  const double whole = 0.5 * (1 - std::sin(2 * k) / (2 * k));
  double worst = 0;
  for (int d = 0; d <= 8; ++d) {
    double left = 0;
    for (unsigned n = 41; n > static_cast<unsigned>(d); n -= 1)
      if (n % 2 == 1) left += (2 * n + 1) * std::pow(std::sph_bessel(n, k), 2);
    EXPECT_NEAR(fit.modes[0].residual_by_degree[d], std::sqrt(left / whole), 1e-13) << d;
    worst = std::max(std::abs(fit.modes[0].residual_by_degree[d] - std::sqrt(left / whole)), worst);
  }
  EXPECT_EQ(fit.modes[0].n_kept, 4);  // xi, xi^3, xi^5, xi^7 of 495: symmetry leaves nothing else
  EXPECT_EQ(fit.modes[0].degree, 7);
  EXPECT_NEAR(fit.modes[0].residual, fit.modes[0].residual_by_degree[8], 1e-10);  // as much as `drop` may change
  expect_verified({.quantity = "what fits of degrees 0 to 8 leave of a sine along a bar, over its root mean square",
                   .reference = "exact solution",
                   .source = "Legendre series of sin(3 x) (Abramowitz and Stegun 1964, 10.1.47)",
                   .uncertainty = "rounding; the series is cut at n = 41",
                   .tolerance = 1e-13,
                   .why = "Rounding of the fit; 16 Gauss points integrate the products of sines to rounding."},
                  worst);
}

// On a quadric Q = 0 the multiples of Q vanish: of the polynomials of degree d there remain (d + 3 over 3) less
// (d + 1 over 3), that is (d + 1)^2; on a plane those in two variables; never more than there are points.
TEST(RegressionVerification, RankOfDegeneratePointSets) {
  const Samples sphere = sphere_points(600);
  Samples cylinder = sphere, plane = sphere;
  for (Index i = 0; i < sphere.X.cols(); ++i) cylinder.X.col(i).head<2>().normalize();
  plane.X.row(2).setConstant(0.123);
  const MatrixXd U = modes(sphere.X, waves);
  for (int d = 0; d <= 8; ++d) {
    const auto rank = [&](const Samples& s) { return regress(monomials_about(s.X, d), s.X, s.w, U).rank; };
    EXPECT_EQ(rank(sphere), (d + 1) * (d + 1));
    EXPECT_EQ(rank(cylinder), (d + 1) * (d + 1));
    EXPECT_EQ(rank(plane), (d + 1) * (d + 2) / 2);
  }
  const Samples few = scattered({0, 0, 0}, ones, 7);
  const Regression fit = regress(Monomials(3, {0, 0, 0}, ones), few.X, few.w, modes(few.X, waves));
  EXPECT_EQ(fit.rank, 7);
  EXPECT_EQ(fit.n_monomials, 20);
  for (const ModeFit& mode : fit.modes) EXPECT_LT(mode.residual, 1e-10);  // 7 values by 7 monomials; dropped: 1e-10
}

TEST(RegressionVerification, DependentMonomialsAreSettledForTheLowestDegree) {
  const Samples s = sphere_points(400);
  const Field radius = [](const Vector3d& X) { return Vector3d(X.squaredNorm(), X[2] * X[2], 0); };
  const Regression fit = regress(Monomials(4, {0, 0, 0}, ones), s.X, s.w, modes(s.X, {radius}));
  EXPECT_LT(fit.modes[0].residual, 1e-12);
  EXPECT_LT(fit.condition, 1e3);
  // x^2 + y^2 + z^2 = 1 is found as the constant, z^2 as 1 - x^2 - y^2: 4 coefficients.
  EXPECT_EQ(fit.modes[0].n_kept, 4);
  EXPECT_NEAR(fit.basis.coefficients()(0, 0), 1, 1e-12);
  EXPECT_NEAR(fit.basis.coefficients()(1, 0), 1, 1e-12);
  EXPECT_NEAR(fit.basis.coefficients()(3 * monomial_index(2, 0, 0) + 1, 0), -1, 1e-12);
  EXPECT_NEAR(fit.basis.coefficients()(3 * monomial_index(0, 2, 0) + 1, 0), -1, 1e-12);
}

}  // namespace
}  // namespace mb
