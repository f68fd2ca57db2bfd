#include "modal/bases/ritz_modes.h"

#include <fmt/format.h>

#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"
#include "mechanics/system/static_response.h"
#include "modal/bases/rayleigh_ritz.h"

namespace mb {
namespace {

MatrixXd with_unit_mass(MatrixXd X, const MatrixXd& MX) {
  for (Index j = 0; j < X.cols(); ++j) {
    const double mass = X.col(j).dot(MX.col(j));
    if (mass > 0) X.col(j) /= std::sqrt(mass);
  }
  return X;
}

// An M-orthonormal basis of what Y spans beyond the rigid modes: Y has unit mass, so that columns are measured alike.
MatrixXd elastic_part(const System& system, const MatrixXd& Y) {
  const Index n_elastic = Y.cols() - system.R.cols();
  const MatrixXd X = without_rigid_part(system, without_rigid_part(system, Y));
  const EigenPairs gram = symmetric_eigen(X.transpose() * (system.M * X));
  const VectorXd mass = gram.values.tail(n_elastic);
  const double beyond = n_elastic < Y.cols() ? gram.values(Y.cols() - n_elastic - 1) : 0;
  // Rounding leaves about 1e-16 of what is rigid; polynomials on bodies of slenderness 50 stay above 1e-8.
  constexpr double dependent = 1e-12;
  if (!(mass.minCoeff() > dependent))
    throw std::runtime_error(fmt::format("ritz_modes: the functions depend on one another ({:.1e})", mass.minCoeff()));
  if (!(beyond <= dependent))
    throw std::runtime_error(fmt::format("ritz_modes: the functions do not contain the rigid modes ({:.1e})", beyond));
  return X * gram.vectors.rightCols(n_elastic) * mass.cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

Modes ritz_modes(const System& system, const MatrixXd& Y) {
  const Index n = system.M.rows(), m = system.R.cols();
  if (Y.rows() != n || Y.cols() < m || !Y.allFinite())
    throw std::invalid_argument(
        fmt::format("ritz_modes: functions {} x {} for {} unknowns, {} rigid modes", Y.rows(), Y.cols(), n, m));
  if (Y.cols() == m) return with_rigid(system, {VectorXd(0), MatrixXd(n, 0)});
  return with_rigid(system, rayleigh_ritz(system, elastic_part(system, with_unit_mass(Y, system.M * Y))));
}

}  // namespace mb
