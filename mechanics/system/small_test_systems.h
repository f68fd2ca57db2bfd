// For tests: a small elastic box under loads, with every kind of damping, and the same in modal coordinates.
#pragma once

#include <algorithm>

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/algebra/noise.h"
#include "mechanics/system/modal_form.h"

namespace mb::testing {

// Elements of the box: 1 x 1 x 2 of degree 1, E = rho = 1. A free one has 36 degrees of freedom and omega from 0.9 to
// 12 rad/s, about.
inline System small_box(bool is_clamped) {
  BoxMesh mesh{.cells = {1, 1, 2}, .size = {1, 1.1, 2.3}};
  if (is_clamped) mesh.fixed = [](const Vector3d& x, int) { return x[2] == 0; };
  System system = box_system(mesh).system;
  const Index n = system.M.rows();
  system.F.resize(n, 2);
  system.F << 0.1 * uniform_noise(n, 3), 0.1 * uniform_noise(n, 4);
  system.s = {Pulse{3}, Harmonic{1.7}};
  system.u0 = 0.1 * uniform_noise(n, 5);
  system.v0 = 0.1 * uniform_noise(n, 6);
  return system;
}

// Three elastic modes with ratios of their own; the second one's Rayleigh damping is taken back.
inline System with_all_damping(System system) {
  const ModalForm form = modal_form(system);
  const Index first = system.R.cols();
  system.damping = {0.05, 0.004};
  system.modal_damping.W = system.M * form.Phi.middleCols(first, 3);
  system.modal_damping.d = VectorXd{{0.1, -(0.05 + 0.004 * form.lambda[first + 1]), 0.2}};
  return system;
}

inline System lumped(System system) {
  const VectorXd row_sums = system.M * VectorXd::Ones(system.M.cols());
  system.lumped_mass = row_sums.asDiagonal().toDenseMatrix().sparseView();
  return system;
}

// The same motion in coordinates q, u = Phi q: M = I, K diagonal, R and W columns of one entry each.
inline System in_modal_coordinates(const System& system, const ModalForm& form) {
  const Index n = form.lambda.size();
  const auto diagonal = [n](const VectorXd& entries) {
    SparseMatrix A(n, n);
    for (Index i = 0; i < n; ++i) A.insert(i, i) = entries[i];
    return A;
  };
  System reduced;
  reduced.M = diagonal(VectorXd::Ones(n));
  reduced.K = diagonal(form.lambda);
  reduced.damping = system.damping;
  const auto entries_only = [](const MatrixXd& A) -> MatrixXd { return (A.array().abs() > 1e-10).select(A, 0); };
  reduced.R = entries_only(form.Phi.transpose() * (system.M * system.R));
  reduced.modal_damping = {entries_only(form.Phi.transpose() * system.modal_damping.W), system.modal_damping.d};
  reduced.F = form.Phi.transpose() * system.F;
  reduced.s = system.s;
  reduced.u0 = form.Phi.transpose() * (system.M * system.u0);
  reduced.v0 = form.Phi.transpose() * (system.M * system.v0);
  return reduced;
}

inline double largest_omega(const System& system) { return std::sqrt(modal_form(system).lambda.maxCoeff()); }

// Relative, of displacements and velocities together.
inline double distance(const States& a, const States& b) {
  return std::max((a.u - b.u).norm() / b.u.norm(), (a.v - b.v).norm() / b.v.norm());
}

}  // namespace mb::testing
