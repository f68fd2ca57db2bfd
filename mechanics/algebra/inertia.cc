#include <fmt/format.h>

#include <limits>
#include <memory>
#include <stdexcept>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/algebra/cholmod_view.h"
#include "mechanics/algebra/noise.h"

namespace mb {
namespace {

// Largest row sum of absolute values, of the symmetric matrix whose lower triangle is given.
double infinity_norm(const SparseMatrix& A) {
  VectorXd sums = VectorXd::Zero(A.rows());
  for (Index column = 0; column < A.cols(); ++column)
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
      if (entry.row() < column) continue;
      sums(entry.row()) += std::abs(entry.value());
      if (entry.row() > column) sums(column) += std::abs(entry.value());
    }
  return sums.maxCoeff();
}

double residual_of_one_solve(const SparseMatrix& A, cholmod_factor* factor, cholmod_common* common) {
  const VectorXd b = uniform_noise(A.rows(), 1);
  cholmod_dense right = cholmod::columns(b.data(), b.size(), 1);
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor, &right, common);
  if (solution == nullptr) throw std::runtime_error(fmt::format("inertia: {}", cholmod::describe(common->status)));
  const VectorXd x = Eigen::Map<const VectorXd>(static_cast<const double*>(solution->x), b.size());
  cholmod_free_dense(&solution, common);
  const VectorXd residual = A.selfadjointView<Eigen::Lower>() * x - b;
  const double relative = residual.lpNorm<Eigen::Infinity>() / (infinity_norm(A) * x.lpNorm<Eigen::Infinity>());
  return std::isfinite(relative) ? relative : std::numeric_limits<double>::infinity();
}

}  // namespace

Inertia inertia(const SparseMatrix& A) {
  cholmod_sparse view = cholmod::lower_triangle(A);
  cholmod::Common common;
  common->supernodal = CHOLMOD_SIMPLICIAL;  // the supernodal factor is L L^T, which no indefinite matrix has
  common->final_ll = 0;
  const auto free_factor = [&](cholmod_factor* factor) { cholmod_free_factor(&factor, &common); };
  const std::unique_ptr<cholmod_factor, decltype(free_factor)> factor(cholmod_analyze(&view, &common), free_factor);
  if (factor) cholmod_factorize(&view, factor.get(), &common);
  if (common->status < 0) throw std::runtime_error(fmt::format("inertia: {}", cholmod::describe(common->status)));

  Inertia result{0, 0, 0, std::numeric_limits<double>::infinity()};
  const double* entries = static_cast<const double*>(factor->x);
  const int* starts = static_cast<const int*>(factor->p);
  for (size_t column = 0; column < factor->n; ++column) {
    const double d = column < factor->minor ? entries[starts[column]] : 0;  // D leads every column of a simplicial L
    ++(d < 0 ? result.negative : d > 0 ? result.positive : result.zero);
  }
  if (factor->minor == factor->n && result.zero == 0) result.residual = residual_of_one_solve(A, factor.get(), &common);
  return result;
}

}  // namespace mb
