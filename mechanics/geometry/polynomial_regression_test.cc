#include "mechanics/geometry/polynomial_regression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "mechanics/geometry/gauss.h"

namespace mb {
namespace {

using Field = std::function<Vector3d(const Vector3d& X)>;

struct Samples {
  Matrix3Xd X;
  VectorXd w;
};

MatrixXd modes(const Matrix3Xd& X, const std::vector<Field>& fields) {
  MatrixXd U(3 * X.cols(), static_cast<Index>(fields.size()));
  for (Index j = 0; j < U.cols(); ++j)
    for (Index i = 0; i < X.cols(); ++i) U.block<3, 1>(3 * i, j) = fields[static_cast<size_t>(j)](X.col(i));
  return U;
}

// Random points in the box with random weights: nothing about them is symmetric.
Samples scattered(const Vector3d& centre, const Vector3d& half, Index n) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Samples s{Matrix3Xd(3, n), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    for (Index a = 0; a < 3; ++a) s.X(a, i) = centre[a] + half[a] * uniform(generator);
    s.w[i] = 1.5 + uniform(generator);
  }
  return s;
}

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

// Evenly spread over the unit sphere (Fibonacci spiral).
Samples sphere_points(Index n) {
  Samples s{Matrix3Xd(3, n), VectorXd::Ones(n)};
  for (Index i = 0; i < n; ++i) {
    const double z = (2 * static_cast<double>(i) + 1) / static_cast<double>(n) - 1, r = std::sqrt(1 - z * z);
    const double angle = pi * (3 - std::sqrt(5)) * static_cast<double>(i);
    s.X.col(i) = Vector3d(r * std::cos(angle), r * std::sin(angle), z);
  }
  return s;
}

Field wave(const Vector3d& k, const Vector3d& amplitude) {
  return [=](const Vector3d& X) { return Vector3d(amplitude * std::sin(k.dot(X) + 0.3)); };
}

const std::vector<Field> waves = {wave({1, 0.4, 0.2}, {1, 2, 3}), wave({2, -1, 1}, {0, 1, 0}),
                                  wave({0.3, 2.5, -1}, {1e-6, 1e-6, 0})};

const Vector3d slender(1, 0.02, 0.05), ones(1, 1, 1);

TEST(RegressionVerification, PolynomialsAreReproduced) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
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
        EXPECT_LT((fit.basis.coefficients() - a.col(0)).norm(), 1e-15 * fit.condition * a.col(0).norm());
        EXPECT_EQ(fit.modes[0].n_kept, 3 * n_monomials(degree));
      }
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
  for (int d = 0; d <= 8; ++d) {
    double left = 0;
    for (unsigned n = 41; n > static_cast<unsigned>(d); n -= 1)
      if (n % 2 == 1) left += (2 * n + 1) * std::pow(std::sph_bessel(n, k), 2);
    EXPECT_NEAR(fit.modes[0].residual_by_degree[d], std::sqrt(left / whole), 1e-13) << d;
  }
  EXPECT_EQ(fit.modes[0].n_kept, 4);  // xi, xi^3, xi^5, xi^7 of 495: symmetry leaves nothing else
  EXPECT_EQ(fit.modes[0].degree, 7);
  EXPECT_NEAR(fit.modes[0].residual, fit.modes[0].residual_by_degree[8], 1e-10);  // as much as `drop` may change
}

