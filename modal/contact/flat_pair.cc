#include "modal/contact/reach.h"
#include "modal/contact/sample_tables.h"
#include "modal/contact/sampled_pair.h"

namespace mb {

namespace {

//   gap_i = n . (c - a) + n_b . X_i + (n_b^T Phi_i) q + (n_b^T Psi_i) s,    n_b = Q^T n,   a a point of the plane
//
// The rows n_b^T Phi_i and n_b^T Psi_i stand together in the order of the samples in reach, so that gaps and forces of
// all of them are products with two narrow matrices; of static shapes, a few, shape by shape: long sums.
class FlatPair final : public SampledPair {
 public:
  FlatPair(const FloatingBody& body, const SampledContact& contact)
      : body_(body),
        contact_(contact),
        normal_(contact.surface.pose.orientation * Vector3d::UnitZ()),
        reach_(contact),
        tables_(tables_of(contact)),
        Phi_(tables_->Phi),
        Psi_(tables_->Psi),
        rows_(Phi_.rows(), n_samples()),
        static_rows_(n_samples(), Psi_.rows()),
        pushing_(n_samples(), Psi_.rows()) {
    for (VectorXd* x : {&height_, &gap_, &rate_, &deformed_, &force_, &slope_}) x->resize(n_samples());
  }

  void look(const BodyState& state, const Vector3d& Omega, const VectorXd& rate) override {
    state_ = &state;
    turn_to(state.Q.conjugate() * normal_);
    n_ = reach_.n_reachable(state, [&] { return gaps(state); });
    gather();
    const double height = normal_.dot(state.c - contact_.surface.pose.position);
    gap_.head(n_).noalias() = rows_.leftCols(n_).transpose() * state.q;
    gap_.head(n_).array() += height + height_.head(n_).array();
    if (contact_.law.damping == 0) {
      rate_.head(n_).setZero();
      return;
    }
    rate_.head(n_).noalias() = rows_.leftCols(n_).transpose() * rate;
    rate_.head(n_).array() += normal_.dot(state.v);
    if (Omega.isZero(0)) return;
    const Vector3d lever = state.Q.conjugate() * normal_.cross(Omega);  // n . (Omega x r) = (n x Omega) . r
    for (Index k = 0; k < n_; ++k) rate_[k] += lever.dot(place(reach_[k]));
  }

  void push(const VectorXd& s, VectorXd& f_s, MatrixXd& H) override {
    const PenaltyLaw& law = contact_.law;
    deform(s);
    for (Index k = 0; k < n_; ++k) {
      const double damped = 1 - law.damping * rate_[k];
      const bool presses = deformed_[k] < 0 && damped > 0;
      const auto [elastic, by_gap] = presses ? layer(law, deformed_[k]) : Layer{0, 0};
      const double area = contact_.samples.w[reach_[k]] * damped;
      force_[k] = area * elastic;
      slope_[k] = -area * by_gap;
    }
    const auto rows = static_rows_.topRows(n_);
    pushing_.topRows(n_) = slope_.head(n_).asDiagonal() * rows;
    f_s.noalias() += rows.transpose() * force_.head(n_);
    H.noalias() += pushing_.topRows(n_).transpose().lazyProduct(rows);
  }

  bool covers(const VectorXd& s) override { return reach_.covers(s); }

  void act(const VectorXd& s, ContactLoad& load) override {
    const PenaltyLaw& law = contact_.law;
    deform(s);
    Index n_pressing = 0;
    Vector3d moment = Vector3d::Zero();  // sum f_i r_i, body frame
    for (Index k = 0; k < n_; ++k) {
      const double gap = deformed_[k];
      load.least_gap = std::min(load.least_gap, gap);
      force_[k] = 0;
      if (!(gap < 0)) continue;
      ++n_pressing;
      const Index i = reach_[k];
      const double damped = std::max(0.0, 1 - law.damping * rate_[k]);
      const double elastic = contact_.samples.w[i] * layer(law, gap).pressure;
      force_[k] = elastic * damped;
      load.stored += contact_.samples.w[i] * stored_energy(law, gap);
      load.dissipation += elastic * (1 - damped) * rate_[k];
      if (body_.free) moment += force_[k] * place(i, s);
    }
    load.modal.noalias() += rows_.leftCols(n_) * force_.head(n_);
    load.force += force_.head(n_).sum() * normal_;
    load.torque += state_->Q * moment.cross(normal_in_body_);
    load.n_visited += n_;
    reach_.pressed(n_pressing);
  }

