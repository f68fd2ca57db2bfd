#include "mechanics/system/modal_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace mb {
namespace {

constexpr Index largest_dense = 6000;

void check_sizes(const System& system) {
  const Index n = system.M.rows();
  const bool square = system.M.cols() == n && system.K.rows() == n && system.K.cols() == n;
  const bool loads =
      system.F.cols() == static_cast<Index>(system.s.size()) && (system.s.empty() || system.F.rows() == n);
  const bool states = system.u0.size() == n && system.v0.size() == n;
  const bool rigid = system.R.cols() == 0 || (system.R.rows() == n && system.R.cols() <= n);
  if (!square || !loads || !states || !rigid)
    throw std::invalid_argument(fmt::format("system of {} unknowns: sizes of M, K, F, s, u0, v0, R disagree", n));
}

bool is_diagonal(const SparseMatrix& A) {
  for (Index j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(A, j); entry; ++entry)
      if (entry.row() != entry.col() && entry.value() != 0) return false;
  return true;
}

// Largest |lambda| of a rigid mode. Theory is 0, a dense solver leaves a few eps lambda_max; 1e-9 of the lowest elastic
// eigenvalue is a rigid mode whatever the solver. Throws where the number of rigid modes is not n_rigid.
double rigid_bound(VectorXd lambda, Index n_rigid) {
  if (lambda.size() == 0) return 0;
  std::sort(lambda.begin(), lambda.end());
  const double lowest_elastic = n_rigid < lambda.size() ? lambda[n_rigid] : 0;
  const double rounding = 50 * std::numeric_limits<double>::epsilon() * lambda.cwiseAbs().maxCoeff();
  const double bound = std::max(1e-9 * lowest_elastic, rounding);
  if (!(lambda[0] >= -bound))
    throw std::runtime_error(fmt::format("K is not semi-definite: eigenvalue {:.6g}", lambda[0]));
  const auto n_zero = (lambda.array() <= bound).count();
  if (n_zero != n_rigid)
    throw std::runtime_error(fmt::format(
        "{} eigenvalues are zero (|lambda| <= {:.3g}), but the system states {} rigid modes", n_zero, bound, n_rigid));
  return bound;
}

ModalForm of_eigenvalues(VectorXd lambda, MatrixXd Phi, const System& system) {
  const double bound = rigid_bound(lambda, system.R.cols());
  VectorXd c = VectorXd::Zero(lambda.size());
  for (Index i = 0; i < lambda.size(); ++i) {
    if (lambda[i] <= bound)
      lambda[i] = 0;
    else
      c[i] = system.damping.alpha + system.damping.beta * lambda[i];
  }
  return {std::move(lambda), std::move(c), std::move(Phi)};
}

ModalForm dense(const System& system) {
  const Index n = system.M.rows(), n_rigid = system.R.cols();
  if (n > largest_dense)
    throw std::invalid_argument(fmt::format("{} unknowns: a dense eigenproblem is limited to {}", n, largest_dense));
  const Eigen::LLT<MatrixXd> M(MatrixXd(system.M));
  if (M.info() != Eigen::Success) throw std::invalid_argument("the mass matrix is not positive definite");
  MatrixXd A = M.matrixL().solve(MatrixXd(system.K));  // L^-1 K L^-T, M = L L^T
  A = M.matrixL().solve(A.transpose()).eval();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) throw std::runtime_error("the dense eigensolver has not converged");
  MatrixXd Phi = M.matrixU().solve(solver.eigenvectors());
  if (n_rigid > 0) {
    Phi.leftCols(n_rigid) = system.R;
    auto elastic = Phi.rightCols(n - n_rigid);
    elastic -= system.R * ((system.M * system.R).transpose() * elastic);
  }
  return of_eigenvalues(solver.eigenvalues(), std::move(Phi), system);
}

}  // namespace

ModalForm modal_form(const System& system) {
  check_sizes(system);
  if (is_diagonal(system.M) && is_diagonal(system.K) && (VectorXd(system.M.diagonal()).array() == 1).all())
    return of_eigenvalues(system.K.diagonal(), MatrixXd(), system);
  return dense(system);
}

}  // namespace mb
