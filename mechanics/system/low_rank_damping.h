// The damping of a System as what is sparse and what has low rank:
//
//   C = alpha M + beta K + V diag(e) V^T,    V = [M R, W],   e = [-alpha, d]
#pragma once

#include "mechanics/system/system.h"

namespace mb {

// V diag(e) V^T, without columns that do nothing. Where every column of V has one entry at most, as in a system reduced
// to its own eigenmodes, that is a diagonal matrix and V is not kept.
class LowRankDamping {
 public:
  LowRankDamping() = default;  // none
  // MR: n x m; columns are kept where alpha [1/s] is not 0.
  LowRankDamping(double alpha, const MatrixXd& MR, const ModalDamping& modal_damping);

  const VectorXd& diagonal() const { return diagonal_; }  // n, or 0 where V is kept or there is no damping
  const MatrixXd& V() const { return V_; }                // n x rank
  const VectorXd& e() const { return e_; }                // [1/s] rank; its first n_rigid() are -alpha
  Index n_rigid() const { return n_rigid_; }
  Index rank() const { return e_.size(); }

  // y += factor V diag(e) V^T v, without allocation; one thread at a time.
  void add_product(double factor, const VectorXd& v, VectorXd& y) const;

 private:
  VectorXd diagonal_, e_;
  MatrixXd V_;
  Index n_rigid_ = 0;
  mutable VectorXd coordinates_;  // rank
};

}  // namespace mb
