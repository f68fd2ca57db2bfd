#include "modal/bases/eigenmodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "mechanics/algebra/noise.h"
#include "modal/bases/arpack.h"
#include "modal/bases/dense_modes.h"
#include "modal/bases/largest_eigenvalue.h"
#include "modal/bases/rayleigh_ritz.h"

namespace mb {
namespace {

void check(const System& system, int n_elastic) {
  const Index n = system.K.rows();
  if (n == 0 || system.K.cols() != n || system.M.rows() != n || system.M.cols() != n || system.R.rows() != n ||
      system.R.cols() >= n)
    throw std::invalid_argument(
        fmt::format("modes: K {} x {}, M {} x {}, R {} x {} do not fit or leave nothing elastic", n, system.K.cols(),
                    system.M.rows(), system.M.cols(), system.R.rows(), system.R.cols()));
  if (n_elastic < 0) throw std::invalid_argument(fmt::format("modes: {} elastic modes", n_elastic));
}

int at_most_all(const System& system, int n_elastic) {
  return static_cast<int>(std::min<Index>(n_elastic, system.K.rows() - system.R.cols()));
}

// Elastic modes found beyond those asked for: room for the cut, multiplets kept whole.
int room_for_the_cut(int n_elastic) { return 6 + n_elastic / 16; }

// More than a third of the spectrum, or so small a system that the Lanczos vectors would span all of it.
bool needs_dense(const System& system, int n_elastic) {
  const Index n = system.K.rows();
  return 3 * n_elastic > n || n - system.R.cols() < 2 * (n_elastic + room_for_the_cut(n_elastic)) + 40;
}

struct Effort {
  double tolerance;  // [-] of ARPACK
  double n_vectors;  // Lanczos vectors as a multiple of the modes
  unsigned seed;     // of the start vector
};

// The lowest n_wanted elastic modes by Lanczos on P (K - sigma M)^-1 M with P = I - R R^T M.
//
// ARPACK measures errors in the M norm; in the plain residual the high frequencies weigh lambda_max/lambda times more.
// One inverse iteration of all modes at once (a block solve is cheap) damps them by as much, then Rayleigh-Ritz.
ElasticModes shift_invert(const System& system, int n_wanted, const Cholesky& factor, const Effort& effort) {
  const int n = static_cast<int>(system.K.rows());
  const int n_elastic = n - static_cast<int>(system.R.cols());
  const int n_vectors = std::min(n_elastic, static_cast<int>(effort.n_vectors * n_wanted) + 20);
  const MatrixXd MR = system.M * system.R;
  const auto project = [&](const VectorXd& v) -> VectorXd { return v - system.R * (MR.transpose() * v); };
  const Operator apply = [&](const VectorXd&, const VectorXd& Mx) { return project(factor.solve(Mx)); };
  const InnerProduct inner_product = [&](const VectorXd& x) -> VectorXd { return system.M * x; };
  const VectorXd start = project(uniform_noise(n, effort.seed));
  const RitzPairs ritz = largest_ritz(apply, inner_product, n_wanted, n_vectors, effort.tolerance, start);
  const MatrixXd improved = factor.solve(MatrixXd(system.M * ritz.vectors));
  return rayleigh_ritz(system, improved * ritz.theta.cwiseInverse().asDiagonal());
}

Modes with_rigid(const System& system, const ElasticModes& elastic, double lambda_max) {
  const Index m = system.R.cols(), size = m + elastic.lambda.size();
  Modes modes;
  modes.n_rigid = m;
  modes.omega = VectorXd::Zero(size);
  // Scalar roots: Eigen's vectorised ones may differ in the last digit and so disturb the order of twins. A negative
  // lambda becomes NaN, which the gate refuses.
  modes.omega.tail(size - m) = elastic.lambda.unaryExpr([](double lambda) { return std::sqrt(lambda); });
  modes.Phi.resize(system.K.rows(), size);
  modes.Phi << system.R, elastic.Phi;
  modes.lambda_max = lambda_max;
  modes.residual = residuals(system, modes.Phi, modes.omega, m);
  return modes;
}

// n_elastic, rounded up to whole multiplets; nothing where the last one found may not be whole.
std::optional<Index> whole_multiplets(const System& system, const Modes& found, Index n_elastic) {
  Index keep = found.n_rigid + n_elastic;
  const VectorXd lambda = found.omega.array().square();
  while (n_elastic > 0 && keep < found.size() && lambda(keep) - lambda(keep - 1) <= multiplet_gap * lambda(keep))
    ++keep;
  if (keep == found.size() && keep < system.K.rows()) return std::nullopt;
  return keep;
}

Modes first(const Modes& found, Index n_keep) {
  return {found.n_rigid, found.omega.head(n_keep), found.Phi.leftCols(n_keep), found.residual.head(n_keep),
          found.lambda_max};
}

Modes all_by_dense_solver(const System& system, Index n_elastic) {
  const ElasticModes elastic = dense_modes(system);
  const Modes found = with_rigid(system, elastic, elastic.lambda(elastic.lambda.size() - 1));
  const Index n_keep = *whole_multiplets(system, found, n_elastic);
  check_modes(system, found, n_keep);
  return first(found, n_keep);
}

Modes lowest_by_lanczos(const System& system, int n_elastic, const Cholesky& factor) {
  // Copies of a multiplet enter a Krylov space through rounding alone and may come late: on a square beam a tolerance
  // of 1e-6 lost one in 30 modes, 1e-10 none for 40 % more solves. A second try starts elsewhere, with more vectors, to
  // the last digit.
  constexpr Effort usual{1e-10, 1.5, 4}, thorough{0, 2.5, 5};
  const double lambda_max = largest_eigenvalue(system);
  const auto attempt = [&](const Effort& effort) {
    for (int n_wanted = n_elastic + room_for_the_cut(n_elastic);; n_wanted *= 2) {
      if (needs_dense(system, n_wanted)) return all_by_dense_solver(system, n_elastic);
      const Modes found = with_rigid(system, shift_invert(system, n_wanted, factor, effort), lambda_max);
      const std::optional<Index> n_keep = whole_multiplets(system, found, n_elastic);
      if (!n_keep) continue;
      check_modes(system, found, *n_keep);
      return first(found, *n_keep);
    }
  };
  try {
    return attempt(usual);
  } catch (const GateFailure&) {
    return attempt(thorough);
  }
}

}  // namespace

Modes lowest_modes(const System& system, int n_elastic, const ShiftedFactor& shifted) {
  check(system, n_elastic);
  if (shifted.factor.size() != system.K.rows()) throw std::invalid_argument("modes: factor of another size");
  n_elastic = at_most_all(system, n_elastic);
  if (needs_dense(system, n_elastic)) return all_by_dense_solver(system, n_elastic);
  return lowest_by_lanczos(system, n_elastic, shifted.factor);
}

Modes lowest_modes(const System& system, int n_elastic, double shift) {
  check(system, n_elastic);
  if (!(shift < 0)) throw std::invalid_argument("modes: the shift must be negative");
  n_elastic = at_most_all(system, n_elastic);
  if (needs_dense(system, n_elastic)) return all_by_dense_solver(system, n_elastic);
  return lowest_by_lanczos(system, n_elastic, shifted_factor(system, shift).factor);
}

}  // namespace mb