TEST(Regression, ResidualFallsWithDegreeAndIsOrthogonalToTheMonomials) {
  const Samples s = scattered({1, 2, 3}, ones, 500);
  const MatrixXd U = modes(s.X, waves);
  const Regression all = regress(Monomials(8, {1, 2, 3}, ones), s.X, s.w, U, {.drop = 0});
  for (int degree = 0; degree <= 8; ++degree) {
    const Monomials m(degree, {1, 2, 3}, ones);
    const Regression fit = regress(m, s.X, s.w, U, {.drop = 0});
    const MatrixXd left = U - fit.basis.at(s.X), B = m.values(s.X);
    for (Index j = 0; j < U.cols(); ++j) {
      const ModeFit& mode = fit.modes[static_cast<size_t>(j)];
      const VectorXd& by_degree = all.modes[static_cast<size_t>(j)].residual_by_degree;
      EXPECT_NEAR(mode.residual, by_degree[degree], 1e-13);
      if (degree > 0) {
        EXPECT_LT(mode.residual, by_degree[degree - 1]);
      }
      for (Index a = 0; a < 3; ++a) {
        const VectorXd r = left(Eigen::seqN(a, s.X.cols(), 3), j);
        EXPECT_LT((B.transpose() * s.w.cwiseProduct(r)).norm(), 1e-13 * s.w.sum() * U.col(j).cwiseAbs().maxCoeff());
      }
    }
  }
  EXPECT_LT(all.modes[0].residual, 1e-6);  // 1.6^9 / (2^8 9!) of sin(k.X), |k|_1 = 1.6: the Chebyshev remainder
}

// Polynomials of degree d span (d+1)^2 dimensions on a quadric, (d+1)(d+2)/2 on a plane and never more than there are
// points (harmonic ones up to degree d; Stein & Weiss 1971, section IV.2).
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

// A shell between radii 1 - t and 1 tells r^2 from 1 by t only: above the tolerance all 10 monomials count.
TEST(Regression, ThinShellsKeepTheirRankUntilRounding) {
  const auto shell = [](double t) {
    Samples s = sphere_points(400);
    for (Index i = 0; i < 400; i += 2) s.X.col(i) *= 1 - t;
    return regress(Monomials(2, {0, 0, 0}, ones), s.X, s.w, modes(s.X, waves));
  };
  EXPECT_EQ(shell(1e-3).rank, 10);
  EXPECT_EQ(shell(1e-6).rank, 10);
  EXPECT_EQ(shell(1e-10).rank, 9);
  EXPECT_NEAR(std::log10(shell(1e-6).condition / shell(1e-3).condition), 3, 0.1);  // and the condition number says so
  EXPECT_LT(shell(1e-10).condition, 10);
}

TEST(Regression, DroppedCoefficientsChangeTheModeByLessThanAllowed) {
  const Samples s = scattered({0, 0, 0}, ones, 500), others = scattered({0, 0, 0}, ones, 2000);
  const MatrixXd U = modes(s.X, waves);
  const Monomials m(6, {0, 0, 0}, ones);
  const Regression whole = regress(m, s.X, s.w, U, {.drop = 0});
  Index last = 3 * m.size() + 1;
  for (const double drop : {1e-6, 1e-4, 1e-2}) {
    const Regression fit = regress(m, s.X, s.w, U, {.drop = drop});
    const MatrixXd change = fit.basis.at(others.X) - whole.basis.at(others.X);
    for (Index j = 0; j < U.cols(); ++j) {
      const VectorXd norm2 = Eigen::Map<const Matrix3Xd>(U.col(j).data(), 3, s.X.cols()).colwise().squaredNorm();
      const double rms = std::sqrt(s.w.dot(norm2) / s.w.sum());
      const double most = Eigen::Map<const Matrix3Xd>(change.col(j).data(), 3, 2000).colwise().norm().maxCoeff();
      EXPECT_LE(most, drop * rms * (1 + 1e-12) + 1e-15);
    }
    EXPECT_LT(fit.modes[0].n_kept, last);
    last = fit.modes[0].n_kept;
  }
}

TEST(Regression, DoesNotDependOnUnits) {
  const Samples s = scattered({0, 0, 0}, slender, 300);
  const MatrixXd U = modes(s.X, waves);
  const Regression fit = regress(Monomials(4, {0, 0, 0}, slender), s.X, s.w, U);
  const Regression other =
      regress(Monomials(4, {0, 0, 0}, 1e3 * slender), 1e3 * s.X, 1e-250 * s.w, 1e-200 * U);  // mm, 1e-250 m^3
  EXPECT_NEAR(other.condition, fit.condition, 1e-10 * fit.condition);
  for (size_t j = 0; j < fit.modes.size(); ++j) {
    EXPECT_NEAR(other.modes[j].residual, fit.modes[j].residual, 1e-13);
    EXPECT_NEAR(other.modes[j].largest_residual, fit.modes[j].largest_residual, 1e-13);
    EXPECT_EQ(other.modes[j].n_kept, fit.modes[j].n_kept);
  }
}

