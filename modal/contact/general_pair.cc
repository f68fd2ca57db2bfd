#include "modal/contact/reach.h"
#include "modal/contact/sample_tables.h"
#include "modal/contact/sampled_pair.h"
#include "modal/frame/turn.h"

namespace mb {

namespace {

class GeneralPair final : public SampledPair {
 public:
  GeneralPair(const FloatingBody& body, const SampledContact& contact)
      : body_(body),
        contact_(contact),
        reach_(contact),
        tables_(tables_of(contact)),
        Phi_(tables_->Phi),
        Psi_(tables_->Psi),
        x_(3, contact.samples.w.size()),
        v_(3, contact.samples.w.size()) {}

  void look(const BodyState& state, const Vector3d& Omega, const VectorXd& rate) override {
    state_ = &state;
    n_ = reach_.n_reachable(state, [&] { return gaps(state); });
    const Eigen::Matrix3d Q = state.Q.toRotationMatrix();
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      const auto Phi = Phi_.middleCols(3 * i, 3);
      const Vector3d r = Q * (contact_.samples.X.col(i) + Phi.transpose() * state.q);
      x_.col(k) = state.c + r;
      v_.col(k) = state.v + Omega.cross(r) + Q * (Phi.transpose() * rate);
    }
  }

  void push(const VectorXd& s, VectorXd& f_s, MatrixXd& H) override {
    const Eigen::Matrix3d Q = state_->Q.toRotationMatrix();
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      const auto Psi = Psi_.middleCols(3 * i, 3);
      const Vector3d x = x_.col(k) + Q * (Psi.transpose() * s);
      if (!(gap_value(contact_.surface, x) < 0)) continue;
      const Traction3 t = contact_traction(contact_.law, gap(contact_.surface, x), v_.col(k));
      const double w = contact_.samples.w[i];
      f_s.noalias() += w * (Psi * (Q.transpose() * t.t));
      H.noalias() -= w * (Psi * (Q.transpose() * t.by_x * Q) * Psi.transpose());
    }
  }

  bool covers(const VectorXd& s) override { return reach_.covers(s); }

  void act(const VectorXd& s, ContactLoad& load) override {
    const Eigen::Matrix3d Q = state_->Q.toRotationMatrix();
    Index n_pressing = 0;
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      const Vector3d x = x_.col(k) + Q * (Psi_.middleCols(3 * i, 3).transpose() * s), v = v_.col(k);
      const double value = gap_value(contact_.surface, x);
      load.least_gap = std::min(load.least_gap, value);
      if (!(value < 0)) continue;
      ++n_pressing;
      const Gap at = gap(contact_.surface, x);
      const double w = contact_.samples.w[i];
      const Vector3d f = w * contact_traction(contact_.law, at, v).t;
      load.force += f;
      load.torque += (x - state_->c).cross(f);
      load.modal.noalias() += Phi_.middleCols(3 * i, 3) * (Q.transpose() * f);
      load.stored += w * stored_energy(contact_.law, value);
      load.dissipation -= f.dot(v) - w * layer(contact_.law, value).pressure * at.normal.dot(v);
    }
    load.n_visited += n_;
    reach_.pressed(n_pressing);
  }

  void stiffen(const VectorXd& s, double rate, MatrixXd& K) override {
    const Eigen::Matrix3d Q = state_->Q.toRotationMatrix();
    const Index n_frame = body_.free ? 6 : 0, r = body_.n_modes();
    MatrixXd G(3, K.rows()), G_rate(3, K.rows());  // by place and by rate: that of static shapes is left out
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      const Vector3d x = x_.col(k) + Q * (Psi_.middleCols(3 * i, 3).transpose() * s);
      if (!(gap_value(contact_.surface, x) < 0)) continue;
      const Traction3 t = contact_traction(contact_.law, gap(contact_.surface, x), v_.col(k));
      if (body_.free) {
        G.leftCols<3>().setIdentity();
        G.middleCols<3>(3) = turning(x - state_->c);
        G_rate.leftCols<3>().setIdentity();
        G_rate.middleCols<3>(3) = turning(x_.col(k) - state_->c);
      }
      G.middleCols(n_frame, r) = Q * Phi_.middleCols(3 * i, 3).transpose();
      G.rightCols(s.size()) = Q * Psi_.middleCols(3 * i, 3).transpose();
      G_rate.middleCols(n_frame, r) = G.middleCols(n_frame, r);
      G_rate.rightCols(s.size()).setZero();
      K.noalias() -= contact_.samples.w[i] * G.transpose() * (t.by_x * G + rate * t.by_v * G_rate);
    }
  }

 private:
  VectorXd gaps(const BodyState& state) const {
    VectorXd all(contact_.samples.w.size());
    for (Index i = 0; i < all.size(); ++i) {
      const Vector3d u =
          Phi_.middleCols(3 * i, 3).transpose() * state.q + Psi_.middleCols(3 * i, 3).transpose() * state.s;
      all[i] = gap_value(contact_.surface, state.c + state.Q * (contact_.samples.X.col(i) + u));
    }
    return all;
  }

  const FloatingBody& body_;
  const SampledContact& contact_;
  Reach reach_;
  std::shared_ptr<const SampleTables> tables_;
  const MatrixXd &Phi_, &Psi_;  // r x 3 m, n_s x 3 m
  Matrix3Xd x_, v_;             // of the samples in reach, in their order
  Index n_ = 0;
  const BodyState* state_ = nullptr;
};

}  // namespace

std::unique_ptr<SampledPair> general_pair(const FloatingBody& body, const SampledContact& contact) {
  return std::make_unique<GeneralPair>(body, contact);
}

}  // namespace mb
