// What all contacts of a body do to it in one state: samples i of its surface feel the law (mechanics/contact/law.h),
//
//   f_i = w_i t(gap(x_i), v_i),    force = sum f_i,   torque = sum (x_i - c) x f_i,   modal = sum Phi_i^T Q^T f_i
//
// Static shapes are in balance with the forces they carry, K_s s = sum Psi_i^T Q^T f_i: Newton's method in a few
// unknowns, a convex problem without friction. Their rate is left out of the law's damping. Against a half-space
// without friction only normal components are formed, once an orientation. Only samples are visited that can press
// (reach.h).
#pragma once

#include <memory>
#include <vector>

#include "modal/contact/floating_body.h"

namespace mb {

struct ContactLoad {
  Vector3d force, torque;      // [N], [N m] about c; world
  VectorXd modal;              // [N kg^-1/2] r
  double least_gap;            // [m] over the samples visited; infinity: none was
  double stored, dissipation;  // [J] in the layer and in static shapes; [W]
  long n_visited;              // samples
  bool converged;              // the static shapes are in balance
};

class ContactPair;

class ContactLoads {
 public:
  explicit ContactLoads(const FloatingBody& body);  // must outlive this
  ~ContactLoads();
  ContactLoads(ContactLoads&&) noexcept;

  // state.s: where the search for the static shapes begins, and what it found. `load` is reused. One thread at a time.
  void operator()(BodyState& state, const Vector3d& Omega, ContactLoad& load);

  // -df/dz - rate df/dz' in the state looked at last, for frame (of a free body: 6) and modes, the static shapes
  // following in balance. rate [1/s].
  MatrixXd stiffness(const VectorXd& s, double rate);

 private:
  bool settle(BodyState& state, const Vector3d& Omega);
  bool balance(VectorXd& s);

  const FloatingBody& body_;
  std::vector<std::unique_ptr<ContactPair>> pairs_;
  VectorXd r_, step_;  // n_s
  MatrixXd H_;
  Eigen::PartialPivLU<MatrixXd> factor_;
};

}  // namespace mb
