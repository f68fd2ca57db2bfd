#include "modal/bases/mode_pairs.h"

#include <algorithm>
#include <cmath>

namespace mb {

namespace {

constexpr double least_alike = 0.05, of_best = 0.5;  // [-] of MAC

}  // namespace

MatrixXd seen_at(const FullModel& full, const Quadrature& volume, const MatrixXd& Phi) {
  MatrixXd at = full.displacement_at(volume.points) * Phi;
  for (Index p = 0; p < volume.weights.size(); ++p) at.middleRows<3>(3 * p) *= std::sqrt(volume.weights[p]);
  at.colwise().normalize();
  return at;
}

ModePairs mode_pairs(const MatrixXd& own, const MatrixXd& other) {
  const MatrixXd mac = (own.transpose() * other).cwiseAbs2();
  ModePairs pairs(static_cast<std::size_t>(mac.rows()));
  for (Index i = 0; i < mac.rows() && mac.cols() > 0; ++i) {
    const double least = std::max(least_alike, of_best * mac.row(i).maxCoeff());
    for (Index j = 0; j < mac.cols(); ++j)
      if (mac(i, j) >= least) pairs[static_cast<std::size_t>(i)].push_back(j);
  }
  return pairs;
}

Index farthest(double omega, const VectorXd& omega_of_other, const std::vector<Index>& pairs) {
  const auto off = [&](Index j) { return std::abs(omega_of_other[j] - omega); };
  const auto most = std::ranges::max_element(pairs, {}, off);
  return most == pairs.end() ? -1 : *most;
}

}  // namespace mb
