#include "mechanics/contact/contact_record.h"

#include <algorithm>

namespace mb {

const ContactSum& ContactRecord::add(double t, const VectorXd& u, const VectorXd& v) {
  add(t, forces_(forces_.gather(u), forces_.gather(v), f_));
  return last_;
}

void ContactRecord::add(double t, const ContactSum& now) {
  Moment moment{t, Vector3d::Zero(), 0};
  if (moments_.empty() && forces_.meet()) log_.meet(t);
  if (!moments_.empty()) {
    const Moment& before = moments_.back();
    const double half = (t - before.t) / 2;
    moment.impulse = before.impulse + half * (last_.force + now.force);
    moment.dissipated = before.dissipated + half * (last_.dissipation + now.dissipation);
  }
  log_.add({t, now.least_gap, now.force, moment.impulse});
  moments_.push_back(moment);
  last_ = now;
}

ContactHistory ContactRecord::history(const VectorXd& times, const MatrixXd& u, const MatrixXd& v,
                                      Index n_valid) const {
  const Index n_t = times.size();
  ContactHistory all{Matrix3Xd::Zero(3, n_t), Matrix3Xd::Zero(3, n_t), VectorXd::Zero(n_t), VectorXd::Zero(n_t),
                     log_.touches()};
  VectorXd f;
  for (Index k = 0; k < n_valid; ++k) {
    const ContactSum sum = forces_(forces_.gather(u.col(k)), forces_.gather(v.col(k)), f);
    all.force.col(k) = sum.force;
    all.stored[k] = sum.stored;
    auto next = std::ranges::lower_bound(moments_, times[k], {}, &Moment::t);
    if (next == moments_.end()) next = std::prev(moments_.end());
    const auto before = next == moments_.begin() ? next : std::prev(next);
    const double x = next == before ? 0 : std::min(1.0, (times[k] - before->t) / (next->t - before->t));
    all.impulse.col(k) = (1 - x) * before->impulse + x * next->impulse;
    all.dissipated[k] = (1 - x) * before->dissipated + x * next->dissipated;
  }
  return all;
}

}  // namespace mb
