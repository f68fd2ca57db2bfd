#include "modal/bases/highest_mode.h"

#include <algorithm>
#include <cmath>

#include "mechanics/algebra/cholesky.h"
#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/algebra/noise.h"
#include "modal/bases/arpack.h"

namespace mb {

SteppedMode highest_mode(const System& system) {
  const auto n = static_cast<int>(system.K.rows());
  SteppedMode mode;
  if (n < 12) {
    mode.phi = generalized_eigen(MatrixXd(system.K), MatrixXd(system.M)).value().vectors.col(n - 1);
  } else {
    const Cholesky mass(system.M);
    const Operator apply = [&](const VectorXd& x, const VectorXd&) { return mass.solve(VectorXd(system.K * x)); };
    const InnerProduct inner_product = [&](const VectorXd& x) -> VectorXd { return system.M * x; };
    // The eigenvalue is wrong by the square of this, the vector by it over a gap: growth is asked to 1 %.
    mode.phi = largest_ritz(apply, inner_product, 1, std::min(n, 40), 1e-7, uniform_noise(n, 3)).vectors.col(0);
  }
  mode.phi /= std::sqrt(mode.phi.dot(system.M * mode.phi));
  mode.M_phi = system.M * mode.phi;
  mode.omega = std::sqrt(mode.phi.dot(system.K * mode.phi));
  mode.zeta = std::max(0.0, mode.phi.dot(apply_damping(system, mode.phi)) / (2 * mode.omega));
  return mode;
}

}  // namespace mb
