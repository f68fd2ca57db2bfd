#include "modal/contact/sample_tree.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace mb {

namespace {

constexpr Index most_in_leaf = 6;  // samples

}  // namespace

SampleTree::SampleTree(const Matrix3Xd& X, const MatrixXd& shapes) : order_(static_cast<size_t>(X.cols())) {
  std::iota(order_.begin(), order_.end(), Index{0});
  if (!order_.empty()) split(X, 0, X.cols());
  measure(X, shapes);
}

// Into halves along the longest axis.
Index SampleTree::split(const Matrix3Xd& X, Index first, Index last) {
  const auto here = std::span(order_).subspan(static_cast<size_t>(first), static_cast<size_t>(last - first));
  Eigen::AlignedBox3d box;
  for (const Index i : here) box.extend(X.col(i));
  const Vector3d centre = box.center();
  const auto distance = [&](Index i) { return (X.col(i) - centre).squaredNorm(); };
  const auto g = std::ssize(groups_);
  groups_.push_back(
      {first, last, -1, -1, {*std::ranges::min_element(here, {}, distance), Vector3d::UnitX(), 0, 0, 0, 0}});
  if (last - first <= most_in_leaf) return g;
  Index axis;
  box.sizes().maxCoeff(&axis);
  const Index middle = (first + last) / 2;
  std::ranges::nth_element(here, here.begin() + (middle - first), {}, [&](Index i) { return X(axis, i); });
  const Index left = split(X, first, middle), right = split(X, middle, last);
  groups_[static_cast<size_t>(g)].left = left, groups_[static_cast<size_t>(g)].right = right;
  return g;
}

void SampleTree::measure(const Matrix3Xd& X, const MatrixXd& shapes) {
  spread_.setZero(shapes.cols(), std::ssize(groups_));
  for (Index g = 0; g < std::ssize(groups_); ++g) {
    const Group& group = groups_[static_cast<size_t>(g)];
    Extent& of = groups_[static_cast<size_t>(g)].extent;
    Matrix3Xd from_c(3, group.last - group.first);
    for (Index k = group.first; k < group.last; ++k) {
      const Index i = order_[static_cast<size_t>(k)], c = of.sample;
      from_c.col(k - group.first) = X.col(i) - X.col(c);
      const auto apart = shapes.middleRows(3 * i, 3) - shapes.middleRows(3 * c, 3);
      spread_.col(g) = spread_.col(g).cwiseMax(apart.colwise().norm().transpose());
    }
    const Matrix3Xd centred = from_c.colwise() - from_c.rowwise().mean();
    of.axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(centred * centred.transpose()).eigenvectors().col(0);
    const VectorXd along = from_c.transpose() * of.axis;
    of.least = along.minCoeff(), of.most = along.maxCoeff();
    of.across = (from_c - of.axis * along.transpose()).colwise().norm().maxCoeff();
    of.radius = from_c.colwise().norm().maxCoeff();
  }
}

SampleTree sample_tree(const SampledContact& contact) {
  const auto& [X, w, Phi, Psi] = contact.samples;
  const MatrixXd& Psi_b = contact.partner->Psi;
  MatrixXd shapes(3 * X.cols(), Phi.cols() + Psi.cols() + Psi_b.rows());
  shapes << Phi, Psi, Psi_b.transpose();
  return {X, shapes};
}

std::shared_ptr<const SampleTree> tree_of(const SampledContact& contact) {
  return contact.tree ? contact.tree : std::make_shared<const SampleTree>(sample_tree(contact));
}

}  // namespace mb
