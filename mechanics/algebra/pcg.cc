#include "mechanics/algebra/pcg.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace mb {
namespace {

constexpr double most_rounding = 1e-4;  // [-] of |b|; a bar 200 times as long as wide comes to 1e-5

// | |A| |x| | eps: what rounding leaves of A x when its terms cancel.
double rounding_of_product(const SparseMatrix& A, const VectorXd& x) {
  VectorXd sum = VectorXd::Zero(A.rows());
  for (Index column = 0; column < A.cols(); ++column)
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry)
      sum(entry.row()) += std::abs(entry.value() * x(column));
  return std::numeric_limits<double>::epsilon() * sum.norm();
}

}  // namespace

PcgSolution pcg(const SparseMatrix& A, const VectorXd& b, const LinearMap& precondition, double tolerance,
                int max_iterations, const LinearMap& project) {
  if (A.rows() != A.cols() || A.rows() != b.size()) throw std::invalid_argument("pcg: sizes of A and b differ");
  if (!(tolerance > 0) || max_iterations < 1) throw std::invalid_argument("pcg: tolerance and iterations must be > 0");
  const double scale = b.norm();
  if (!std::isfinite(scale)) throw std::invalid_argument("pcg: right-hand side not finite");
  VectorXd x = VectorXd::Zero(b.size());
  if (scale == 0) return {x, 0, 0};
  const auto preconditioned = [&](const VectorXd& r) { return project ? project(precondition(r)) : precondition(r); };
  // 4: the sums of a row round more than once. Of an x that runs away, b being outside A's range, rounding excuses
  // nothing.
  const auto small_enough = [&](const VectorXd& at) {
    return std::max(tolerance * scale, std::min(most_rounding * scale, 4 * rounding_of_product(A, at)));
  };

  VectorXd r = b, p = VectorXd::Zero(b.size());
  double rho = 0;
  bool restart = true;  // the recurrence of r drifts from b - A x: it is believed only once recomputed
  for (int iteration = 1; iteration <= max_iterations; ++iteration) {
    const VectorXd z = preconditioned(r);
    const double rho_new = r.dot(z);
    if (restart)
      p = z;
    else
      p = z + (rho_new / rho) * p;
    rho = rho_new;
    const VectorXd Ap = A * p;
    const double curvature = p.dot(Ap);
    if (!(rho > 0) || !(curvature > 0))
      throw std::runtime_error(fmt::format("pcg: operator not positive (r.z {:.1e}, p.Ap {:.1e}, |r|/|b| {:.1e})", rho,
                                           curvature, r.norm() / scale));
    x += (rho / curvature) * p;
    r -= (rho / curvature) * Ap;
    restart = r.norm() <= small_enough(x);
    if (!restart) continue;
    r = b - A * x;
    if (r.norm() <= small_enough(x)) return {x, iteration, r.norm() / scale};
  }
  throw std::runtime_error(fmt::format("pcg: |r|/|b| = {:.1e} after {} iterations, wanted {:.1e}", r.norm() / scale,
                                       max_iterations, tolerance));
}

}  // namespace mb
