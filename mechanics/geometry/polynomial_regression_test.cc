#include "mechanics/geometry/polynomial_regression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "mechanics/geometry/polynomial_test_samples.h"

namespace mb {
namespace {

using namespace testing;

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

// All signs and permutations of (1, 2, 3) and (0, 0, 1): x^2, y^2 and z^2 are equals, told apart by rounding alone. It
// must not decide which of them is left out, lest the fit inside differ from one machine to the next.
TEST(Regression, RoundingDoesNotDecideBetweenEquals) {
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> rounding(-1e-15, 1e-15);
  for (int trial = 0; trial < 20; ++trial) {
    Samples s{Matrix3Xd(3, 96), VectorXd::Ones(96)};
    for (Index i = 0; i < 96; ++i) {
      std::array<double, 3> x = i < 48 ? std::array{1., 2., 3.} : std::array{0., 0., 1.};
      for (Index p = 0; p < i % 6; ++p) std::next_permutation(x.begin(), x.end());
      for (Index a = 0; a < 3; ++a)
        s.X(a, i) = x[static_cast<size_t>(a)] * (i / 6 >> a & 1 ? -1 : 1) * (1 + rounding(generator));
      s.X.col(i) /= std::sqrt(i < 48 ? 14. : 1.);
    }
    const Field square = [](const Vector3d& X) { return Vector3d(X[0] * X[0], X[1] * X[1], X[2] * X[2]); };
    const Regression fit = regress(Monomials(2, {0, 0, 0}, ones), s.X, s.w, modes(s.X, {square}));
    EXPECT_EQ(fit.rank, 9);
    EXPECT_EQ(fit.modes[0].n_kept, 5);  // x^2, y^2, and 1 - x^2 - y^2 for z^2
    EXPECT_EQ(fit.basis.coefficients()(3 * monomial_index(0, 0, 2) + 2, 0), 0);
  }
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
