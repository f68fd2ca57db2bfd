#include "mechanics/system/low_rank_damping.h"

namespace mb {

namespace {

bool has_one_entry_a_column(const MatrixXd& V) {
  for (Index j = 0; j < V.cols(); ++j)
    if ((V.col(j).array() != 0).count() > 1) return false;
  return true;
}

}  // namespace

LowRankDamping::LowRankDamping(double alpha, const MatrixXd& MR, const ModalDamping& modal_damping) {
  const auto& [W, d] = modal_damping;
  n_rigid_ = alpha != 0 ? MR.cols() : 0;
  const Index n_modal = (d.array() != 0).count();
  if (n_rigid_ + n_modal == 0) return;
  V_.resize(n_rigid_ > 0 ? MR.rows() : W.rows(), n_rigid_ + n_modal);
  e_ = VectorXd::Constant(n_rigid_ + n_modal, -alpha);
  if (n_rigid_ > 0) V_.leftCols(n_rigid_) = MR;
  for (Index i = 0, column = n_rigid_; i < d.size(); ++i) {
    if (d[i] == 0) continue;
    V_.col(column) = W.col(i);
    e_[column++] = d[i];
  }
  if (has_one_entry_a_column(V_)) {
    diagonal_ = V_.cwiseAbs2() * e_;
    V_.resize(0, 0);
    e_.resize(0);
    n_rigid_ = 0;
  }
  coordinates_.resize(e_.size());
}

void LowRankDamping::add_product(double factor, const VectorXd& v, VectorXd& y) const {
  if (diagonal_.size() > 0) y.noalias() += factor * diagonal_.cwiseProduct(v);
  if (rank() == 0) return;
  coordinates_.noalias() = V_.transpose() * v;
  coordinates_.array() *= factor * e_.array();
  y.noalias() += V_ * coordinates_;
}

}  // namespace mb
