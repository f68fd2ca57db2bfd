// The samples of a surface that come nearest to another body, without looking at all of them: a tree of groups, each
// about a sample c of its own,
//
//   n . (x_i - x_c) >= least n . (X_i - X_c) - sum_k |q_k| max |Phi_ik - Phi_ck| - sum_k |s_k| max |Psi_ik - Psi_ck|
//
// in the body's axes. A convex body's signed distance is convex: d(x_i) >= d(x_c) + grad d . (x_i - x_c), so that the
// gap at c bounds those of the group. Best first (Hjaltason & Samet 1999, ACM Trans. Database Syst. 24): what has the
// least bound is looked at next, and samples come out in the order of their gaps.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "modal/contact/reach.h"
#include "modal/frame/floating_body.h"

namespace mb {

class SampleTree {
 public:
  // X [m] 3 x m; shapes 3 m x n: of all coordinates that move a sample, modes and static shapes.
  SampleTree(const Matrix3Xd& X, const MatrixXd& shapes);

  // A sample, or all of a group about it.
  struct Extent {
    Index sample;                            // c
    Vector3d axis;                           // along which a group is thinnest
    double least, most;                      // [m] along it, from c: the former <= 0, the latter >= 0
    double across, radius;                   // [m] from that axis, from c
    double spread = 0;                       // [m] what shapes add
    double along(const Vector3d& n) const {  // [m] least n . (X_i - X_c), n of unit length
      const double x = n.dot(axis);
      return (x > 0 ? x * least : x * most) - std::sqrt(std::max(0.0, 1 - x * x)) * across;
    }
  };
  // The samples with the least gaps, as many as `size` asks for, if there are. bound(extent): [m] what no gap is below
  // there. sizes: |q| of the shapes' coordinates.
  template <class Bound>
  Neighbours nearest(const Bound& bound, const VectorXd& sizes, const ListSize& size) const;

 private:
  struct Group {
    Index first, last;  // members, places in order_
    Index left, right;  // groups; < 0: none
    Extent extent;
  };
  struct Found {
    double bound;                                                             // [m]
    Index what;                                                               // a sample; -1 - group
    bool operator<(const Found& other) const { return bound > other.bound; }  // of the queue's top the least
  };
  Index split(const Matrix3Xd& X, Index first, Index last);
  void measure(const Matrix3Xd& X, const MatrixXd& shapes);
  std::vector<Index> order_;
  std::vector<Group> groups_;  // the whole is the first
  MatrixXd spread_;            // n x number of groups
};

// Of a contact with a partner: modes and static shapes of the body, static shapes of the partner.
SampleTree sample_tree(const SampledContact& contact);
// The contact's own if it has it, else made.
std::shared_ptr<const SampleTree> tree_of(const SampledContact& contact);

template <class Bound>
Neighbours SampleTree::nearest(const Bound& bound, const VectorXd& sizes, const ListSize& size) const {
  Neighbours found;
  std::vector<Found> queue;
  const auto add = [&](double at, Index what) {
    queue.push_back({at, what});
    std::push_heap(queue.begin(), queue.end());
    ++found.n_looked;
  };
  const auto add_group = [&](Index g) {
    Extent of = groups_[static_cast<size_t>(g)].extent;
    of.spread = spread_.col(g).dot(sizes);
    add(bound(of), -1 - g);
  };
  if (!order_.empty()) add_group(0);
  while (!queue.empty() && !size.enough(found)) {
    std::pop_heap(queue.begin(), queue.end());
    const auto [least, what] = queue.back();
    queue.pop_back();
    if (what >= 0) {
      found.order.push_back(what);
      found.gap.push_back(least);
      continue;
    }
    const Group& group = groups_[static_cast<size_t>(-1 - what)];
    if (group.left >= 0) {
      add_group(group.left);
      add_group(group.right);
    } else {
      for (Index k = group.first; k < group.last; ++k) {
        const Index i = order_[static_cast<size_t>(k)];
        add(bound(Extent{i, Vector3d::UnitX(), 0, 0, 0, 0}), i);
      }
    }
  }
  found.beyond = queue.empty() ? std::numeric_limits<double>::infinity() : queue.front().bound;
  return found;
}

}  // namespace mb
