#include "mechanics/algebra/dense_eigen.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mb {
namespace {

using Solver = Eigen::SelfAdjointEigenSolver<MatrixXd>;

Solver symmetric(const MatrixXd& A, int options) {
  const Solver solver(A, options);
  if (solver.info() != Eigen::Success) throw std::runtime_error("the dense symmetric eigensolver has not converged");
  return solver;
}

// K x = lambda M x as C y = lambda y with C = L^-1 K L^-T, y = L^T x, M = L L^T.
std::optional<EigenPairs> generalized(const MatrixXd& K, const MatrixXd& M, int options) {
  const Eigen::LLT<MatrixXd> factor(M);
  if (factor.info() != Eigen::Success) return std::nullopt;
  MatrixXd C = K.selfadjointView<Eigen::Lower>();
  factor.matrixL().solveInPlace<Eigen::OnTheLeft>(C);
  factor.matrixU().solveInPlace<Eigen::OnTheRight>(C);
  const Solver solver(C, options);
  if (solver.info() != Eigen::Success) return std::nullopt;
  EigenPairs pairs{solver.eigenvalues(), {}};
  if (options == Eigen::ComputeEigenvectors) {
    pairs.vectors = solver.eigenvectors();
    factor.matrixU().solveInPlace(pairs.vectors);
  }
  return pairs;
}

}  // namespace

EigenPairs symmetric_eigen(const MatrixXd& A) {
  const Solver solver = symmetric(A, Eigen::ComputeEigenvectors);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& A) { return symmetric(A, Eigen::EigenvaluesOnly).eigenvalues(); }

Eigen::VectorXcd general_eigenvalues(const MatrixXd& A) {
  const Eigen::EigenSolver<MatrixXd> solver(A, false);
  if (solver.info() != Eigen::Success) throw std::runtime_error("the dense eigensolver has not converged");
  return solver.eigenvalues();
}

std::optional<EigenPairs> generalized_eigen(const MatrixXd& K, const MatrixXd& M) {
  return generalized(K, M, Eigen::ComputeEigenvectors);
}

std::optional<VectorXd> generalized_eigenvalues(const MatrixXd& K, const MatrixXd& M) {
  const auto pairs = generalized(K, M, Eigen::EigenvaluesOnly);
  return pairs ? std::optional(pairs->values) : std::nullopt;
}

Svd thin_svd(const MatrixXd& A) {
  const Eigen::BDCSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  if (svd.info() != Eigen::Success) throw std::runtime_error("the singular values have not converged");
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

VectorXd singular_values(const MatrixXd& A) {
  const Eigen::BDCSVD<MatrixXd> svd(A);
  if (svd.info() != Eigen::Success) throw std::runtime_error("the singular values have not converged");
  return svd.singularValues();
}

// A + i B has those of [A -B; B A], where each stands twice.
VectorXd singular_values(const Eigen::MatrixXcd& A) {
  MatrixXd real(2 * A.rows(), 2 * A.cols());
  real << A.real(), -A.imag(), A.imag(), A.real();
  return singular_values(real)(Eigen::seq(0, Eigen::last, 2));
}

double spectral_norm(const MatrixXd& A) {
  if (A.size() == 0) return 0;
  return std::sqrt(std::max(0.0, symmetric_eigenvalues(A.transpose() * A).maxCoeff()));
}

}  // namespace mb
