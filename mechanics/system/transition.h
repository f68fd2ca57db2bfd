// All modes over a time tau in a piece, from local time tau0 on:
//
//   q+ = C q + S v + A0 + tau0 A1 + sum_w (a_w X_w + b_w Y_w)
//   v+ = C'q + S'v + B0 + tau0 B1 + sum_w (a_w X'_w + b_w Y'_w)
//
// with A0 = P p0 + R p1, A1 = P p1, B0 = S p0 + P p1, B1 = S p1 for the line p0 + p1 tau of modal forces, and a_w, b_w
// the amplitudes of wave w as seen from tau0. With every function replaced by its integral over [0, tau], q+ and v+ are
// the integrals of q and v over that time. Made once for a step that is repeated.
#pragma once

#include <vector>

#include "mechanics/system/modal_motion.h"

namespace mb {

class Transition {
 public:
  enum class Of { state, integral };
  Transition(const ModalMotion& motion, Of of);  // the motion must outlive it

  void make(const Piece& piece, double tau);  // a workspace: columns are reused

  // From column `from` of q and v at local time tau0 to column `to` of q1 and v1.
  void apply(const MatrixXd& q, const MatrixXd& v, Index from, MatrixXd& q1, MatrixXd& v1, Index to, const Piece& piece,
             double tau0) const;

 private:
  void fill(Index i, const Piece& piece, double tau);

  const ModalMotion& motion_;
  Of of_;
  MatrixXd table_;
  std::vector<std::size_t> waves_;
};

}  // namespace mb
