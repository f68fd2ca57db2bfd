#include "modal/bases/diagonal_modes.h"

#include <algorithm>
#include <numeric>

namespace mb {

namespace {

bool is_diagonal(const SparseMatrix& A) {
  if (A.nonZeros() > A.rows()) return false;
  for (Index j = 0; j < A.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(A, j); it; ++it)
      if (it.row() != it.col() && it.value() != 0) return false;
  return true;
}

}  // namespace

std::optional<ElasticModes> diagonal_modes(const System& system, Index n_elastic) {
  if (!is_diagonal(system.M) || !is_diagonal(system.K)) return std::nullopt;
  const VectorXd m = system.M.diagonal(), k = system.K.diagonal(), lambda = k.cwiseQuotient(m);
  std::vector<Index> elastic;
  for (Index i = 0; i < k.size(); ++i)
    if (k[i] > 0) elastic.push_back(i);
  const auto n_all = std::ssize(elastic);
  if (n_all + system.R.cols() != k.size() || n_elastic > n_all) return std::nullopt;
  std::ranges::stable_sort(elastic, {}, [&](Index i) { return lambda[i]; });
  const auto at = [&](Index i) { return lambda[elastic[static_cast<size_t>(i)]]; };
  Index n = n_elastic;
  while (n > 0 && n < n_all && are_one_multiplet(at(n - 1), at(n), lambda.maxCoeff())) ++n;
  n = std::min<Index>(n + 1, n_all);
  ElasticModes modes{VectorXd(n), MatrixXd::Zero(k.size(), n)};
  for (Index j = 0; j < n; ++j) {
    const Index i = elastic[static_cast<size_t>(j)];
    modes.lambda[j] = lambda[i];
    modes.Phi(i, j) = 1 / std::sqrt(m[i]);
  }
  return modes;
}

}  // namespace mb
