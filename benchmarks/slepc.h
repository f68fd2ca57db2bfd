// SLEPc's Krylov-Schur with MUMPS on the pencil K phi = lambda M phi, shift-inverted at sigma (the door of SLEPc).
#pragma once

#include "mechanics/types.h"

namespace mb {

// While it lives SLEPc may be called; once a process.
class SlepcSession {
 public:
  SlepcSession(int* argc, char*** argv);
  ~SlepcSession();
  SlepcSession(const SlepcSession&) = delete;
  SlepcSession& operator=(const SlepcSession&) = delete;

  // The n_wanted eigenvalues [1/s^2] nearest to sigma, ascending, with their vectors computed; tolerance [-] on the
  // residual. Throws std::runtime_error where it does not converge.
  VectorXd nearest(const SparseMatrix& K, const SparseMatrix& M, int n_wanted, double sigma, double tolerance) const;
};

bool has_slepc();  // whether the program was built with it; else a session does nothing and nearest() throws

}  // namespace mb
