// Uncoupled unit masses of given frequencies: a reduced system, for tests.
#pragma once

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

}  // namespace mb::test
