// Which samples a body can bring to an obstacle, or to another body: the gaps of one state, the list's, ascending,
//
//   gap_i(now) >= gap_i(then) - moved,      moved, of both bodies:
//   |c - c'| + max|x| angle(Q, Q') + sum_k |q_k - q'_k| max_i |Phi_ik| + sum_k |s_k - s'_k| max_i |Psi_ik|
//
// so that a prefix of the order holds all that can press: a neighbour list (Verlet 1967, Phys. Rev. 159) with a skin as
// wide as the motion asks for. It is made anew as soon as the samples visited in vain since then are as many as were
// looked at for it, which costs at most twice the least possible.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "modal/frame/floating_body.h"

namespace mb {

// How far a body may have moved any of its points since it was last looked at.
class Wander {
 public:
  // longest [m]: of the points; largest displacements by mode and static shape, r and n_s.
  Wander(double longest, VectorXd largest_q, VectorXd largest_s);
  void look(const BodyState& state);                                  // from now on since this
  double operator()(const BodyState& state) const;                    // [m]
  double static_way(const VectorXd& s, const VectorXd& from) const {  // [m] by static shapes alone
    return largest_s_.dot((s - from).cwiseAbs());
  }

 private:
  double longest_;
  VectorXd largest_q_, largest_s_;
  Vector3d c_;
  Eigen::Quaterniond Q_;
  VectorXd q_, s_;
};

// The samples nearest to an obstacle: of a list.
struct Neighbours {
  std::vector<Index> order;  // samples, by gap
  std::vector<double> gap;   // [m] theirs or below, ascending
  double beyond = 0;         // [m] no other has a lesser one
  Index n_looked = 0;        // samples looked at for it
};

// How long a list is to be.
struct ListSize {
  Index n_least, n_spare;                     // samples; by those with gaps up to the margin
  double margin;                              // [m]
  bool enough(const Neighbours& list) const;  // of one that grows
};

class Reach {
 public:
  explicit Reach(const SampledContact& contact);  // must outlive this

  // The number of places of order that can press in a state, its static shapes being about to move no further than
  // twice as far as they last did. Asked for when the list is made anew: gaps(), [m] of all samples or below it, or
  // gaps(ListSize), the list itself. partner: the state of the other body, if it is one.
  template <class Gaps>
  Index n_reachable(const BodyState& state, const Gaps& gaps, const BodyState* partner = nullptr) {
    s_ = state.s;
    if (partner) partner_s_ = partner->s;
    if (!spent(state, partner)) return count(state, partner);
    if constexpr (std::is_invocable_v<Gaps, ListSize>)
      renew(state, partner, gaps(size()));
    else
      renew(state, partner, nearest(gaps()));
    return count(state, partner);
  }
  // Of the last count: whether it holds all that can press with other static shapes, too. If not, count again.
  bool covers(const VectorXd& s, const VectorXd* partner_s = nullptr);
  double beyond(const BodyState& state,
                const BodyState* partner = nullptr) const;  // [m] least gap of those not counted
  void pressed(Index n) { in_vain_ += n_ - n; }             // how many of those counted did press

  long n_lists() const { return n_lists_; }  // made so far: another one, another order
  Index operator[](Index place) const { return list_.order[static_cast<size_t>(place)]; }

 private:
  double moved(const BodyState& state, const BodyState* partner) const {
    return own_(state) + (partner ? (*partner_)(*partner) : 0);
  }
  bool spent(const BodyState& state, const BodyState* partner) const;
  ListSize size() const;
  Neighbours nearest(const VectorXd& gaps);
  void renew(const BodyState& state, const BodyState* partner, Neighbours list);
  Index count(const BodyState& state, const BodyState* partner);

  Index n_samples_;
  Wander own_;
  std::optional<Wander> partner_;
  Neighbours list_;         // beyond < 0: there is none yet
  VectorXd s_, partner_s_;  // of the last count
  double margin_ = 0;       // [m] that static shapes may move samples after it
  Index n_ = 0, in_vain_ = 0;
  long n_lists_ = 0;
};

}  // namespace mb
