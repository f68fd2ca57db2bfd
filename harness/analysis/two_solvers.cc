#include "harness/analysis/two_solvers.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace mb {

std::vector<TwiceFound> twice_found(const SparseMatrix& M, const Modes& modes, const VectorXd& lambda,
                                    const MatrixXd& Phi) {
  if (modes.Phi.cols() != modes.size() || Phi.cols() != lambda.size() || lambda.size() < modes.size())
    throw std::invalid_argument(
        fmt::format("multiplets: {} modes beside {} by the other solver", modes.size(), lambda.size()));
  std::vector<TwiceFound> all;
  const double rounding = std::numeric_limits<double>::epsilon() * modes.lambda_max;  // as in modes.h
  for (const Cluster& c : clusters(modes.omega.cwiseAbs2(), modes.n_rigid, multiplet_gap, rounding)) {
    const VectorXd own = modes.omega.segment(c.first, c.n), other = lambda.segment(c.first, c.n).cwiseSqrt();
    all.push_back({c, other[0], gap_around(lambda, modes.n_rigid, c), (own - other).cwiseAbs().maxCoeff() / other[0],
                   subspace_distance(M, modes.Phi.middleCols(c.first, c.n), Phi.middleCols(c.first, c.n))});
  }
  return all;
}

}  // namespace mb
