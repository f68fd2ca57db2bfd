#include "harness/metrics/linearity.h"

#include <limits>

#include "harness/metrics/motion.h"
#include "mechanics/geometry/polynomial.h"

namespace mb {

double largest_strain(const Trajectory& trajectory, const MetricContext& context) {
  const MatrixXd& strain = trajectory.bodies[static_cast<std::size_t>(context.body)].strain;
  if (strain.cols() == 0) return std::numeric_limits<double>::quiet_NaN();
  const auto all = strain.reshaped(6, strain.size() / 6);
  double largest = 0;
  for (Index k = 0; k < all.cols(); ++k) {
    const auto e = all.col(k);                                 // xx yy zz yz xz xy, engineering
    if (!(e.squaredNorm() > largest * largest / 2)) continue;  // |eigenvalue|^2 <= eps:eps <= 2 |e|^2
    Eigen::Matrix3d eps;
    eps << e[0], e[5] / 2, e[4] / 2, e[5] / 2, e[1], e[3] / 2, e[4] / 2, e[3] / 2, e[2];
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(eps, Eigen::EigenvaluesOnly);
    largest = std::max(largest, solver.eigenvalues().cwiseAbs().maxCoeff());
  }
  return largest;
}

double largest_rotation(const Trajectory& trajectory, const MetricContext& context) {
  constexpr int degree = 3;
  const MatrixXd u = motion(trajectory, context).volume;
  const Monomials monomials = monomials_about(context.points.volume.points, degree);
  // Points across a thin body stand in fewer layers than a cubic has coefficients: what they do not tell stays out.
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> fit;
  fit.setThreshold(1e-6);
  fit.compute(monomials.values(context.points.volume.points));
  const auto by = monomials.gradients(context.points.volume.points);
  double squared = 0;
  for (Index k = 0; k < u.cols(); ++k) {
    const MatrixXd a = fit.solve(u.col(k).reshaped(3, u.rows() / 3).transpose());  // one column a component
    const auto d = [&](int component, int axis) -> VectorXd {
      return by[static_cast<std::size_t>(axis)] * a.col(component);
    };
    const VectorXd curl =
        (d(2, 1) - d(1, 2)).cwiseAbs2() + (d(0, 2) - d(2, 0)).cwiseAbs2() + (d(1, 0) - d(0, 1)).cwiseAbs2();
    squared = std::max(squared, curl.maxCoeff());
  }
  return std::sqrt(squared) / 2;
}

}  // namespace mb
