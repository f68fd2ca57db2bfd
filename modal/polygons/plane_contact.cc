#include "modal/polygons/plane_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace mb {

HeightSamples::HeightSamples(const VectorXd& height, const VectorXd& weight) {
  if (height.size() != weight.size()) throw std::invalid_argument("samples: not as many weights as heights");
  if (!height.allFinite()) throw std::invalid_argument("samples: a height is not finite");
  if (!weight.allFinite() || !(weight.array() > 0).all())
    throw std::invalid_argument("samples: a weight is not positive and finite");
  std::vector<Index> order(static_cast<size_t>(height.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) { return height[i] < height[j]; });
  height_ = height(order);
  weight_ = weight(order);
}

PlaneContact HeightSamples::at(double depth) const {
  if (!std::isfinite(depth)) throw std::invalid_argument("samples: the depth is not finite");
  PlaneContact sum{0, 0, 0, 0, 0};
  for (Index i = 0; i < size() && height_[i] < depth; ++i) {
    const double g = depth - height_[i];
    sum.area += weight_[i];
    sum.force += weight_[i] * g;
    sum.energy += weight_[i] * g * g / 2;
    sum.depth = std::max(sum.depth, g);
    ++sum.n_touching;
  }
  return sum;
}

double HeightSamples::root_moment(double depth) const {
  if (!std::isfinite(depth)) throw std::invalid_argument("samples: the depth is not finite");
  double sum = 0;
  for (Index i = 0; i < size() && height_[i] < depth; ++i) sum += weight_[i] * std::sqrt(depth - height_[i]);
  return sum;
}

PlaneContact contact_by_curvatures(double k_1, double k_2, double depth) {
  if (!std::isfinite(k_1) || !std::isfinite(k_2) || k_1 < 0 || k_2 < 0)
    throw std::invalid_argument("contact by curvatures: a curvature is negative or not finite");
  if (!std::isfinite(depth)) throw std::invalid_argument("contact by curvatures: the depth is not finite");
  if (depth <= 0) return {0, 0, 0, 0, 0};
  const double root = std::sqrt(k_1) * std::sqrt(k_2);  // the product may underflow
  if (root == 0) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return {infinite, infinite, infinite, depth, 0};
  }
  const double area = 2 * pi * depth / root;
  return {area, area * depth / 2, area * depth * depth / 6, depth, 0};
}

}  // namespace mb
