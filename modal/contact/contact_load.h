// What all contacts of bodies that move together do to them in one state: samples i of its surface feel the law
// (mechanics/contact/law.h),
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
#include <span>
#include <utility>
#include <vector>

#include "modal/frame/floating_body.h"

namespace mb {

struct ContactLoad {
  Vector3d force, torque;      // [N], [N m] about c; world
  VectorXd modal;              // [N kg^-1/2] r
  double least_gap;            // [m] over the samples visited; infinity: none was
  double stored, dissipation;  // [J] in the layer and in static shapes; [W]
  long n_visited;              // samples
  bool converged;              // the static shapes are in balance
};

// A body as contact looks at it. state.s: where the search for the static shapes begins, and what it found. `load` is
// reused.
struct Looked {
  BodyState* state;
  Vector3d Omega;        // [rad/s] world
  const VectorXd* rate;  // [m kg^1/2 / s] q'
  ContactLoad* load;
};

class BodyPair;
class SampledPair;

class ContactLoads {
 public:
  explicit ContactLoads(std::vector<const FloatingBody*> bodies);  // which must outlive this
  explicit ContactLoads(const FloatingBody& body) : ContactLoads(std::vector{&body}) {}
  ~ContactLoads();
  ContactLoads(ContactLoads&&) noexcept;

  void operator()(std::span<const Looked> bodies);  // one thread at a time
  void operator()(BodyState& state, const Vector3d& Omega, ContactLoad& load) {
    const Looked one{&state, Omega, &state.p, &load};
    (*this)({&one, 1});
  }

  // A step h [s] > 0 begins with the static shapes s, body after body: looks from now on are at its end. Before the
  // first, and after touch() again, they have no rate.
  void begin_step(const VectorXd& s, double h);
  void touch() { n_past_ = 0; }

  // -df/dz - rate df/dz' in the state looked at last, for frames (of a free body: 6) and modes, body after body, the
  // static shapes s following in balance. rate [1/s].
  MatrixXd stiffness(const VectorXd& s, double rate);

 private:
  // Where a body's own unknowns are among all: frame and modes, static shapes.
  struct Place {
    Index z, n_z, s, n_s;
  };
  struct OfBody {
    size_t body;
    std::unique_ptr<SampledPair> pair;
  };
  struct OfTwo {
    size_t a, b;
    std::unique_ptr<BodyPair> pair;
  };
  // s' = by_s s - past, of backward differences.
  double by_s() const { return n_past_ == 0 ? 0 : (n_past_ == 1 ? 1 : 1.5) / h_; }
  VectorXd past() const;

  void look(std::span<const Looked> bodies);
  bool settle(std::span<const Looked> bodies);
  bool balance(VectorXd& s);
  void push(const VectorXd& s);  // adds to r_ and H_
  bool covers(const VectorXd& s);
  VectorXd own(const VectorXd& s, size_t body) const { return s.segment(places_[body].s, places_[body].n_s); }
  VectorXd of_both(const VectorXd& s, const OfTwo& of) const;
  std::vector<Index> unknowns(const OfTwo& of) const;  // of both: z, then n_z + s

  std::vector<const FloatingBody*> bodies_;
  std::vector<Place> places_;
  Index n_z_ = 0, n_s_ = 0;
  VectorXd beta_;              // [s] n_s: static damping
  MatrixXd static_stiffness_;  // [J] n_s x n_s
  std::vector<OfBody> pairs_;
  std::vector<OfTwo> between_;
  VectorXd r_, step_, s_;          // n_s
  VectorXd before_, long_before_;  // n_s: s at the start of this step and the last
  double h_ = 0;
  int n_past_ = 0;  // of these
  MatrixXd H_;
  Eigen::PartialPivLU<MatrixXd> factor_;
};

}  // namespace mb
