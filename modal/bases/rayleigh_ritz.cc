#include "modal/bases/rayleigh_ritz.h"

#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/static_response.h"
#include "modal/bases/gate.h"

namespace mb {

ElasticModes rayleigh_ritz(const System& system, const MatrixXd& Y) {
  // Twice is enough: the second pass removes what rounding left of the first.
  const MatrixXd X = without_rigid_part(system, without_rigid_part(system, Y));
  const RowMajor rows = X;
  const RowMajor MX = system.M * rows, KX = system.K * rows;
  const MatrixXd gram = X.transpose() * MX, stiffness = X.transpose() * KX;
  const auto eigen = generalized_eigen(stiffness, gram);
  if (!eigen || !eigen->vectors.allFinite())
    throw std::runtime_error("rayleigh_ritz: the columns of the subspace depend on one another");
  return {eigen->values, X * eigen->vectors};
}

Modes with_rigid(const System& system, const ElasticModes& elastic) {
  const Index m = system.R.cols(), size = m + elastic.lambda.size();
  Modes modes;
  modes.n_rigid = m;
  modes.omega = VectorXd::Zero(size);
  // Scalar roots: Eigen's vectorised ones may differ in the last digit and so disturb the order of twins.
  modes.omega.tail(size - m) = elastic.lambda.unaryExpr([](double lambda) { return std::sqrt(lambda); });
  modes.Phi.resize(system.K.rows(), size);
  modes.Phi << system.R, elastic.Phi;
  modes.residual = residuals(system, modes.Phi, modes.omega, m);
  return modes;
}

}  // namespace mb
