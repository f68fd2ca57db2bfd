// All modes of a small system by a dense solver:
//
//   K Phi = M Phi diag(lambda),   Phi^T M Phi = I,   Phi^T C Phi = diag(c)   or full
//
// with c = alpha + beta lambda, 0 for rigid modes, and what modal damping adds, phi^T W diag(d) W^T phi. The rigid
// modes are the system's own, R, with lambda exactly 0; the elastic ones are made M-orthogonal to them.
#pragma once

#include "mechanics/system/system.h"

namespace mb {

struct ModalForm {
  VectorXd lambda;  // [1/s^2] n, >= 0
  VectorXd c;       // [1/s] n, >= 0, the diagonal of Phi^T C Phi
  MatrixXd Phi;     // [kg^-1/2] n x n; 0 x 0 where M = I and K is diagonal to exact zeros: Phi is then the identity
  // [1/s] Phi^T C Phi where damping couples modes by more than 1e-8 of the larger of their coefficients; 0 x 0
  // elsewhere
  MatrixXd C = {};
};

// Throws std::invalid_argument where sizes disagree, M is not SPD, or a dense eigenproblem would exceed n = 6000;
// std::runtime_error where the eigenvalues that are zero to rounding are not as many as R has columns.
ModalForm modal_form(const System& system);

}  // namespace mb
