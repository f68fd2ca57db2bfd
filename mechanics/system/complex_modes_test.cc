#include "mechanics/system/complex_modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mechanics/system/exact.h"
#include "mechanics/system/exact_test_systems.h"
#include "mechanics/system/oscillator.h"

namespace mb {
namespace {

const VectorXd omega{{2, 3, 7}};  // [rad/s]

MatrixXd dashpot(double c) {
  const VectorXd w{{1, -0.6, 0.3}};
  return c * w * w.transpose();
}

TEST(ComplexModes, OfDampingThatDoesNotCoupleAreThoseOfTheRoots) {
  const VectorXd zeta{{0.01, 1.7, 0.3}};
  const ComplexModes modes = complex_modes(omega, MatrixXd((2 * zeta.cwiseProduct(omega)).asDiagonal()));
  const double fast = 3 * (1.7 + std::sqrt(1.7 * 1.7 - 1)), slow = 9 / fast;
  ASSERT_EQ(modes.mu.size(), 6);
  const std::complex<double> expected[] = {-slow,
                                           {-0.02, 2 * std::sqrt(1 - 1e-4)},
                                           {-0.02, -2 * std::sqrt(1 - 1e-4)},
                                           {-2.1, 7 * std::sqrt(1 - 0.09)},
                                           {-2.1, -7 * std::sqrt(1 - 0.09)},
                                           -fast};
  for (Index j = 0; j < 6; ++j) EXPECT_LT(std::abs(modes.mu[j] - expected[j]), 1e-13 * fast) << j;
}

TEST(ComplexModes, SolveTheQuadraticEigenproblem) {
  const MatrixXd C = dashpot(1.3) + MatrixXd((0.1 * omega).asDiagonal());
  const ComplexModes modes = complex_modes(omega, C);
  for (Index j = 0; j < 6; ++j) {
    const std::complex<double> mu = modes.mu[j];
    const Eigen::VectorXcd q = modes.X.col(j).head(3).cwiseQuotient(omega.cast<std::complex<double>>());
    const Eigen::VectorXcd r = mu * mu * q + mu * (C * q) + omega.cwiseAbs2().asDiagonal() * q;
    EXPECT_LT(r.norm(), 1e-12 * 49 * q.norm()) << j;  // eps times the largest coefficient
    EXPECT_LT(mu.real(), 0);
  }
  EXPECT_NEAR(modes.mu.sum().real(), -C.trace(), 1e-12);
  EXPECT_NEAR(complex_modes(omega, MatrixXd::Zero(3, 3)).condition, 1, 1e-12);
}

// Small damping shifts the roots by -c_ii/2, the coupling only in second order: its share falls with the damping.
TEST(ComplexModes, TendToTheDiagonalOfDampingAsItVanishes) {
  const auto off = [](double c) {
    const std::complex<double> lowest = complex_modes(omega, dashpot(c)).mu[0];
    return std::abs(lowest.real() + c / 2) / c;
  };
  EXPECT_LT(off(1e-3), 1e-3);
  EXPECT_NEAR(off(1e-2) / off(1e-3), 100, 5);  // odd orders alone are real: the next is c^3
}

TEST(ComplexModes, AreNamedWhereThereAreNone) {
  EXPECT_THROW(complex_modes(VectorXd{{0, 2}}, MatrixXd::Identity(2, 2)), std::invalid_argument);
  EXPECT_THROW(complex_modes(omega, MatrixXd::Identity(2, 2)), std::invalid_argument);
  EXPECT_THROW(complex_modes(VectorXd::LinSpaced(1001, 1, 2), MatrixXd::Identity(1001, 1001)), std::invalid_argument);
  EXPECT_THROW(complex_modes(omega, -MatrixXd::Identity(3, 3)), std::runtime_error);
  EXPECT_THROW(complex_modes(omega.head(1), 4 * MatrixXd::Identity(1, 1)), std::runtime_error) << "critical";
  EXPECT_NO_THROW(complex_modes(VectorXd(0), MatrixXd(0, 0)));
}

// Means against Simpson's rule over the states, windows before the start and across every breakpoint among them.
TEST(CoupledMotion, MeansAreIntegralsOfStates) {
  const System system = braked(all_exact_loads());
  const auto stepper = exact(system, 2.5);
  const VectorXd at = equally_spaced(2.3, 24);
  const double width = 0.4;
  const States means = stepper->averages(at, width);
  constexpr Index n = 4001;  // windows have jumps of v' within: Simpson's error h^2, 1e-8
  for (Index j = 0; j < at.size(); ++j) {
    const VectorXd t = VectorXd::LinSpaced(n, at[j] - width / 2, at[j] + width / 2);
    const Index n_before = (t.array() < 0).count();
    const States states = stepper->run(t.tail(n - n_before));
    VectorXd u = VectorXd::Zero(4), v = VectorXd::Zero(4);
    for (Index i = 0; i < n; ++i) {
      const double w = (i == 0 || i == n - 1 ? 1 : i % 2 == 1 ? 4 : 2) / 3.0 / static_cast<double>(n - 1);
      u += w * (i < n_before ? system.u0 : states.u.col(i - n_before));
      if (i >= n_before) v += w * states.v.col(i - n_before);
    }
    EXPECT_LT((means.u.col(j) - u).norm(), 1e-4 * u.norm()) << at[j];  // at t = 0 Simpson's rule meets a jump of v
    EXPECT_LT((means.v.col(j) - v).norm(), 1e-3 * (1 + v.norm())) << at[j];
    if (at[j] > width / 2) {
      EXPECT_LT((means.u.col(j) - u).norm(), 1e-7 * u.norm()) << at[j];
    }
  }
}

}  // namespace
}  // namespace mb
