#include "modal/bases/rayleigh_ritz.h"

#include <stdexcept>

#include "mechanics/system/static_response.h"

namespace mb {

ElasticModes rayleigh_ritz(const System& system, const MatrixXd& Y) {
  // Twice is enough: the second pass removes what rounding left of the first.
  const MatrixXd X = without_rigid_part(system, without_rigid_part(system, Y));
  const MatrixXd MX = system.M * X, KX = system.K * X;
  const MatrixXd gram = X.transpose() * MX, stiffness = X.transpose() * KX;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(stiffness, gram);
  if (eigen.info() != Eigen::Success || !eigen.eigenvectors().allFinite())
    throw std::runtime_error("rayleigh_ritz: the columns of the subspace depend on one another");
  return {eigen.eigenvalues(), X * eigen.eigenvectors()};
}

}  // namespace mb
