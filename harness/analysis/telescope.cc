#include "harness/analysis/telescope.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/metrics/motion.h"
#include "harness/metrics/signal.h"

namespace mb {

Telescope telescope(const Chain& chain) {
  if (chain.size() < 2) throw std::invalid_argument("a telescope needs two answers at least");
  const MatrixXd &first = chain.front(), &last = chain.back();
  for (const MatrixXd& y : chain)
    if (y.rows() != first.rows() || y.cols() != first.cols())
      throw std::invalid_argument("a telescope needs answers at the same points and times");
  const auto n = static_cast<Index>(chain.size()) - 1;
  const double squared = last.squaredNorm();
  const double scale = squared > 0 ? squared : std::numeric_limits<double>::quiet_NaN();
  MatrixXd products = MatrixXd::Zero(n, n), a(first.rows(), n);  // <a_i, a_j>; the parts at one time
  for (Index k = 0; k < first.cols(); ++k) {
    for (Index i = 0; i < n; ++i) {
      const MatrixXd &y = chain[static_cast<size_t>(i)], &next = chain[static_cast<size_t>(i) + 1];
      a.col(i) = y.col(k) - next.col(k);
    }
    products += a.transpose() * a;
  }
  Telescope result{(products.diagonal() / scale).cwiseSqrt(), MatrixXd::Zero(n, n),
                   (first - last).norm() / std::sqrt(scale)};
  result.cross.triangularView<Eigen::StrictlyUpper>() = 2 / scale * products;
  return result;
}

MatrixXd in_mass_norm(const Trajectory& answer, const MetricContext& context) {
  const Material& material = context.scene.bodies[static_cast<size_t>(context.body)].material;
  const VectorXd w = material.density * context.points.volume.weights.replicate(1, 3).transpose().reshaped();
  return w.cwiseSqrt().asDiagonal() * motion(answer, context).volume *
         trapezoid_weights(answer.t).cwiseSqrt().asDiagonal();
}

MatrixXd in_energy_norm(const Trajectory& answer, const MetricContext& context) {
  const Material& material = context.scene.bodies[static_cast<size_t>(context.body)].material;
  const VectorXd w = stiffness_weights(material, context.points.volume);
  const MatrixXd strain = answer.bodies[static_cast<size_t>(context.body)].strain.topRows(6 * w.size());
  const Matrix6d root = elasticity_matrix(material).llt().matrixU();  // eps^T D eps = |U eps|^2
  const VectorXd tau = trapezoid_weights(answer.t);
  MatrixXd scaled(strain.rows(), strain.cols());
  for (Index k = 0; k < strain.cols(); ++k) {
    const auto eps = strain.col(k).reshaped(6, w.size());
    scaled.col(k) = (root * eps * (tau(k) * w).cwiseSqrt().asDiagonal()).reshaped();
  }
  return scaled;
}

}  // namespace mb