TEST(PolynomialBasis, ObservationsTimesCoordinatesAreTheMap) {
  const Samples s = scattered({0, 0, 0}, slender, 300);
  const PolynomialBasis basis = regress(Monomials(4, {0, 0, 0}, slender), s.X, s.w, modes(s.X, waves)).basis;
  const VectorXd q = Vector3d(0.2, -0.1, 1e5);
  const VectorXd observed = basis.at(s.X) * q;
  const Matrix3Xd u = basis.map(q).positions(s.X) - s.X;
  EXPECT_LT((observed - u.reshaped()).norm(), 1e-14 * static_cast<double>(s.X.cols()));
  EXPECT_EQ(basis.map(VectorXd::Zero(3)).position({0.1, 0.2, 0.3}), Vector3d(0.1, 0.2, 0.3));
}

TEST(Regression, ModesThatVanishAndNoModes) {
  const Samples s = scattered({0, 0, 0}, ones, 50);
  const Monomials m(2, {0, 0, 0}, ones);
  const Regression fit = regress(m, s.X, s.w, MatrixXd::Zero(150, 1));
  EXPECT_EQ(fit.modes[0].residual, 0);
  EXPECT_EQ(fit.modes[0].largest_residual, 0);
  EXPECT_EQ(fit.modes[0].n_kept, 0);
  EXPECT_EQ(fit.modes[0].residual_by_degree, VectorXd::Zero(3));
  const Regression none = regress(m, s.X, s.w, MatrixXd(150, 0));
  EXPECT_EQ(none.basis.size(), 0);
  EXPECT_EQ(none.basis.map(VectorXd(0)).position({1, 2, 3}), Vector3d(1, 2, 3));
}

TEST(Regression, BadInputIsRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Samples s = scattered({0, 0, 0}, ones, 20);
  const Monomials m(1, {0, 0, 0}, ones);
  const MatrixXd U = modes(s.X, waves);
  const auto refused = [&](const Matrix3Xd& X, const VectorXd& w, const MatrixXd& phi, RegressionTolerances t = {}) {
    EXPECT_THROW(regress(m, X, w, phi, t), std::invalid_argument);
  };
  refused(s.X, s.w.head(19), U);
  refused(s.X, s.w, U.topRows(59));
  refused(Matrix3Xd(3, 0), VectorXd(0), MatrixXd(0, 2));
  refused(s.X, VectorXd::Zero(20), U);
  refused(2.5 * s.X, s.w, U);  // outside |xi| <= 2
  refused(s.X, s.w, U, {.rank = -1});
  refused(s.X, s.w, U, {.rank = 1});
  refused(s.X, s.w, U, {.rank = nan});
  refused(s.X, s.w, U, {.drop = nan});
  for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
    Samples t = s;
    t.X(1, 3) = bad;
    refused(t.X, t.w, U);
    t = s;
    t.w[4] = bad;
    refused(t.X, t.w, U);
    MatrixXd V = U;
    V(17, 2) = bad;
    refused(s.X, s.w, V);
  }
  VectorXd w = s.w;
  w[2] = -1;
  refused(s.X, w, U);
  const PolynomialBasis basis = regress(m, s.X, s.w, U).basis;
  EXPECT_THROW(basis.map(VectorXd::Zero(2)), std::invalid_argument);
  EXPECT_THROW(basis.map(Vector3d(0, nan, 0)), std::invalid_argument);
  EXPECT_THROW(basis.at(Vector3d(0, nan, 0)), std::invalid_argument);
  EXPECT_THROW(PolynomialBasis(m, MatrixXd::Zero(11, 1)), std::invalid_argument);
  EXPECT_THROW(PolynomialBasis(m, MatrixXd::Constant(12, 1, nan)), std::invalid_argument);
}

}  // namespace
}  // namespace mb
