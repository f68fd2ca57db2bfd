#include "modal/bases/arpack.h"

#include <fmt/format.h>

#include <algorithm>
#include <arpack/arpack.hpp>
#include <array>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace mb {
namespace {

constexpr int max_restarts = 300;

std::string describe(int info, int n_converged, int n_wanted) {
  switch (info) {
    case 1:
      return fmt::format("{} of {} eigenvalues after {} restarts", n_converged, n_wanted, max_restarts);
    case 3:
      return "no shift could be applied in a restart: more Lanczos vectors are needed";
    case -8:
      return "the tridiagonal eigenproblem failed";
    case -9:
      return "the start vector is zero in the range of the operator";
    case -9999:
      return "no Lanczos factorisation could be built";
    case -14:
      return "no eigenvalue reached the tolerance";
    default:
      return fmt::format("argument error {}", info);
  }
}

void check_arguments(int n_wanted, int n_vectors, double tolerance, const VectorXd& start) {
  if (n_wanted < 1 || n_wanted >= n_vectors || n_vectors > start.size())
    throw std::invalid_argument(
        fmt::format("largest_ritz: {} eigenvalues with {} vectors of size {}", n_wanted, n_vectors, start.size()));
  if (!(tolerance >= 0) || !start.allFinite() || start.norm() == 0)
    throw std::invalid_argument("largest_ritz: tolerance negative, or start vector zero or not finite");
}

// ARPACK's state between two calls of reverse communication.
struct Lanczos {
  int n, n_wanted, n_vectors;
  double tolerance;
  std::vector<double> residual, basis, work, small;
  std::array<int, 11> parameters{};
  std::array<int, 14> pointers{};
  int request = 0, info = 1;  // 1: the start vector is given

  Lanczos(int wanted, int vectors, double tol, const VectorXd& start)
      : n(static_cast<int>(start.size())),
        n_wanted(wanted),
        n_vectors(vectors),
        tolerance(tol),
        residual(start.begin(), start.end()),
        basis(static_cast<size_t>(n) * static_cast<size_t>(vectors)),
        work(3 * static_cast<size_t>(n)),
        small(static_cast<size_t>(vectors) * static_cast<size_t>(vectors + 8)) {
    parameters[0] = 1;  // exact shifts
    parameters[2] = max_restarts;
    parameters[3] = 1;  // block size, the only one there is
    parameters[6] = 3;  // the mode in which both x and B x are at hand; it returns sigma + 1/theta, sigma = 0
  }
  void advance() {
    arpack::saupd(request, arpack::bmat::generalized, n, arpack::which::largest_algebraic, n_wanted, tolerance,
                  residual.data(), n_vectors, basis.data(), n, parameters.data(), pointers.data(), work.data(),
                  small.data(), static_cast<int>(small.size()), info);
  }
  Eigen::Map<VectorXd> vector(int which) { return {&work[static_cast<size_t>(pointers[which] - 1)], n}; }
};

RitzPairs extract(Lanczos& lanczos, long n_applications) {
  std::vector<int> select(static_cast<size_t>(lanczos.n_vectors));
  VectorXd inverse_theta(lanczos.n_wanted);
  MatrixXd vectors(lanczos.n, lanczos.n_wanted);
  const int n_converged = lanczos.parameters[4];
  arpack::seupd(true, arpack::howmny::ritz_vectors, select.data(), inverse_theta.data(), vectors.data(), lanczos.n, 0.0,
                arpack::bmat::generalized, lanczos.n, arpack::which::largest_algebraic, lanczos.n_wanted,
                lanczos.tolerance, lanczos.residual.data(), lanczos.n_vectors, lanczos.basis.data(), lanczos.n,
                lanczos.parameters.data(), lanczos.pointers.data(), lanczos.work.data(), lanczos.small.data(),
                static_cast<int>(lanczos.small.size()), lanczos.info);
  if (lanczos.info != 0) throw std::runtime_error("ARPACK: " + describe(lanczos.info, n_converged, lanczos.n_wanted));
  const VectorXd theta = inverse_theta.cwiseInverse();
  std::vector<Index> order(static_cast<size_t>(theta.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, std::ranges::greater(), [&](Index i) { return theta(i); });
  return {theta(order), vectors(Eigen::all, order), n_applications};
}

}  // namespace

RitzPairs largest_ritz(const Operator& apply, const InnerProduct& inner_product, int n_wanted, int n_vectors,
                       double tolerance, const VectorXd& start) {
  check_arguments(n_wanted, n_vectors, tolerance, start);
  static std::mutex one_at_a_time;  // ARPACK keeps its state in Fortran SAVE variables
  const std::lock_guard lock(one_at_a_time);

  Lanczos lanczos(n_wanted, n_vectors, tolerance, start);
  constexpr int apply_first = -1, apply_known = 1, multiply = 2, done = 99;
  long n_applications = 0;
  for (lanczos.advance(); lanczos.request != done; lanczos.advance()) {
    const VectorXd x = lanczos.vector(0);
    switch (lanczos.request) {
      case apply_first:
        lanczos.vector(1) = apply(x, inner_product(x));
        ++n_applications;
        break;
      case apply_known:
        lanczos.vector(1) = apply(x, lanczos.vector(2));
        ++n_applications;
        break;
      case multiply:
        lanczos.vector(1) = inner_product(x);
        break;
      default:
        throw std::runtime_error(fmt::format("ARPACK: unknown request {}", lanczos.request));
    }
  }
  if (lanczos.info != 0) throw std::runtime_error("ARPACK: " + describe(lanczos.info, lanczos.parameters[4], n_wanted));
  return extract(lanczos, n_applications);
}

}  // namespace mb
