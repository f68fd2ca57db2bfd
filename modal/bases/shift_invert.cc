#include "modal/bases/shift_invert.h"

#include "mechanics/algebra/noise.h"
#include "mechanics/system/symmetric_product.h"
#include "modal/bases/block_lanczos.h"
#include "modal/bases/gate.h"

namespace mb {
namespace {

MatrixXd noise(Index n, Index columns, unsigned seed) { return uniform_noise(n * columns, seed).reshaped(n, columns); }

MatrixXd by_columns(const SymmetricProduct& product, const MatrixXd& X) {
  MatrixXd Y(X.rows(), X.cols());
  VectorXd y(X.rows());
  for (Index j = 0; j < X.cols(); ++j) {
    product(X.col(j), y);
    Y.col(j) = y;
  }
  return Y;
}

// Vectors kept before a restart: with eight a mode and a few blocks most searches need none.
Index room(Index n_elastic, const Effort& effort) { return 3 * (n_elastic + effort.n_spare) + 16 * effort.block; }

}  // namespace

std::optional<Index> whole_multiplets(const VectorXd& lambda, Index n_elastic, Index n_all, double lambda_max) {
  Index keep = n_elastic;
  if (keep > lambda.size()) return std::nullopt;
  while (keep > 0 && keep < lambda.size() && are_one_multiplet(lambda(keep - 1), lambda(keep), lambda_max)) ++keep;
  if (keep == lambda.size() && keep < n_all) return std::nullopt;
  return keep;
}

Index least_size(Index n_elastic, const Effort& effort) { return 2 * (n_elastic + effort.n_spare) + 8 * effort.block; }

ElasticModes shift_invert(const System& system, Index n_elastic, const ShiftedFactor& shifted, const Effort& effort) {
  const Index n = system.K.rows(), n_all = n - system.R.cols();
  const SymmetricProduct product(system.M);
  const BlockProduct mass = [&](const MatrixXd& X) { return by_columns(product, X); };
  const BlockOperator inverse = [&](const MatrixXd& MX) { return shifted.factor.solve(MX); };
  const auto missing = [&](const VectorXd& theta) -> Index {
    const VectorXd lambda = theta.cwiseInverse().array() + shifted.shift;
    const Index n_known = lambda.size(), keep = whole_multiplets(lambda, n_elastic, n_all).value_or(n_known + 1);
    return std::min(std::max(keep, n_elastic) + effort.n_spare, n_all) - n_known;
  };
  const Krylov krylov{std::min(n_all, room(n_elastic, effort)), effort.tolerance};
  const LargestPairs found =
      largest_pairs(inverse, mass, system.R, noise(n, effort.block, effort.seed), missing, krylov);
  // Lanczos measures errors in the M norm; in the plain residual the high frequencies weigh lambda_max/lambda times
  // more. One more application of T damps them by as much: what is left is what rounding of phi makes of K phi, about
  // eps | |K| |phi| |, a hundredth to a hundred thousandth of what it was.
  return rayleigh_ritz(system, inverse(mass(found.vectors)));
}

}  // namespace mb
