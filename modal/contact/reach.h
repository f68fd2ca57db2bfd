// Which samples a body can bring to an obstacle: the gaps of one state, the list's, ascending,
//
//   gap_i(now) >= gap_i(then) - moved,
//   moved = |c - c'| + max|x| angle(Q, Q') + sum_k |q_k - q'_k| max_i |Phi_ik| + sum_k |s_k - s'_k| max_i |Psi_ik|
//
// so that a prefix of the order holds all that can press: a neighbour list (Verlet 1967, Phys. Rev. 159) with a skin as
// wide as the motion asks for. It is made anew as soon as the samples visited in vain since then are as many as there
// are, which costs at most twice the least possible.
#pragma once

#include <vector>

#include "modal/contact/floating_body.h"

namespace mb {

class Reach {
 public:
  explicit Reach(const SampledContact& contact);  // must outlive this

  // The number of places of order that can press in a state, its static shapes being about to move no further than
  // twice as far as they last did. `gaps`, [m] of all samples, is asked for when the list is made anew.
  template <class Gaps>
  Index n_reachable(const BodyState& state, const Gaps& gaps) {
    state_s_ = state.s;
    if (spent(state)) renew(state, gaps());
    return count(state);
  }
  // Of the last count: whether it holds all that can press with other static shapes, too. If not, count again.
  bool covers(const VectorXd& s);
  void pressed(Index n) { in_vain_ += n_ - n; }  // how many of those counted did press

  long n_lists() const { return n_lists_; }  // made so far: another one, another order
  Index operator[](Index place) const { return order_[static_cast<size_t>(place)]; }

 private:
  bool spent(const BodyState& state) const;
  void renew(const BodyState& state, const VectorXd& gaps);
  Index count(const BodyState& state);
  double moved(const BodyState& state) const;

  Index n_samples_;
  double longest_;                  // [m] |X|
  VectorXd largest_q_, largest_s_;  // max_i |Phi_ik|, max_i |Psi_ik|
  std::vector<Index> order_;
  std::vector<double> gap_;  // [m] ascending, of the list alone
  double beyond_ = -1;       // [m] no sample outside the list had a lesser gap; < 0: there is no list yet
  Vector3d c_;               // the list's state
  Eigen::Quaterniond Q_;
  VectorXd q_, s_;
  VectorXd state_s_;   // of the last count
  double margin_ = 0;  // [m] that static shapes may move samples after it
  Index n_ = 0, in_vain_ = 0;
  long n_lists_ = 0;
};

}  // namespace mb
