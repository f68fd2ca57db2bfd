// What all contacts of a body do to it in one state: samples i of its surface feel the law (mechanics/contact/law.h),
//
//   f_i = w_i t(gap(x_i), v_i),    force = sum f_i,   torque = sum (x_i - c) x f_i,   modal = sum Phi_i^T Q^T f_i
//
// Static shapes are in balance with the forces they carry, K_s (s + beta s') = sum Psi_i^T Q^T f_i, s' by backward
// differences over the last two steps, at a touch's first step over one (BDF2, L-stable: beta may be far below the
// step): Newton's method in a few unknowns, a convex problem without friction. s' is left out of the law's damping.
// Against a half-space without friction only normal components are formed, once an orientation. Only samples are
// visited that can press (reach.h).
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

  // A step h [s] > 0 begins with the static shapes s: looks from now on are at its end. Before the first, and after
  // touch() again, they have no rate.
  void begin_step(const VectorXd& s, double h);
  void touch() { n_past_ = 0; }

  // -df/dz - rate df/dz' in the state looked at last, for frame (of a free body: 6) and modes, the static shapes
  // following in balance. rate [1/s].
  MatrixXd stiffness(const VectorXd& s, double rate);

 private:
  // s' = by_s s - past, of backward differences.
  double by_s() const { return n_past_ == 0 ? 0 : (n_past_ == 1 ? 1 : 1.5) / h_; }
  VectorXd past() const;

  bool settle(BodyState& state, const Vector3d& Omega);
  bool balance(VectorXd& s);

  const FloatingBody& body_;
  std::vector<std::unique_ptr<ContactPair>> pairs_;
  VectorXd r_, step_;              // n_s
  VectorXd before_, long_before_;  // n_s: s at the start of this step and the last
  double h_ = 0;
  int n_past_ = 0;  // of these
  MatrixXd H_;
  Eigen::PartialPivLU<MatrixXd> factor_;
};

}  // namespace mb
