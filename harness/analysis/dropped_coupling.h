// What it costs to keep the diagonal of Phi^T C Phi alone where damping couples modes:
//
//   error of dropping = |u_d - u| / |u|,   u: all of C, by complex modes; u_d: its diagonal; all times, M norm
//
// and whether complex modes in closed form and adaptive steps of the same system agree.
#pragma once

#include "cases/contract/method.h"

namespace mb {

MatrixXd damping_matrix(const System& reduced);  // [1/s] C, column by column
// [-] of every mode i the largest |C_ij| / sqrt(C_ii C_jj), i != j. Entries below 1e-13 of the largest one count as
// none: so much rounding of modes and products leaves of it in others. All NaN where an entry is not finite.
VectorXd couplings(const MatrixXd& damping);
double largest_coupling(const MatrixXd& damping);  // [-] of all modes

struct DroppedCoupling {
  double error;                      // [-] of dropping
  double closed_form_against_steps;  // [-]
};
// reduced: M = I, K diagonal. times [s] within the duration. Throws std::runtime_error naming the integrator where a
// run fails, std::invalid_argument where nothing moves.
DroppedCoupling dropped_coupling(const System& reduced, const MatrixXd& damping, const Integrator& closed_form,
                                 const Integrator& steps, const VectorXd& times, double duration,
                                 double load_tolerance);

}  // namespace mb
