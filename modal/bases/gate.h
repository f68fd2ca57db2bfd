// What modes must satisfy before anything is reported of them:
//
//   |K phi - lambda M phi| <= max(1e-8, 50 eps lambda_max/lambda) |lambda M phi|     every elastic mode
//   lambda >= 5000 eps lambda_max = 1.1e-12 lambda_max                               every elastic mode
//   |Phi^T M Phi - I|_max <= 1e-10
//   rigid: |K phi| <= max(1e-9, 50 eps lambda_max/lambda_1) lambda_1 |M phi|, hence |omega^2| as small
//   count: negative eigenvalues of K - mu M (Sylvester), mu in the middle of a spectral gap, = modes below mu
//
// Norms are Euclidean.
#pragma once

#include <stdexcept>

#include "cases/contract/modes.h"
#include "mechanics/system/system.h"

namespace mb {

// Vectors side by side, by rows: each entry of a sparse matrix then meets a row of all, not one number after another.
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// A basis that did not pass; what() names the mode, the figure and its bound.
class GateFailure : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Modes::residual of every column of Phi. omega: n_rigid zeros, then the elastic ones; without any there is no scale
// for the rigid ones, and theirs is NaN.
VectorXd residuals(const System& system, const MatrixXd& Phi, const VectorXd& omega, Index n_rigid);

// Throws GateFailure with the mode's number (from 1, rigid ones first), omega, figure and bound; std::invalid_argument
// where sizes do not fit. found: all modes known, at least one of them elastic, a few more than will be kept, so that
// the count has a gap to cut in: the first one at or above n_keep (rigid ones included) whose factor solves to 1e-8.
// Nothing is left to count where found is complete. residual is computed anew, not read.
void check_modes(const System& system, const Modes& found, Index n_keep);

}  // namespace mb
