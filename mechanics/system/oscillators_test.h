// Systems that explicit schemes can take, for tests: unit masses of given frequencies, and a small free box.
#pragma once

#include "mechanics/algebra/box_test_system.h"
#include "mechanics/system/system.h"

namespace mb::test {

// lumped: with the mass matrix as the lumped one, too.
inline System oscillators(const VectorXd& omega, const Rayleigh& damping, bool lumped = false) {
  const Index n = omega.size();
  System system;
  system.M = SparseMatrix(VectorXd::Ones(n).asDiagonal());
  system.K = SparseMatrix(VectorXd(omega.array().square()).asDiagonal());
  if (lumped) system.lumped_mass = system.M;
  system.damping = damping;
  system.modal_damping.W.resize(n, 0);
  system.R.resize(n, 0);
  system.F.resize(n, 0);
  system.u0 = system.v0 = VectorXd::Zero(n);
  return system;
}

// A free box of 0.1 x 0.1 x 0.2 m with the row sums of M as its lumped mass.
inline System lumped_box(const Rayleigh& damping) {
  System system =
      testing::box_system({.cells = {2, 2, 3}, .size = {0.1, 0.1, 0.2}, .E = 2e4, .nu = 0.3, .rho = 1100}).system;
  system.damping = damping;
  system.modal_damping.W.resize(system.M.rows(), 0);
  system.lumped_mass = SparseMatrix(VectorXd(system.M * VectorXd::Ones(system.M.rows())).asDiagonal());
  return system;
}

}  // namespace mb::test
