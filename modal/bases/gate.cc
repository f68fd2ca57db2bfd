#include "modal/bases/gate.h"

#include <fmt/format.h>

#include <limits>

#include "mechanics/algebra/inertia.h"

namespace mb {
namespace {

constexpr double rounding = 50 * std::numeric_limits<double>::epsilon();  // [-] of an eigenvalue, over lambda_max

double lambda_of(const Modes& modes, Index i) { return modes.omega(i) * modes.omega(i); }

void check_sizes(const System& system, const Modes& found, Index n_keep) {
  const Index n = system.K.rows(), size = found.size();
  if (found.Phi.rows() != n || found.Phi.cols() != size || found.n_rigid >= size || size > n || n_keep > size ||
      n_keep < found.n_rigid || found.n_rigid < 0)
    throw std::invalid_argument(
        fmt::format("modes to check: {} of {} x {}, {} rigid, {} to keep, for {} degrees of "
                    "freedom",
                    size, found.Phi.rows(), found.Phi.cols(), found.n_rigid, n_keep, n));
  if (!(found.lambda_max > 0)) throw std::invalid_argument("modes to check: lambda_max must be given");
  if (found.n_rigid != system.R.cols())
    throw GateFailure(fmt::format("{} rigid modes where the supports leave {} free", found.n_rigid, system.R.cols()));
}

void check_frequencies(const Modes& found) {
  for (Index i = 0; i < found.size(); ++i) {
    const double omega = found.omega(i);
    const bool legal =
        i < found.n_rigid ? omega == 0 : std::isfinite(omega) && omega > 0 && (i == 0 || omega >= found.omega(i - 1));
    if (!legal)
      throw GateFailure(fmt::format("mode {}: omega = {} rad/s is no frequency or out of order", i + 1, omega));
    // Below, rounding may be larger than a hundredth of lambda, and the bound on the residual would certify nothing.
    const double doubt = rounding * found.lambda_max / (omega * omega);
    if (i >= found.n_rigid && doubt > 0.01)
      throw GateFailure(fmt::format(
          "mode {} (omega = {:.3g} rad/s) is so near to zero beside the highest of its mesh (lambda/lambda_max "
          "= {:.1e}) that rounding may make {:.2g} % of its lambda, and its residual would certify nothing: "
          "at most 1 % (fewer or even cells, or bodies of their own, are better conditioned)",
          i + 1, omega, omega * omega / found.lambda_max, 100 * doubt));
  }
}

void check_residuals(const System& system, const Modes& found) {
  const double lambda_1 = lambda_of(found, found.n_rigid);
  const VectorXd residual = residuals(system, found.Phi, found.omega, found.n_rigid);
  for (Index i = 0; i < found.size(); ++i) {
    const bool rigid = i < found.n_rigid;
    const double bound =
        std::max(rigid ? 1e-9 : 1e-8, rounding * found.lambda_max / (rigid ? lambda_1 : lambda_of(found, i)));
    if (!(residual(i) <= bound))
      throw GateFailure(fmt::format("mode {} ({}, omega = {:.9g} rad/s): residual {:.2e} exceeds {:.2e}", i + 1,
                                    rigid ? "rigid" : "elastic", found.omega(i), residual(i), bound));
  }
}

void check_orthonormality(const System& system, const Modes& found) {
  constexpr double bound = 1e-10;
  const RowMajor M_Phi = system.M * RowMajor(found.Phi);
  const MatrixXd gram = found.Phi.transpose() * M_Phi;
  Index i = 0, j = 0;
  const double worst = (gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(&i, &j);
  if (!(worst <= bound))
    throw GateFailure(
        fmt::format("modes {} and {} (omega = {:.9g} and {:.9g} rad/s): |phi^T M phi - I| = {:.2e} "
                    "exceeds {:.0e}",
                    i + 1, j + 1, found.omega(i), found.omega(j), worst, bound));
}

bool inside_multiplet(const Modes& found, Index i) {  // of the cut below mode i (from 0)
  return are_one_multiplet(lambda_of(found, i - 1), lambda_of(found, i), found.lambda_max);
}

// Sylvester's law of inertia: K - mu M has as many negative eigenvalues as there are modes below mu.
void check_count(const System& system, const Modes& found, Index n_keep) {
  if (found.size() == system.K.rows()) return;  // M-orthonormal and as many as there are: complete
  double best_residual = std::numeric_limits<double>::infinity();
  for (Index cut = n_keep; cut < found.size(); ++cut) {
    if (cut > 0 && inside_multiplet(found, cut)) continue;
    const double below = cut > 0 ? lambda_of(found, cut - 1) : 0;
    const SparseMatrix shifted = system.K - 0.5 * (below + lambda_of(found, cut)) * system.M;
    const Inertia count = inertia(shifted);
    best_residual = std::min(best_residual, count.residual);
    if (count.residual > 1e-8) continue;
    if (count.negative == cut && count.zero == 0) return;
    throw GateFailure(
        fmt::format("{} modes lie below the cut between modes {} and {} (omega = {:.9g} and {:.9g} rad/s), "
                    "{} were found",
                    count.negative, cut, cut + 1, std::sqrt(below), found.omega(cut), cut));
  }
  throw GateFailure(
      fmt::format("no cut above mode {} (omega = {:.9g} rad/s) could be counted: smallest residual of an "
                  "LDL^T {:.1e}",
                  n_keep, n_keep > 0 ? found.omega(n_keep - 1) : 0, best_residual));
}

}  // namespace

VectorXd residuals(const System& system, const MatrixXd& Phi, const VectorXd& omega, Index n_rigid) {
  const RowMajor rows = Phi, M_Phi = system.M * rows;
  const VectorXd lambda = omega.array().square();
  RowMajor difference = system.K * rows;
  difference -= M_Phi * lambda.asDiagonal();
  VectorXd residual(lambda.size());
  for (Index i = 0; i < residual.size(); ++i) {
    const Index elastic = std::max(i, n_rigid);  // rigid: lambda_1
    const double scale = elastic < lambda.size() ? lambda(elastic) : std::numeric_limits<double>::quiet_NaN();
    residual(i) = difference.col(i).norm() / (scale * M_Phi.col(i).norm());
  }
  return residual;
}

void check_modes(const System& system, const Modes& found, Index n_keep) {
  check_sizes(system, found, n_keep);
  check_frequencies(found);
  check_residuals(system, found);
  check_orthonormality(system, found);
  if (n_keep > found.n_rigid && n_keep < found.size() && inside_multiplet(found, n_keep))
    throw GateFailure(fmt::format("modes {} and {} (omega = {:.9g} and {:.9g} rad/s) are one multiplet, cut in two",
                                  n_keep, n_keep + 1, found.omega(n_keep - 1), found.omega(n_keep)));
  check_count(system, found, n_keep);
}

}  // namespace mb
