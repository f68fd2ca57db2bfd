#include "modal/contact/reach.h"

#include <algorithm>
#include <numeric>

namespace mb {

namespace {

constexpr double far = 0.05;  // [-] of the body's size: what a list still serves after

}  // namespace

Reach::Reach(const SampledContact& contact)
    : contact_(contact), longest_(std::sqrt(contact.samples.X.colwise().squaredNorm().maxCoeff())) {}

void Reach::renew(const Vector3d& c, const Eigen::Quaterniond& Q) {
  c_ = c;
  Q_ = Q;
  const Index m = contact_.samples.X.cols();
  std::vector<double> gap(static_cast<size_t>(m));
  for (Index i = 0; i < m; ++i)
    gap[static_cast<size_t>(i)] = gap_value(contact_.surface, c + Q * contact_.samples.X.col(i));
  order_.resize(gap.size());
  std::iota(order_.begin(), order_.end(), Index{0});
  std::ranges::sort(order_, {}, [&](Index i) { return gap[static_cast<size_t>(i)]; });
  gap_.clear();
  for (const Index i : order_) gap_.push_back(gap[static_cast<size_t>(i)]);
}

Index Reach::n_reachable(const Vector3d& c, const Eigen::Quaterniond& Q, double deformation) {
  const auto moved = [&] {
    return (c - c_).norm() + longest_ * 2 * (Q.vec() * Q_.w() - Q_.vec() * Q.w() - Q.vec().cross(Q_.vec())).norm();
  };
  if (order_.empty() || !(moved() <= far * longest_)) renew(c, Q);
  const auto end = std::ranges::upper_bound(gap_, moved() + deformation);
  return end - gap_.begin();
}

VectorXd largest_displacements(const MatrixXd& shapes) {
  VectorXd largest(shapes.cols());
  for (Index k = 0; k < shapes.cols(); ++k)
    largest[k] = shapes.rows() == 0
                     ? 0
                     : std::sqrt(shapes.col(k).reshaped(3, shapes.rows() / 3).colwise().squaredNorm().maxCoeff());
  return largest;
}

}  // namespace mb
