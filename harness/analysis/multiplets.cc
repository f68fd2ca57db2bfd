// The modes kept, by two solvers which share nothing but K and M: Lanczos iterations of ARPACK on the factor of
// K - sigma M, and a dense reduction to tridiagonal form. Multiplet by multiplet, since within one any basis will do:
//
//   distance = largest singular value of Phi_a - Phi_b Phi_b^T M Phi_a in the M norm: the sine of the largest angle
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"
#include "mechanics/system/modal_form.h"

namespace mb {

namespace {

constexpr Index largest_dense = 2500;  // [-] unknowns: ten seconds

Finding multiplets_table() {
  return table(
      "multiplets", "multiplets", "Modes by two solvers, multiplet by multiplet",
      "Elastic modes of the body's mesh whose eigenvalues differ by at most 1e-6 of themselves stand together. "
      "Lanczos iterations (ARPACK) beside a dense solver of the whole matrix. Gap: to the next eigenvalue "
      "above or below, relative. Subspace distance: sine of the largest angle between what the two solvers "
      "span, in the M norm; of the order of the residual over the gap.",
      {{"first mode", ""},
       {"multiplicity", ""},
       {"frequency", "Hz"},
       {"gap", "-"},
       {"difference of frequency", "-"},
       {"subspace distance", "-"},
       {"distance times gap", "-"}});
}

// n x n in the M norm: |L^T D|, M = L L^T, by the eigenvalues of D^T M D.
double largest_in_mass_norm(const SparseMatrix& M, const MatrixXd& D) {
  const MatrixXd squared = D.transpose() * (M * D);
  return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<MatrixXd>(squared).eigenvalues().maxCoeff()));
}

// [-] from the modes first ... first + n - 1 to their neighbours among all.
double gap(const VectorXd& lambda, Index first, Index n, Index n_rigid) {
  double least = std::numeric_limits<double>::infinity();
  if (first > n_rigid) least = 1 - lambda[first - 1] / lambda[first];
  if (first + n < lambda.size()) least = std::min(least, lambda[first + n] / lambda[first + n - 1] - 1);
  return least;
}

}  // namespace

std::vector<Finding> multiplets(const AnalysisContext& context) {
  const ModalBody body = modal_body(context, mode_counts(context).back());
  System undamped = body.system;
  if (undamped.M.rows() > largest_dense)
    throw std::invalid_argument(
        fmt::format("multiplets: {} unknowns, a dense solver takes at most {}", undamped.M.rows(), largest_dense));
  undamped.damping = {};
  undamped.modal_damping = {MatrixXd(undamped.M.rows(), 0), VectorXd(0)};
  const ModalForm dense = modal_form(undamped);
  const VectorXd lambda = body.modes.omega.cwiseAbs2();
  const Index n_rigid = body.modes.n_rigid;
  Finding found = multiplets_table();
  for (Index first = n_rigid, n = 1; first < lambda.size(); first += n) {
    for (n = 1; first + n < lambda.size(); ++n)
      if (lambda[first + n] - lambda[first + n - 1] > multiplet_gap * lambda[first + n]) break;
    const MatrixXd a = body.modes.Phi.middleCols(first, n), b = dense.Phi.middleCols(first, n);
    const VectorXd other = dense.lambda.segment(first, n).cwiseSqrt();
    const double difference = (body.modes.omega.segment(first, n) - other).cwiseAbs().maxCoeff() / other[0];
    const double distance = largest_in_mass_norm(undamped.M, a - b * (b.transpose() * (undamped.M * a)));
    const double apart = gap(dense.lambda, first, n, n_rigid);
    found.rows.push_back(
        {count(first - n_rigid + 1), count(n), other[0] / (2 * pi), apart, difference, distance, distance * apart});
  }
  return {found};
}

}  // namespace mb
