#include "modal/bases/subspaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {
namespace {

// |D|_M, by the eigenvalues of D^T M D.
double largest_in_mass_norm(const SparseMatrix& M, const MatrixXd& D) {
  const MatrixXd squared = D.transpose() * (M * D);
  return std::sqrt(std::max(0.0, symmetric_eigenvalues(squared).maxCoeff()));
}

double outside(const SparseMatrix& M, const MatrixXd& A, const MatrixXd& B) {
  return largest_in_mass_norm(M, A - B * (B.transpose() * (M * A)));
}

}  // namespace

std::vector<Cluster> clusters(const VectorXd& lambda, Index n_rigid, double gap, double least_gap) {
  if (!lambda.allFinite() || !std::is_sorted(lambda.begin(), lambda.end()))
    throw std::invalid_argument("clusters: eigenvalues out of order or not finite");
  std::vector<Cluster> all;
  for (Index i = n_rigid; i < lambda.size(); ++i) {
    const bool apart = i == n_rigid || lambda[i] - lambda[i - 1] > std::max(gap * lambda[i], least_gap);
    if (apart)
      all.push_back({i, 1});
    else
      ++all.back().n;
  }
  return all;
}

double gap_around(const VectorXd& lambda, Index n_rigid, const Cluster& cluster) {
  const auto [first, n] = cluster;
  double least = std::numeric_limits<double>::infinity();
  if (first > n_rigid) least = 1 - lambda[first - 1] / lambda[first];
  if (first + n < lambda.size()) least = std::min(least, lambda[first + n] / lambda[first + n - 1] - 1);
  return least;
}

double subspace_distance(const SparseMatrix& M, const MatrixXd& A, const MatrixXd& B) {
  if (A.rows() != M.rows() || B.rows() != M.rows() || A.cols() != B.cols() || A.cols() == 0)
    throw std::invalid_argument(fmt::format("subspaces: {} x {} beside {} x {} in the norm of {} unknowns", A.rows(),
                                            A.cols(), B.rows(), B.cols(), M.rows()));
  if (!A.allFinite() || !B.allFinite()) throw std::invalid_argument("subspaces: a vector is not finite");
  return std::max(outside(M, A, B), outside(M, B, A));
}

}  // namespace mb
