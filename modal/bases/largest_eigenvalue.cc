#include "modal/bases/largest_eigenvalue.h"

#include <algorithm>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/noise.h"
#include "modal/bases/arpack.h"

namespace mb {

double largest_eigenvalue(const System& system) {
  const int n = static_cast<int>(system.K.rows());
  if (n < 3) return generalized_eigenvalues(MatrixXd(system.K), MatrixXd(system.M)).value().maxCoeff();
  // Ritz values approach from below, each within its residual of an eigenvalue: added, it leaves the safe side.
  constexpr double tolerance = 0.03;
  const Cholesky mass(system.M);
  const Operator apply = [&](const VectorXd& x, const VectorXd&) { return mass.solve(VectorXd(system.K * x)); };
  const InnerProduct inner_product = [&](const VectorXd& x) -> VectorXd { return system.M * x; };
  const RitzPairs top = largest_ritz(apply, inner_product, 1, std::min(n, 24), tolerance, uniform_noise(n, 2));
  return top.theta(0) * (1 + tolerance);
}

}  // namespace mb
