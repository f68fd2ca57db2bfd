// Which samples a body can bring to an obstacle: gaps of the undeformed samples at a pose that is not far, ascending,
//
//   gap_i(now) >= gap_i(then) - |c - c_then| - max|X| angle(Q, Q_then) - max|u|
//
// so that a prefix of the order holds all that can touch. Made anew when the body has moved on.
#pragma once

#include <vector>

#include "modal/contact/floating_body.h"

namespace mb {

class Reach {
 public:
  explicit Reach(const SampledContact& contact);  // must outlive this
  // The number of samples of order() that can have a gap below zero; deformation [m]: a bound of |u| of all samples.
  Index n_reachable(const Vector3d& c, const Eigen::Quaterniond& Q, double deformation);
  Index operator[](Index place) const { return order_[static_cast<size_t>(place)]; }

 private:
  void renew(const Vector3d& c, const Eigen::Quaterniond& Q);

  const SampledContact& contact_;
  double longest_;  // [m] |X|
  std::vector<Index> order_;
  std::vector<double> gap_;  // [m] ascending, at c_ and Q_
  Vector3d c_ = Vector3d::Zero();
  Eigen::Quaterniond Q_{1, 0, 0, 0};
};

// Bounds [m] of each shape's displacement over all samples: max_i |Phi_ik|.
VectorXd largest_displacements(const MatrixXd& shapes);

}  // namespace mb
