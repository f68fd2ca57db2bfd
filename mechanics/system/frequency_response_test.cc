#include "mechanics/system/frequency_response.h"
#include "mechanics/algebra/dense_eigen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace mb {
namespace {

using Eigen::MatrixXcd;

MatrixXd random_matrix(Index rows, Index cols, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  return MatrixXd::NullaryExpr(rows, cols, [&] { return entry(random); });
}

// Bars of density 1.5 and stiffness 8 in a row, free at both ends or held at the first: consistent mass.
System chain(Index n, bool is_free) {
  std::vector<Eigen::Triplet<double>> M, K;
  const Index held = is_free ? 0 : 1;
  for (Index e = 0; e + 1 < n + held; ++e)
    for (Index a = 0; a < 2; ++a)
      for (Index b = 0; b < 2; ++b) {
        const Index row = e + a - held, column = e + b - held;
        if (row < 0 || column < 0) continue;
        M.emplace_back(row, column, a == b ? 0.5 : 0.25);
        K.emplace_back(row, column, a == b ? 8 : -8);
      }
  System system;
  system.M.resize(n, n), system.K.resize(n, n);
  system.M.setFromTriplets(M.begin(), M.end());
  system.K.setFromTriplets(K.begin(), K.end());
  system.R = is_free ? MatrixXd::Constant(n, 1, 1 / std::sqrt(system.M.sum())) : MatrixXd(n, 0);
  system.F = random_matrix(n, 2, 3);
  system.s = {Step{}, Step{}};
  system.u0 = system.v0 = VectorXd::Zero(n);
  return system;
}

struct Spectrum {
  VectorXd omega;
  MatrixXd Phi;
};
Spectrum spectrum(const System& system) {
  const EigenPairs eigen = generalized_eigen(MatrixXd(system.K), MatrixXd(system.M)).value();
  return {eigen.values.cwiseMax(0).cwiseSqrt(), eigen.vectors};
}

MatrixXcd dense_response(const System& system, Index load, const VectorXd& omega) {
  const Index n = system.M.rows();
  MatrixXd C(n, n);
  for (Index j = 0; j < n; ++j) C.col(j) = apply_damping(system, VectorXd::Unit(n, j));
  MatrixXcd u(n, omega.size());
  for (Index j = 0; j < omega.size(); ++j) {
    const MatrixXcd Z = MatrixXd(system.K) - omega[j] * omega[j] * MatrixXd(system.M) + Complex(0, omega[j]) * C;
    u.col(j) = Z.fullPivLu().solve(VectorXcd(system.F.col(load).cast<Complex>()));
  }
  return u;
}

double distance(const MatrixXcd& a, const MatrixXcd& b) { return (a - b).norm() / b.norm(); }

// All kinds of damping: Rayleigh's, ratios of two elastic modes (one asking for less than Rayleigh's), none.
std::vector<System> damped(const System& undamped) {
  std::vector<System> systems(5, undamped);
  const Index first = undamped.R.cols();
  const MatrixXd W = undamped.M * spectrum(undamped).Phi.middleCols(first, 3);
  systems[1].damping = {0.3, 0};
  systems[2].damping = {0.4, 0.05};
  systems[3].modal_damping = {W, Eigen::Vector3d(0.1, 0, 0.3)};
  systems[4].damping = {0.4, 0.05};
  systems[4].modal_damping = {W, Eigen::Vector3d(0.2, -0.3, 0.5)};
  return systems;
}

TEST(FrequencyResponseTest, MatchesDenseSolve) {
  const VectorXd omega = VectorXd::LinSpaced(30, 0.1, 12.3);
  for (const bool is_free : {false, true})
    for (const System& system : damped(chain(9, is_free)))
      for (const Index load : {0, 1})  // the dense matrix loses three digits near an undamped resonance
        EXPECT_LT(distance(frequency_response(system, load, omega), dense_response(system, load, omega)), 1e-11);
}

TEST(FrequencyResponseTest, DampingOfLowRankNeedsNoModes) {
  System system = chain(12, false);
  system.modal_damping = {random_matrix(12, 4, 5), Eigen::Vector4d(0.3, 2, 0.1, 0.7)};
  const VectorXd omega = VectorXd::LinSpaced(20, 0.1, 9);
  EXPECT_LT(distance(frequency_response(system, 0, omega), dense_response(system, 0, omega)), 1e-12);
}

TEST(FrequencyResponseTest, DiagonalMatchesClosedFormOfOneMode) {
  const double k = 40, m = 2.5, alpha = 0.2, beta = 0.003, d = 0.5;
  System system;
  system.M = MatrixXd::Constant(1, 1, m).sparseView();
  system.K = MatrixXd::Constant(1, 1, k).sparseView();
  system.damping = {alpha, beta};
  system.modal_damping = {MatrixXd::Constant(1, 1, std::sqrt(m)), VectorXd::Constant(1, d)};
  system.R.resize(1, 0);
  system.F = MatrixXd::Constant(1, 1, 7.0);
  system.s = {Step{}};
  system.u0 = system.v0 = VectorXd::Zero(1);
  const VectorXd omega = VectorXd::LinSpaced(41, 0.5, 20.5);
  const MatrixXcd u = frequency_response(system, 0, omega);
  const double omega0 = std::sqrt(k / m), zeta = (alpha + beta * omega0 * omega0 + d) / (2 * omega0);
  for (Index j = 0; j < omega.size(); ++j) {
    const double x = omega[j] / omega0, amplitude = 7 / k / std::hypot(1 - x * x, 2 * zeta * x);
    EXPECT_NEAR(std::abs(u(0, j)), amplitude, 1e-13 * amplitude);
    EXPECT_NEAR(std::arg(u(0, j)), -std::atan2(2 * zeta * x, 1 - x * x), 1e-13);
  }
}

TEST(FrequencyResponseTest, ReducedSystemAnswersAsTheFullOne) {
  for (const bool is_free : {false, true})
    for (const System& full : damped(chain(8, is_free))) {
      const auto [frequencies, Phi] = spectrum(full);
      System modal = full;
      modal.M.setIdentity();
      modal.K = MatrixXd(frequencies.cwiseAbs2().asDiagonal()).sparseView();
      if (is_free) {
        modal.K.coeffRef(0, 0) = 0;
        modal.K.prune(0.0);
        modal.R = VectorXd::Unit(8, 0);
      }
      modal.F = Phi.transpose() * full.F;
      if (full.modal_damping.d.size() > 0)
        modal.modal_damping.W = MatrixXd::Identity(8, 8).middleCols(is_free ? 1 : 0, 3);
      const VectorXd omega = VectorXd::LinSpaced(15, 0.3, 7);
      const MatrixXcd expected = frequency_response(full, 1, omega);
      EXPECT_LT(distance(Phi * frequency_response(modal, 1, omega), expected), 1e-11);
      if (full.modal_damping.d.size() == 0) continue;
      modal.modal_damping.W = Phi.transpose() * full.modal_damping.W;  // with rounding off its diagonal
      EXPECT_LT(distance(Phi * frequency_response(modal, 1, omega), expected), 1e-11);
    }
}

// A rigid body: F / (-omega^2 m), whatever alpha, and at frequencies where K - omega^2 M has a pivot of 1e-13.
TEST(FrequencyResponseTest, FreeBodyMovesAsAWhole) {
  System system = chain(7, true);
  system.F.col(0) = system.M * VectorXd::Ones(7);  // accelerates without strain
  const double mass = system.M.sum();
  for (const Rayleigh damping : {Rayleigh{}, Rayleigh{2, 0.1}}) {
    system.damping = damping;
    const VectorXd omega = Eigen::Vector3d(1e-6, 0.7, 3);
    const MatrixXcd u = frequency_response(system, 0, omega);
    for (Index j = 0; j < omega.size(); ++j) {
      const double expected = -mass / (omega[j] * omega[j] * mass);
      for (Index row = 0; row < 7; ++row) EXPECT_LT(std::abs(u(row, j) - expected), 1e-13 * std::abs(expected));
    }
  }
}

// [rad/s] Of mode k from 0, rigid motion of a free chain included: as exact as cosines.
double frequency_of_chain(Index n, bool is_free, Index k) {
  const auto x = static_cast<double>(k), all = static_cast<double>(n);
  const double theta = is_free ? pi * x / (all - 1) : pi * (x + 0.5) / all;
  return 8 * std::sin(theta / 2) / std::sqrt(2 + std::cos(theta));
}

// The smallest pivot says less of a long chain, whose modes have a little of every unknown: of 3000 it is 3e-14 to
// 9e-12 of the largest at these resonances, of ten below 5e-15.
TEST(FrequencyResponseTest, UndampedResonanceIsRefusedWhateverTheSize) {
  for (const bool is_free : {false, true})
    for (const Index n : {10, 300, 3000})
      for (const Index k : {1, 2, 5}) {
        const double omega = frequency_of_chain(n, is_free, k);
        EXPECT_THROW(frequency_response(chain(n, is_free), 0, VectorXd::Constant(1, omega)), std::runtime_error)
            << n << " " << k << is_free;
        EXPECT_TRUE(frequency_response(chain(n, is_free), 0, VectorXd::Constant(1, 1.001 * omega)).allFinite());
      }
}

// Where a mode is damped by its ratio alone, K - omega^2 M is singular at its resonance; the response is not.
TEST(FrequencyResponseTest, ResonanceOfAModeWithARatio) {
  for (const bool is_free : {false, true}) {
    System system = chain(10, is_free);
    const auto [frequencies, Phi] = spectrum(system);
    const Index mode = system.R.cols() + 1;
    const double omega = frequency_of_chain(10, is_free, mode), zeta = 0.02;
    EXPECT_NEAR(frequencies[mode], omega, 1e-12 * omega);
    const VectorXd phi = Phi.col(mode), omegas = VectorXd::Constant(1, omega);
    system.F.col(0) = system.M * phi;
    EXPECT_THROW(frequency_response(system, 0, omegas), std::runtime_error);
    system.modal_damping = {system.M * phi, VectorXd::Constant(1, 2 * zeta * omega)};
    const VectorXcd expected = phi / Complex(0, 2 * zeta * omega * omega);
    EXPECT_LT(distance(frequency_response(system, 0, omegas), expected), 1e-11);
  }
}

TEST(FrequencyResponseTest, UndampedResonanceOfDiagonalSystem) {
  System system = chain(3, false);
  system.M.setIdentity();
  system.K = MatrixXd(Eigen::Vector3d(1.3, 5.7, 11.1).asDiagonal()).sparseView();
  for (const double k : {1.3, 5.7, 11.1})
    EXPECT_THROW(frequency_response(system, 0, VectorXd::Constant(1, std::sqrt(k))), std::runtime_error);
  EXPECT_TRUE(frequency_response(system, 0, VectorXd::Constant(1, 1.0001 * std::sqrt(5.7))).allFinite());
}

TEST(FrequencyResponseTest, LargeSystemsStaySparse) {  // dense blocks would take 6 GB
  const Index n = 20000;
  System system = chain(n, true);
  system.damping = {0.1, 1e-3};
  system.modal_damping = {system.M * (VectorXd::LinSpaced(n, 0, pi).array().cos()).matrix() * std::sqrt(2 / (0.75 * n)),
                          VectorXd::Constant(1, 0.2)};
  system.modal_damping.W -= system.M * system.R * (system.R.transpose() * system.modal_damping.W);
  const VectorXd omega = Eigen::Vector2d(0.01, 0.5), v = random_matrix(n, 1, 9);
  const MatrixXcd u = frequency_response(system, 0, omega);
  for (Index j = 0; j < 2; ++j) {  // the residual, by C as every integrator applies it
    const VectorXd re = u.col(j).real(), im = u.col(j).imag();
    const double w = omega[j];
    const VectorXd r1 = system.K * re - w * w * (system.M * re) - w * apply_damping(system, im) - system.F.col(0);
    const VectorXd r2 = system.K * im - w * w * (system.M * im) + w * apply_damping(system, re);
    EXPECT_LT(std::hypot(r1.norm(), r2.norm()), 1e-10 * 32 * u.col(j).norm());  // |K| = 32
  }
}

TEST(FrequencyResponseTest, BadInput) {
  System system = chain(4, true);
  const VectorXd omega = VectorXd::Ones(1);
  EXPECT_EQ(frequency_response(system, 0, VectorXd()).cols(), 0);
  for (const Index load : {-1, 2}) EXPECT_THROW(frequency_response(system, load, omega), std::invalid_argument);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(frequency_response(system, 0, VectorXd::Constant(1, bad)), std::invalid_argument);
  system.modal_damping = {system.M * system.R, VectorXd::Ones(1)};  // would brake rigid motion
  EXPECT_THROW(frequency_response(system, 0, omega), std::invalid_argument);
  system.modal_damping = {MatrixXd(3, 1), VectorXd::Ones(1)};
  EXPECT_THROW(frequency_response(system, 0, omega), std::invalid_argument);
}

}  // namespace
}  // namespace mb
