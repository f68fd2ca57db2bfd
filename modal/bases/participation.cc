#include "modal/bases/participation.h"

#include <fmt/format.h>

#include <stdexcept>

#include "mechanics/algebra/dense_eigen.h"

namespace mb {
namespace {

// Columns dependent to rounding, as of polynomials on meshes of few nodes, are left out.
MatrixXd orthonormal(const SparseMatrix& M, const MatrixXd& Y) {
  if (Y.cols() == 0) return Y;
  const EigenPairs gram = symmetric_eigen(Y.transpose() * (M * Y));
  const VectorXd& mass = gram.values;
  const Index n_kept = (mass.array() > 1e-12 * mass.maxCoeff()).count();
  return Y * gram.vectors.rightCols(n_kept) * mass.tail(n_kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

std::vector<int> polynomial_degrees(const FullModel& full, const MatrixXd& Phi) {
  const SparseMatrix& M = full.system().M;
  const MatrixXd MPhi = M * Phi;
  const VectorXd whole = Phi.cwiseProduct(MPhi).colwise().sum();
  std::vector<int> degrees(static_cast<size_t>(Phi.cols()), beyond);
  for (int degree = most_degree; degree >= 0; --degree) {
    const MatrixXd Q = orthonormal(M, full.polynomials(degree));
    if (Q.cols() == 0) continue;
    const VectorXd held = (Q.transpose() * MPhi).colwise().squaredNorm();
    for (Index i = 0; i < Phi.cols(); ++i)
      if (held(i) >= degree_share * whole(i)) degrees[static_cast<size_t>(i)] = degree;
  }
  return degrees;
}

MatrixXd participation(const MatrixXd& Phi, const MatrixXd& Mr, double mass) {
  if (Mr.rows() != Phi.rows() || Mr.cols() != 3 || !(mass > 0))
    throw std::invalid_argument(fmt::format("participation: modes {} x {}, translated mass {} x {}, {} kg", Phi.rows(),
                                            Phi.cols(), Mr.rows(), Mr.cols(), mass));
  return (Phi.transpose() * Mr).cwiseAbs2() / mass;
}

MatrixXd translated_mass(const FullModel& full, const Quadrature& volume, double density) {
  const System& system = full.system();
  const double scale = density * full.mesh_volume() / volume.weights.sum();
  MatrixXd weights = MatrixXd::Zero(3 * volume.weights.size(), 3);
  for (Index p = 0; p < volume.weights.size(); ++p)
    weights.block<3, 3>(3 * p, 0).diagonal().setConstant(scale * volume.weights[p]);
  const MatrixXd Mr = full.displacement_at(volume.points).transpose() * weights;
  if (system.R.cols() < 6) return Mr;
  return system.M * (system.R * (system.R.transpose() * Mr));
}

}  // namespace mb
