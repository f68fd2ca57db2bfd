// What samples in reach do to both bodies (body_pair.h).
#include <vector>

#include "modal/contact/body_pair.h"
#include "modal/frame/turn.h"

namespace mb {

Matrix3Xd BodyPair::rows(Index k) const {
  Matrix3Xd all(3, a_.n_static() + b_.n_static());
  all.leftCols(a_.n_static()).noalias() = Q_a_ * near_.Psi.middleCols<3>(3 * k).transpose();
  all.rightCols(b_.n_static()).noalias() = -Q_b_ * near_.Psi_b.middleCols<3>(3 * k).transpose();
  return all;
}

Vector3d BodyPair::moved(Index k, const VectorXd& s) const {
  if (a_.n_static() == 0) return Vector3d::Zero();
  return Q_a_ * near_.Psi.middleCols<3>(3 * k).transpose().lazyProduct(s.head(a_.n_static()));
}

Vector3d BodyPair::traction(Index k, double gap) const {
  const Vector3d n = near_.n.col(k);
  if (!feels_rates_) return layer(contact_.law, gap).pressure * n;
  return contact_traction(contact_.law, {gap, n, Eigen::Matrix3d::Zero()}, near_.v.col(k)).t;
}

void BodyPair::push(const VectorXd& s, VectorXd& f_s, MatrixXd& H) {
  const PenaltyLaw& law = contact_.law;
  const VectorXd gap = near_.gap.head(n_) + near_.gap_by_s.leftCols(n_).transpose() * s;
  for (Index k = 0; k < n_; ++k) {
    if (!(gap[k] < 0)) continue;
    const double w = contact_.samples.w[reach_[k]];
    if (!feels_rates_) {
      const auto [pressure, by_gap] = layer(law, gap[k]);
      const auto along = near_.gap_by_s.col(k);
      f_s.noalias() += (w * pressure) * along;
      H.noalias() -= (w * by_gap) * along * along.transpose();
      continue;
    }
    const Traction3 t = contact_traction(law, {gap[k], near_.n.col(k), Eigen::Matrix3d::Zero()}, near_.v.col(k));
    const Matrix3Xd R = rows(k);
    f_s.noalias() += w * (R.transpose() * t.t);
    H.noalias() -= w * (R.transpose() * t.by_x * R);
  }
}

void BodyPair::act(const VectorXd& s, ContactLoad& a, ContactLoad& b) {
  a.n_visited += n_;
  if (n_ == 0) return;
  const VectorXd gap = near_.gap.head(n_) + near_.gap_by_s.leftCols(n_).transpose() * s;
  a.least_gap = std::min(a.least_gap, gap.minCoeff());
  b.least_gap = std::min(b.least_gap, a.least_gap);
  VectorXd on_a = VectorXd::Zero(3 * n_);  // [N] in a's axes
  Matrix3Xd on_b(3, n_), Y(3, n_);         // [N] and [m] in b's, of those that press
  Index n_pressing = 0;
  for (Index k = 0; k < n_; ++k) {
    if (!(gap[k] < 0)) continue;
    const double w = contact_.samples.w[reach_[k]];
    const Vector3d f = w * traction(k, gap[k]), x = near_.x.col(k) + moved(k, s);
    a.force += f;
    a.torque += (x - at_a_.state->c).cross(f);
    a.stored += w * stored_energy(contact_.law, gap[k]);
    if (feels_rates_) {
      const Vector3d v = near_.v.col(k);
      a.dissipation -= f.dot(v) - w * layer(contact_.law, gap[k]).pressure * near_.n.col(k).dot(v);
    }
    b.force -= f;
    b.torque -= (x - at_b_.state->c).cross(f);
    on_a.segment<3>(3 * k) = Q_a_.transpose() * f;
    on_b.col(n_pressing) = -(Q_b_.transpose() * f);
    Y.col(n_pressing++) = near_.Y.col(k);
  }
  reach_.pressed(n_pressing);
  if (n_pressing == 0) return;
  a.modal.noalias() += near_.Phi.leftCols(3 * n_) * on_a;
  const MatrixXd moments =
      on_b.leftCols(n_pressing) * surface_.geometry.monomials().values(Y.leftCols(n_pressing));  // 3 x monomials
  b.modal.noalias() += surface_.geometry.coefficients().transpose() * moments.reshaped();
}

void BodyPair::stiffen(const VectorXd& s, double rate, MatrixXd& K) {
  const Index f_a = a_.free ? 6 : 0, f_b = b_.free ? 6 : 0, r_a = a_.n_modes(), r_b = b_.n_modes(), at_b = f_a + r_a;
  if (n_ == 0) return;
  const VectorXd gap = near_.gap.head(n_) + near_.gap_by_s.leftCols(n_).transpose() * s;
  MatrixXd G(3, K.rows());
  for (Index k = 0; k < n_; ++k) {
    if (!(gap[k] < 0)) continue;
    const Vector3d v = feels_rates_ ? Vector3d(near_.v.col(k)) : Vector3d::Zero();
    const Traction3 t = contact_traction(contact_.law, {gap[k], near_.n.col(k), Eigen::Matrix3d::Zero()}, v);
    const Vector3d arm = near_.x.col(k) + moved(k, s) - at_a_.state->c;
    if (a_.free) G.leftCols<3>().setIdentity(), G.middleCols<3>(3) = turning(arm);
    G.middleCols(f_a, r_a) = Q_a_ * near_.Phi.middleCols<3>(3 * k).transpose();
    if (b_.free)
      G.middleCols<3>(at_b) = -Eigen::Matrix3d::Identity(), G.middleCols<3>(at_b + 3) = -turning(Q_b_ * near_.y.col(k));
    G.middleCols(at_b + f_b, r_b) = -Q_b_ * surface_.geometry.at(near_.Y.col(k));
    G.rightCols(s.size()) = rows(k);
    MatrixXd G_rate = G;  // that of static shapes is left out
    G_rate.rightCols(s.size()).setZero();
    K.noalias() -= contact_.samples.w[reach_[k]] * G.transpose() * (t.by_x * G + rate * t.by_v * G_rate);
  }
}

}  // namespace mb
