// Small systems of every kind that the closed form tells apart, for tests.
#pragma once

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "mechanics/system/system.h"

namespace mb {

inline MatrixXd random_matrix(Index rows, Index cols, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  return MatrixXd::NullaryExpr(rows, cols, [&] { return entry(random); });
}

inline VectorXd equally_spaced(double end, Index n) { return VectorXd::LinSpaced(n, 0, end); }

// Full M and K without rigid modes; omega below about 6 rad/s.
inline System supported(std::vector<History> loads, Rayleigh damping = {0.3, 0.02}) {
  const Index n = 4, n_loads = static_cast<Index>(loads.size());
  const MatrixXd A = random_matrix(n, n, 1), B = random_matrix(n, n, 2);
  const MatrixXd M = A * A.transpose() + MatrixXd::Identity(n, n), K = 9 * B * B.transpose() + MatrixXd::Identity(n, n);
  return {M.sparseView(),
          K.sparseView(),
          {},
          damping,
          {},
          MatrixXd(n, 0),
          random_matrix(n, n_loads, 3),
          std::move(loads),
          random_matrix(n, 1, 4),
          random_matrix(n, 1, 5)};
}

// The same, a dashpot between the ground and two unknowns: no modes of the undamped system are free of each other.
inline System braked(std::vector<History> loads, double damping = 0.7) {
  System system = supported(std::move(loads));
  system.modal_damping = {VectorXd{{1, 0, -0.5, 0}}, VectorXd::Constant(1, damping)};
  return system;
}

// A chain of masses and springs, free at both ends: one rigid mode, damped by alpha and beta in its deformation only.
inline System free_chain(std::vector<History> loads, Rayleigh damping = {0.5, 0.01}) {
  const Index n = 5, n_loads = static_cast<Index>(loads.size());
  MatrixXd M = MatrixXd::Zero(n, n), K = MatrixXd::Zero(n, n);
  for (Index i = 0; i + 1 < n; ++i) {  // consistent mass of a bar of density 1.5, stiffness 8
    M.block<2, 2>(i, i) += 1.5 / 6 * (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
    K.block<2, 2>(i, i) += 8 * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  }
  const MatrixXd R = MatrixXd::Constant(n, 1, 1 / std::sqrt(M.sum()));
  return {
      M.sparseView(),         K.sparseView(),        {}, damping, {}, R, random_matrix(n, n_loads, 6), std::move(loads),
      random_matrix(n, 1, 7), random_matrix(n, 1, 8)};
}

// M = I and diagonal K: two rigid modes at the end, beside 36 and 1 1/s^2.
inline System diagonal(std::vector<History> loads) {
  const Index n = 4, n_loads = static_cast<Index>(loads.size());
  SparseMatrix M(n, n), K(n, n);
  M.setIdentity();
  K.insert(0, 0) = 36;
  K.insert(1, 1) = 1;
  MatrixXd R = MatrixXd::Zero(n, 2);
  R(2, 0) = R(3, 1) = 1;
  return {M,
          K,
          {},
          {0.2, 0.001},
          {},
          R,
          random_matrix(n, n_loads, 9),
          std::move(loads),
          random_matrix(n, 1, 10),
          random_matrix(n, 1, 11)};
}

// Jumps, kinks and waves whose breakpoints interleave.
inline std::vector<History> all_exact_loads() {
  return {Step{1, 0.4}, Pulse{1.1, 2, 0.3}, Ramp{0.9, -1, 0.7}, Harmonic{3, 0.5, 1, 0.2},
          Table{{0.1, 0.5, 1.3, 1.4}, {1, -1, 2, 2}}};
}

}  // namespace mb
