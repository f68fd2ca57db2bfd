#include "modal/bases/eigenmodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "modal/bases/dense_modes.h"
#include "modal/bases/diagonal_modes.h"
#include "modal/bases/largest_eigenvalue.h"
#include "modal/bases/shift_invert.h"

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
  // What is deflated must be a projection; whether it is rigid the gate finds out.
  const MatrixXd gram = system.R.transpose() * (system.M * system.R);
  if (gram.size() > 0 && !((gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff() <= 1e-10))
    throw GateFailure("modes: the rigid modes are not M-orthonormal");
}

int at_most_all(const System& system, int n_elastic) {
  return static_cast<int>(std::min<Index>(n_elastic, system.K.rows() - system.R.cols()));
}

// Eight columns: the factor is read once for all, and few multiplets have more copies. A second try, where the first
// lost a mode, starts elsewhere with more columns and goes to the last digits.
constexpr Effort usual{8, 1e-10, 3, 4}, thorough{20, 1e-12, 12, 5};

// More than a third of the spectrum, or so small a system that the Lanczos vectors would span most of it.
bool needs_dense(const System& system, int n_elastic) {
  const Index n = system.K.rows();
  return 3 * n_elastic > n || n - system.R.cols() < least_size(n_elastic, thorough);
}

Modes first(const Modes& found, Index n_keep) {
  return {found.n_rigid, found.omega.head(n_keep), found.Phi.leftCols(n_keep), found.residual.head(n_keep),
          found.lambda_max};
}

// Of a mode and its opposite the one whose coefficients, weighed by numbers without any symmetry, sum to more than 0:
// the same whoever found it, however its sums were ordered.
void orient(Eigen::Ref<MatrixXd> Phi) {
  const VectorXd weights = VectorXd::LinSpaced(Phi.rows(), 1, static_cast<double>(Phi.rows())).array().sin();
  for (Index i = 0; i < Phi.cols(); ++i)
    if (Phi.col(i).dot(weights) < 0) Phi.col(i) *= -1;
}

// What of the modes found is to be kept, after the gate has seen all of them.
Modes gated(const System& system, const ElasticModes& elastic, int n_elastic, double lambda_max) {
  const Index m = system.R.cols(), n_all = system.K.rows() - m;
  const std::optional<Index> keep = whole_multiplets(elastic.lambda, n_elastic, n_all, lambda_max);
  if (!keep) throw GateFailure(fmt::format("modes: multiplets beyond mode {} were not found whole", m + n_elastic));
  Modes found = with_rigid(system, elastic);
  found.lambda_max = lambda_max;
  check_modes(system, found, m + *keep);
  orient(found.Phi.rightCols(found.size() - m));
  return first(found, m + *keep);
}

Modes lowest(const System& system, int n_elastic, const ShiftedFactor& shifted) {
  const double lambda_max = largest_eigenvalue(system);
  try {
    return gated(system, shift_invert(system, n_elastic, shifted, usual), n_elastic, lambda_max);
  } catch (const GateFailure&) {
    return gated(system, shift_invert(system, n_elastic, shifted, thorough), n_elastic, lambda_max);
  }
}

std::optional<Modes> known(const System& system, int n_elastic) {
  const auto elastic = diagonal_modes(system, n_elastic);
  if (!elastic) return std::nullopt;
  return gated(system, *elastic, n_elastic, system.K.diagonal().cwiseQuotient(system.M.diagonal()).maxCoeff());
}

Modes all(const System& system, int n_elastic) {
  const ElasticModes elastic = dense_modes(system);
  return gated(system, elastic, n_elastic, elastic.lambda(elastic.lambda.size() - 1));
}

}  // namespace

ElasticModes elastic_modes(const System& system, int n_elastic, const ShiftedFactor& shifted) {
  check(system, n_elastic);
  if (shifted.factor.size() != system.K.rows()) throw std::invalid_argument("modes: factor of another size");
  n_elastic = at_most_all(system, n_elastic);
  if (auto modes = diagonal_modes(system, n_elastic)) return *modes;
  return needs_dense(system, n_elastic) ? dense_modes(system) : shift_invert(system, n_elastic, shifted, usual);
}

Modes lowest_modes(const System& system, int n_elastic, const ShiftedFactor& shifted) {
  check(system, n_elastic);
  if (shifted.factor.size() != system.K.rows()) throw std::invalid_argument("modes: factor of another size");
  n_elastic = at_most_all(system, n_elastic);
  if (auto modes = known(system, n_elastic)) return *modes;
  return needs_dense(system, n_elastic) ? all(system, n_elastic) : lowest(system, n_elastic, shifted);
}

Modes lowest_modes(const System& system, int n_elastic, double shift) {
  check(system, n_elastic);
  if (!(shift < 0)) throw std::invalid_argument("modes: the shift must be negative");
  n_elastic = at_most_all(system, n_elastic);
  if (auto modes = known(system, n_elastic)) return *modes;
  return needs_dense(system, n_elastic) ? all(system, n_elastic)
                                        : lowest(system, n_elastic, shifted_factor(system, shift));
}

}  // namespace mb