  void stiffen(const VectorXd& s, double rate, MatrixXd& K) override {
    const PenaltyLaw& law = contact_.law;
    const Index n_frame = body_.free ? 6 : 0, r = body_.n_modes();
    VectorXd G(K.rows()), G_rate(K.rows());  // by place and by rate: that of static shapes is left out
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      const double gap = gap_[k] + static_rows_.row(k).dot(s), damped = 1 - law.damping * rate_[k];
      if (!(gap < 0 && damped > 0)) continue;
      if (body_.free) {
        G.head<3>() = normal_;
        G.segment<3>(3) = (state_->Q * place(i, s)).cross(normal_);
        G_rate.head<3>() = normal_;
        G_rate.segment<3>(3) = (state_->Q * place(i)).cross(normal_);
      }
      G.segment(n_frame, r) = rows_.col(k);
      G.tail(s.size()) = static_rows_.row(k);
      G_rate.segment(n_frame, r) = rows_.col(k);
      G_rate.tail(s.size()).setZero();
      const auto [elastic, by_gap] = layer(law, gap);
      const double w = contact_.samples.w[i];
      K.noalias() -= w * by_gap * damped * G * G.transpose();
      if (law.damping > 0) K.noalias() += w * rate * elastic * law.damping * G * G_rate.transpose();
    }
  }

 private:
  Index n_samples() const { return contact_.samples.w.size(); }

  VectorXd gaps(const BodyState& state) const {
    VectorXd u = Phi_.transpose() * state.q;
    u.noalias() += Psi_.transpose() * state.s;
    const auto x = contact_.samples.X + u.reshaped(3, n_samples()).matrix();
    const double height = normal_.dot(state.c - contact_.surface.pose.position);
    return (x.transpose() * normal_in_body_).array() + height;
  }
  void deform(const VectorXd& s) {
    deformed_.head(n_).noalias() = static_rows_.topRows(n_) * s;
    deformed_.head(n_) += gap_.head(n_);
  }
  Vector3d place(Index i) const {  // without static shapes, whose rate is left out, too
    return contact_.samples.X.col(i) + Phi_.middleCols(3 * i, 3).transpose() * state_->q;
  }
  Vector3d place(Index i, const VectorXd& s) const {  // x - c in the body's axes
    return place(i) + Psi_.middleCols(3 * i, 3).transpose() * s;
  }

  void turn_to(const Vector3d& normal_in_body) {
    if (normal_in_body == normal_in_body_) return;
    normal_in_body_ = normal_in_body;
    n_gathered_ = 0;
  }
  // Rows of the samples in reach that are not known yet for this list and this orientation.
  void gather() {
    if (reach_.n_lists() != list_) list_ = reach_.n_lists(), n_gathered_ = 0;
    for (; n_gathered_ < n_; ++n_gathered_) {
      const Index i = reach_[n_gathered_];
      rows_.col(n_gathered_).noalias() = Phi_.middleCols(3 * i, 3) * normal_in_body_;
      static_rows_.row(n_gathered_).noalias() = normal_in_body_.transpose() * Psi_.middleCols(3 * i, 3).transpose();
      height_[n_gathered_] = normal_in_body_.dot(contact_.samples.X.col(i));
    }
  }

  const FloatingBody& body_;
  const SampledContact& contact_;
  Vector3d normal_, normal_in_body_ = Vector3d::Zero();
  Reach reach_;
  std::shared_ptr<const SampleTables> tables_;
  const MatrixXd &Phi_, &Psi_;      // r x 3 m, n_s x 3 m: what belongs to a sample stands together
  MatrixXd rows_;                   // r by place in the list
  MatrixXd static_rows_, pushing_;  // place by n_s; the latter times what forces lose with the gap
  VectorXd height_;                 // [m] n_b . X_i by place, as all that follows
  VectorXd gap_, rate_;             // but for the static shapes
  VectorXd deformed_, force_;       // [m] gap with them; [N]
  VectorXd slope_;                  // [N/m] what the force loses with the gap
  Index n_ = 0, n_gathered_ = 0;
  long list_ = 0;
  const BodyState* state_ = nullptr;
};

}  // namespace

std::unique_ptr<SampledPair> flat_pair(const FloatingBody& body, const SampledContact& contact) {
  return std::make_unique<FlatPair>(body, contact);
}

}  // namespace mb
