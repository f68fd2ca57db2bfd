#include "modal/contact/contact_pair.h"
#include "modal/contact/reach.h"

namespace mb {

namespace {

//   gap_i = n . (c - a) + n_b . X_i + (n_b^T Phi_i) q + (n_b^T Psi_i) s,    n_b = Q^T n,   a a point of the plane
class FlatPair final : public ContactPair {
 public:
  FlatPair(const FloatingBody& body, const SampledContact& contact)
      : body_(body),
        contact_(contact),
        normal_(contact.surface.pose.orientation * Vector3d::UnitZ()),
        reach_(contact),
        Phi_(contact.samples.Phi.transpose()),
        Psi_(contact.samples.Psi.transpose()),
        rows_(Phi_.rows(), contact.samples.w.size()),
        static_rows_(Psi_.rows(), contact.samples.w.size()),
        known_(static_cast<size_t>(contact.samples.w.size()), 0),
        gap_(contact.samples.w.size()),
        rate_(contact.samples.w.size()) {}

  void look(const BodyState& state, const Vector3d& Omega) override {
    state_ = &state;
    turn_to(state.Q.conjugate() * normal_);
    n_ = reach_.n_reachable(state, [&] { return gaps(state); });
    const double height = normal_.dot(state.c - contact_.surface.pose.position), climb = normal_.dot(state.v);
    const bool rated = contact_.law.damping > 0;
    const Vector3d lever = state.Q.conjugate() * normal_.cross(Omega);  // n . (Omega x r) = (n x Omega) . r
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      require_row(i);
      const auto row = rows_.col(i);
      gap_[k] = height + normal_in_body_.dot(contact_.samples.X.col(i)) + row.dot(state.q);
      if (rated) rate_[k] = climb + row.dot(state.p) + (Omega.isZero(0) ? 0 : lever.dot(place(i)));
    }
    if (!rated) rate_.head(n_).setZero();
  }

  void push(const VectorXd& s, VectorXd& f_s, MatrixXd& H) override {
    const PenaltyLaw& law = contact_.law;
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      const double gap = gap_[k] + static_rows_.col(i).dot(s), damped = 1 - law.damping * rate_[k];
      if (!(gap < 0 && damped > 0)) continue;
      const auto [elastic, by_gap] = layer(law, gap);
      const double area = contact_.samples.w[i] * damped;
      f_s.noalias() += (area * elastic) * static_rows_.col(i);
      H.noalias() -= (area * by_gap) * static_rows_.col(i) * static_rows_.col(i).transpose();
    }
  }

  bool covers(const VectorXd& s) override { return reach_.covers(s); }

  void act(const VectorXd& s, ContactLoad& load) override {
    const PenaltyLaw& law = contact_.law;
    double sum = 0;
    Index n_pressing = 0;
    Vector3d moment = Vector3d::Zero();  // sum f_i r_i, body frame
    for (Index k = 0; k < n_; ++k) {
      const Index i = reach_[k];
      const double gap = gap_[k] + static_rows_.col(i).dot(s);
      load.least_gap = std::min(load.least_gap, gap);
      if (!(gap < 0)) continue;
      ++n_pressing;
      const double damped = std::max(0.0, 1 - law.damping * rate_[k]);
      const double elastic = contact_.samples.w[i] * layer(law, gap).pressure, f = elastic * damped;
      load.stored += contact_.samples.w[i] * stored_energy(law, gap);
      load.dissipation += elastic * (1 - damped) * rate_[k];
      sum += f;
      load.modal.noalias() += f * rows_.col(i);
      if (body_.free) moment += f * place(i, s);
    }
    load.force += sum * normal_;
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
      const double gap = gap_[k] + static_rows_.col(i).dot(s), damped = 1 - law.damping * rate_[k];
      if (!(gap < 0 && damped > 0)) continue;
      if (body_.free) {
        G.head<3>() = normal_;
        G.segment<3>(3) = (state_->Q * place(i, s)).cross(normal_);
        G_rate.head<3>() = normal_;
        G_rate.segment<3>(3) = (state_->Q * place(i)).cross(normal_);
      }
      G.segment(n_frame, r) = rows_.col(i);
      G.tail(s.size()) = static_rows_.col(i);
      G_rate.segment(n_frame, r) = rows_.col(i);
      G_rate.tail(s.size()).setZero();
      const auto [elastic, by_gap] = layer(law, gap);
      const double w = contact_.samples.w[i];
      K.noalias() -= w * by_gap * damped * G * G.transpose();
      if (law.damping > 0) K.noalias() += w * rate * elastic * law.damping * G * G_rate.transpose();
    }
  }

 private:
  VectorXd gaps(const BodyState& state) {
    const double height = normal_.dot(state.c - contact_.surface.pose.position);
    VectorXd all(contact_.samples.w.size());
    for (Index i = 0; i < all.size(); ++i) {
      require_row(i);
      all[i] = height + normal_in_body_.dot(contact_.samples.X.col(i)) + rows_.col(i).dot(state.q) +
               static_rows_.col(i).dot(state.s);
    }
    return all;
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
    ++turn_;
  }
  void require_row(Index i) {
    if (known_[static_cast<size_t>(i)] == turn_) return;
    rows_.col(i).noalias() = Phi_.middleCols(3 * i, 3) * normal_in_body_;
    static_rows_.col(i).noalias() = Psi_.middleCols(3 * i, 3) * normal_in_body_;
    known_[static_cast<size_t>(i)] = turn_;
  }

  const FloatingBody& body_;
  const SampledContact& contact_;
  Vector3d normal_, normal_in_body_ = Vector3d::Zero();
  Reach reach_;
  MatrixXd Phi_, Psi_;           // r x 3 m, n_s x 3 m: what belongs to a sample stands together
  MatrixXd rows_, static_rows_;  // n_b^T Phi_i, n_b^T Psi_i as columns, known for this turn
  std::vector<long> known_;
  long turn_ = 0;
  VectorXd gap_, rate_;  // of the samples in reach, in their order
  Index n_ = 0;
  const BodyState* state_ = nullptr;
};

}  // namespace

std::unique_ptr<ContactPair> flat_pair(const FloatingBody& body, const SampledContact& contact) {
  return std::make_unique<FlatPair>(body, contact);
}

}  // namespace mb
